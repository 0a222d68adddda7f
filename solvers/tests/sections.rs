//! Cross-section solvers: exact tangents give the circle, in any coordinates; bad lines give errors.

#[path = "../examples/make_scene/random.rs"]
mod random;

use std::f64::consts::TAU;

use eliminant_solvers::cylinder::rectify::TangentLine;
use eliminant_solvers::cylinder::{
    Circle, CircleError, ClosedForm, SectionError, SectionLine, SectionSolver, tangent_circles,
};
use nalgebra::{Point2, Vector2};
use random::Random;

/// Every method.
const SOLVERS: [&dyn SectionSolver; 1] = [&ClosedForm];

/// The tangent of a circle whose normal has this angle.
fn tangent(circle: &Circle, angle: f64) -> TangentLine {
    let normal = Vector2::new(angle.cos(), angle.sin());
    TangentLine { normal, offset: circle.radius - normal.dot(&circle.centre.coords) }
}

fn section_lines(lines: &[TangentLine]) -> Vec<SectionLine> {
    lines.iter().enumerate().map(|(index, &line)| SectionLine { line, weight: 1.0, view: index / 2 }).collect()
}

/// Centre in `[0, 10]^2`, radius in `[1, 2]`.
fn random_circle(random: &mut Random) -> Circle {
    let centre = Point2::new(random.uniform(0.0, 10.0), random.uniform(0.0, 10.0));
    Circle { centre, radius: random.uniform(1.0, 2.0) }
}

#[test]
fn four_circles_touch_three_lines() {
    let mut random = Random::new(11);
    for instance in 0..1000 {
        let lines = [(); 3].map(|()| {
            let radius = random.normal();
            tangent(&Circle { radius, ..random_circle(&mut random) }, random.uniform(0.0, TAU))
        });
        let circles = tangent_circles(&lines).unwrap_or_else(|error| panic!("instance {instance}: {error}"));
        assert_eq!(circles.len(), 4);
        for found in &circles {
            for line in &lines {
                let gap = (line.distance(&found.centre).abs() - found.radius).abs();
                assert!(gap <= 1e-10 * (10.0 + found.radius), "instance {instance}: {found:?} misses by {gap:e}");
            }
        }
    }
}

#[test]
fn two_circles_touch_a_pair_of_parallel_lines_and_a_third() {
    let circle = Circle { centre: Point2::new(3.0, -1.0), radius: 1.5 };
    for turn in [0.0, 0.1, 1.0, 4.0] {
        let lines = [turn, turn + TAU / 2.0, turn + 1.0].map(|angle| tangent(&circle, angle));
        let circles = tangent_circles(&lines).expect("two circles");
        assert_eq!(circles.len(), 2, "{circles:?}");
        assert!(circles.iter().all(|found| (found.radius - 1.5).abs() < 1e-14));
        assert!(circles.iter().any(|found| (found.centre - circle.centre).norm() < 1e-14));
    }
}

#[test]
fn three_lines_without_a_triangle_give_errors() {
    let circle = Circle { centre: Point2::new(3.0, -1.0), radius: 1.5 };
    let [a, b] = [0.3, 1.7].map(|angle| tangent(&circle, angle));
    let reversed = TangentLine { normal: -a.normal, offset: -a.offset };
    let shifted = |offset| TangentLine { normal: a.normal, offset: a.offset + offset };
    assert_eq!(tangent_circles(&[a, shifted(1.0), shifted(2.5)]), Err(CircleError::Parallel));
    assert_eq!(tangent_circles(&[a, a, a]), Err(CircleError::Parallel));
    for repeated in [[a, a, b], [a, b, a], [b, a, reversed]] {
        assert_eq!(tangent_circles(&repeated), Err(CircleError::Concurrent));
    }
    let concurrent = [0.1, 0.9, 2.0].map(|angle| tangent(&Circle { radius: 0.0, ..circle }, angle));
    assert_eq!(tangent_circles(&concurrent), Err(CircleError::Concurrent));
    let nan = TangentLine { offset: f64::NAN, ..a };
    assert_eq!(tangent_circles(&[a, b, nan]), Err(CircleError::OutOfRange));
}

#[test]
fn bad_lines_give_errors() {
    let circle = Circle { centre: Point2::new(3.0, 4.0), radius: 1.0 };
    for solver in SOLVERS {
        let least = solver.least_lines();
        let angles = (0..least).map(|index| 0.2 + 1.1 * index as f64);
        let good = section_lines(&angles.map(|angle| tangent(&circle, angle)).collect::<Vec<_>>());
        assert!(solver.solve(&good).is_ok(), "{}", solver.name());

        let few = Err(SectionError::TooFewLines { lines: least - 1, least });
        assert_eq!(solver.solve(&good[1..]), few, "{}", solver.name());
        let with = |change: fn(&mut SectionLine)| {
            let mut lines = good.clone();
            change(&mut lines[1]);
            solver.solve(&lines)
        };
        assert_eq!(with(|line| line.weight = 0.0), few, "{}", solver.name());
        let changes: [fn(&mut SectionLine); 4] = [
            |line| line.line.offset = f64::NAN,
            |line| line.line.offset = f64::INFINITY,
            |line| line.line.normal.x = f64::NAN,
            |line| line.line.normal *= 2.0,
        ];
        for change in changes {
            assert_eq!(with(change), Err(SectionError::BadLine { line: 1 }), "{}", solver.name());
        }
        let changes: [fn(&mut SectionLine); 2] = [|line| line.weight = f64::NAN, |line| line.weight = -1.0];
        for change in changes {
            assert_eq!(with(change), Err(SectionError::BadWeight { line: 1 }), "{}", solver.name());
        }
    }
    let four = section_lines(&[0.1, 1.0, 2.0, 4.0].map(|angle| tangent(&circle, angle)));
    assert_eq!(ClosedForm.solve(&four), Err(SectionError::TooManyLines { lines: 4, most: 3 }));
}
