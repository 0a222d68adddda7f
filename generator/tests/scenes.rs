//! Scenes: what is drawn, what is known of its solution, and that no template depends on them.

use eliminant_generator::algebra::Random;
use eliminant_generator::problem::Problem;
use eliminant_generator::problem::scene::DrawnScene;

const LINES: &str = "
    /// Where two lines meet.
    fn meeting(normals: [[f64; 2]; 2], offsets: [f64; 2]) -> (x, y) {
        normals * [x, y] == offsets;
        Place { spot: [x, y], square: x * x + y * y }
    }
";

fn problem(scene: &str) -> Problem {
    Problem::parse("meeting.rs", &format!("{LINES}\n{scene}")).unwrap_or_else(|error| panic!("{error}"))
}

fn drawn(problem: &Problem, count: u64) -> Vec<DrawnScene> {
    let scene = problem.scene.as_ref().expect("it has a scene");
    (0..count).map(|seed| scene.draw(&mut Random::new(seed)).expect("drawn")).collect()
}

#[test]
fn the_solution_of_a_scene_solves_it() {
    let problem = problem(
        "#[scene]
        fn scene(#[unit] normals: [[f64; 2]; 2], place: [f64; 2]) -> (Data, Solution) {
            let [x, y] = 10 * place;
            (Data { offsets: normals * [x, y], normals }, Solution { y, x })
        }",
    );
    for DrawnScene { data, solution, results } in drawn(&problem, 50) {
        let [a, b, c, d, first, second] = data[..] else { panic!("{data:?}") };
        let [x, y] = solution.as_deref().expect("known")[..] else { panic!("{solution:?}") };
        assert!((a * a + b * b - 1.0).abs() < 1e-15 && (c * c + d * d - 1.0).abs() < 1e-15, "normals are unit vectors");
        assert!((a * x + b * y - first).abs() < 1e-13 && (c * x + d * y - second).abs() < 1e-13, "{data:?}");
        assert!(x.abs() <= 10.0 && results.is_none());
    }
}

#[test]
fn a_scene_is_drawn_again_until_its_inequalities_hold() {
    let problem = problem(
        "#[scene]
        fn scene(normals: [[f64; 2]; 2], place: [f64; 2]) -> (Data, Place) {
            det(normals) > 1 / 2;
            for x in place {
                sqrt(x + 1) > 1;
            }
            (Data { normals, offsets: normals * place }, Place { square: dot(place, place) })
        }",
    );
    for DrawnScene { data, results, .. } in drawn(&problem, 50) {
        assert!(data[0] * data[3] - data[1] * data[2] > 0.5, "{data:?}");
        let [None, None, Some(square)] = results.as_deref().expect("known")[..] else { panic!("{results:?}") };
        assert!(square > 0.0);
    }
}

#[test]
fn what_never_holds_gives_no_scene() {
    for never in ["place[0] > 2;", "place[0] < place[0];", "sqrt(place[0] - 2) > 0;"] {
        let text = format!(
            "#[scene]
            fn scene(normals: [[f64; 2]; 2], place: [f64; 2]) -> Data {{
                {never}
                Data {{ normals, offsets: normals * place }}
            }}"
        );
        let problem = problem(&text);
        let scene = problem.scene.as_ref().expect("it has a scene");
        assert!(!scene.has_truth());
        assert_eq!(scene.draw(&mut Random::new(1)), None, "{never}");
    }
}

/// A scene says nothing of what is solved: templates stay those of the problem.
#[test]
fn a_scene_does_not_change_the_fingerprint() {
    let plain = problem("");
    let with_scene = problem(
        "#[scene]
        fn scene(normals: [[f64; 2]; 2], offsets: [f64; 2]) -> Data {
            Data { normals, offsets }
        }",
    );
    assert!(plain.scene.is_none());
    assert_eq!(plain.fingerprint(), with_scene.fingerprint());
    assert_eq!(drawn(&with_scene, 3), drawn(&with_scene, 3), "the same numbers each time");
}
