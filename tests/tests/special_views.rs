//! Poses and targets as users have them: a camera that looks straight down, points in a plane or at
//! the corners of a square. Their data have structure, and rotations by a half turn are infinite in
//! some charts. No solver of a pose may lose a solution because of it.

use eliminant_tests::cases;
use eliminant_tests::fate::Fates;
use eliminant_tests::ground_truth::{Make, View, makers};

/// Problems and views.
type Exception = (&'static [&'static str], &'static [View], &'static str);

/// Where the truth is no isolated solution, and why.
const DEGENERATE: [Exception; 0] = [];

/// Where the true solution is lost, and why.
const LOST: [Exception; 0] = [];

fn is_among(exceptions: &[Exception], name: &str, view: View) -> bool {
    exceptions.iter().any(|(names, views, _)| names.contains(&name) && views.contains(&view))
}

#[test]
fn no_view_is_special() {
    let mut faults = Vec::new();
    for (maker, case) in makers().iter().zip(cases()) {
        let Make::KnownPoints(make) = maker.make else { continue };
        assert_eq!(maker.name, case.name);
        for view in View::ALL {
            let fates = Fates::of(maker, &case, |random| make(random, view));
            println!("{}, {view:?}: {fates:?}", case.name);
            let known = [&LOST[..], &DEGENERATE[..]].map(|exceptions| is_among(exceptions, case.name, view));
            if [fates.loses(), fates.is_degenerate()] != known {
                faults.push((case.name, view, fates));
            }
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
}
