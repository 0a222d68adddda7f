//! Files of pairs.

use two_view::Pair;
use two_view::scene::{SceneOptions, scene};

#[test]
fn pairs_are_read_back_exactly() {
    let options = SceneOptions { correspondences: [5, 20], ..SceneOptions::default() };
    let mut pairs: Vec<Pair> = (0..5).map(|number| scene(&options, number).pair).collect();
    pairs[1].truth = None;
    pairs[2].points.clear();
    let text: String = pairs.iter().map(Pair::to_text).collect();
    let mut found = Pair::read_all(&format!("# A comment.\n\n{text}")).unwrap();
    // A direction is made a unit vector again: the last digit may differ.
    for (found, pair) in found.iter_mut().zip(&mut pairs) {
        let [found, truth] = [found.truth.take(), pair.truth.take()];
        let errors = found.zip(truth).map(|(found, truth)| found.degrees_to(&truth));
        assert!(found.is_some() == truth.is_some() && errors.unwrap_or_default().iter().all(|error| *error < 1e-12));
    }
    assert_eq!(found, pairs);
    assert!(Pair::read_all("").unwrap().is_empty());
}

#[test]
fn mistakes_have_a_line_and_a_message() {
    let camera = "camera,900,900,600,450\n";
    let cases = [
        ("1,2,3,4\n".to_string(), 1, "`pair,NAME`"),
        ("pair,a\ncamera,1,2\n".to_string(), 2, "four numbers"),
        ("pair,a\ncamera,0,1,2,3\n".to_string(), 2, "above zero"),
        (format!("pair,a\n{camera}1,2,3,4\n"), 3, "two lines"),
        (format!("pair,a\n{camera}{camera}{camera}"), 4, "two lines"),
        (format!("pair,a\n{camera}{camera}truth,1\n"), 4, "twelve numbers"),
        (format!("pair,a\n{camera}{camera}1,2,x,4\n"), 4, "x1, y1, x2, y2"),
        (format!("pair,a\n{camera}{camera}nonsense\n"), 4, "commas"),
    ];
    for (text, line, message) in cases {
        let error = Pair::read_all(&text).unwrap_err();
        assert!(error.line == line && error.message.contains(message), "{text}: {error}");
    }
}
