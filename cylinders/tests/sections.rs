//! Cross-section solvers: exact tangents give the circle in any coordinates, and invalid lines give
//! errors.

#[path = "../examples/section_accuracy/cross_section.rs"]
mod cross_section;
#[path = "../examples/make_scene/random.rs"]
mod random;

use std::f64::consts::TAU;

use cross_section::{cross_section, relative_error, three_of_three};
use eliminant_cylinders::rectify::TangentLine;
use eliminant_cylinders::{
    Circle, CircleError, ClosedForm, LeastSquares, LinearConic, Minimal, Navab, Section, SectionError, SectionLine,
    SectionShape, SectionSolver, minimal_circles, tangent_circles,
};
use nalgebra::{Matrix2, Point2, Rotation2, Vector2};
use random::Random;

/// Methods for exactly three lines.
const THREE_LINES: [&dyn SectionSolver; 2] = [&ClosedForm, &Minimal];

/// Methods for any number of lines.
const MANY_LINES: [&dyn SectionSolver; 3] = [&LeastSquares, &LinearConic, &Navab];

/// The tangent of a circle whose normal has this angle.
fn tangent(circle: &Circle, angle: f64) -> TangentLine {
    let normal = Vector2::new(angle.cos(), angle.sin());
    TangentLine { normal, offset: circle.radius - normal.dot(&circle.centre.coords) }
}

/// Lines of weight one, two in each view.
fn section_lines(lines: &[TangentLine]) -> Vec<SectionLine> {
    lines.iter().enumerate().map(|(index, &line)| SectionLine { line, weight: 1.0, view: index / 2 }).collect()
}

fn tangents<const N: usize>(circle: &Circle, angles: [f64; N]) -> Vec<SectionLine> {
    section_lines(&angles.map(|angle| tangent(circle, angle)))
}

/// Smallest relative error among the circles that a method returns.
fn error(solver: &dyn SectionSolver, lines: &[SectionLine], truth: &Circle) -> f64 {
    let sections = solver.solve(lines).unwrap_or_else(|error| panic!("{}: {error}", solver.name()));
    let circles = sections.iter().filter_map(Section::circle);
    circles.map(|circle| relative_error(&circle, truth)).fold(f64::INFINITY, f64::min)
}

#[test]
fn exact_tangents_give_the_circle() {
    for solver in THREE_LINES.into_iter().chain(MANY_LINES) {
        let mut random = Random::new(12);
        let three = solver.least_lines() == 3 && solver.name() != LeastSquares.name();
        let mut errors: Vec<f64> = (0..10_000)
            .map(|_| {
                let (circle, lines) =
                    if three { three_of_three(&mut random) } else { cross_section(10, 0.0, &mut random) };
                error(solver, &lines, &circle)
            })
            .collect();
        errors.sort_by(f64::total_cmp);
        let [median, p999] = [errors.len() / 2, errors.len() * 999 / 1000].map(|at| errors[at]);
        println!("{}: relative error: median {median:.1e}, 99.9 % {p999:.1e}", solver.name());
        assert!(median < 1e-12 && p999 < 1e-8, "{}: median {median:e}, 99.9 % {p999:e}", solver.name());
    }
}

/// The circles of two methods for three lines are the same set.
#[test]
fn closed_form_and_emitted_solver_agree() {
    let mut random = Random::new(13);
    let regular = [0.0, TAU / 3.0, 2.0 * TAU / 3.0].map(|angle| tangent(&random_circle(&mut random), angle));
    let triangles =
        (0..10_000).map(|_| [(); 3].map(|()| tangent(&random_circle(&mut random), random.uniform(0.0, TAU))));
    let mut gaps: Vec<f64> = std::iter::once(regular)
        .chain(triangles)
        .map(|lines| {
            let [closed, emitted] = [tangent_circles(&lines), minimal_circles(&lines)]
                .map(|circles| circles.unwrap_or_else(|error| panic!("{lines:?}: {error}")));
            assert_eq!(closed.len(), 4);
            let gap = |circle| emitted.iter().map(|other| relative_error(other, circle)).fold(f64::INFINITY, f64::min);
            closed.iter().map(gap).fold(0.0, f64::max)
        })
        .collect();
    assert!(gaps[0] < 1e-14, "regular triangle: {:e}", gaps[0]);
    gaps.sort_by(f64::total_cmp);
    let [median, p99] = [gaps.len() / 2, gaps.len() * 99 / 100].map(|at| gaps[at]);
    println!("largest relative difference of four circles: median {median:.1e}, 99 % {p99:.1e}");
    assert!(median < 1e-12 && p99 < 1e-8, "median {median:e}, 99 % {p99:e}");
}

/// Sections do not depend on rotation, shift and scale of the plane, or on the signs and the order
/// of the lines.
#[test]
fn coordinates_do_not_matter() {
    let mut random = Random::new(14);
    for instance in 0..200 {
        let (three, ten) = (cross_section(3, 1e-3, &mut random).1, cross_section(5, 1e-3, &mut random).1);
        let three: Vec<_> = three.into_iter().step_by(2).collect();
        let turn = Rotation2::new(random.uniform(0.0, TAU));
        let shift = Vector2::new(random.uniform(-30.0, 30.0), random.uniform(-30.0, 30.0));
        let scale = 10f64.powf(random.uniform(-3.0, 3.0));
        let moved = |line: &SectionLine| {
            let normal = turn * line.line.normal;
            let line_there = TangentLine { normal: -normal, offset: normal.dot(&shift) - scale * line.line.offset };
            SectionLine { line: line_there, weight: 3.0 * line.weight, view: 7 - line.view }
        };
        let cases = THREE_LINES.map(|solver| (solver, &three)).into_iter();
        for (solver, lines) in cases.chain(MANY_LINES.map(|solver| (solver, &ten))) {
            let there: Vec<_> = lines.iter().rev().map(moved).collect();
            let [here, there] = [lines, &there].map(|lines| {
                solver.solve(lines).unwrap_or_else(|error| panic!("{}, instance {instance}: {error}", solver.name()))
            });
            assert_eq!(here.len(), there.len(), "{}, instance {instance}", solver.name());
            for (here, there) in here.iter().zip(&there) {
                let place = format!("{}, instance {instance}: {here:?}, {there:?}", solver.name());
                let expected = turn * here.centre() * scale + shift;
                let size = here.circle().map_or(1.0, |circle| circle.radius).max(here.centre().coords.norm());
                assert!((there.centre() - expected).norm() <= 1e-7 * scale * size, "{place}");
                if let (Some(here), Some(there)) = (here.circle(), there.circle()) {
                    assert!((there.radius - scale * here.radius).abs() <= 1e-7 * scale * here.radius, "{place}");
                }
                assert_eq!(std::mem::discriminant(&here.shape), std::mem::discriminant(&there.shape), "{place}");
            }
        }
    }
}

/// The dual conic agrees with its shape: centre, axes and tangents.
#[test]
fn dual_conics_belong_to_their_circles() {
    let mut random = Random::new(15);
    for _ in 0..100 {
        let (circle, lines) = cross_section(5, 0.0, &mut random);
        for solver in MANY_LINES {
            let section = solver.solve(&lines).expect("a section")[0];
            let conic = section.dual_conic;
            let centre = circle.centre.coords;
            let block = Matrix2::identity() * circle.radius * circle.radius - centre * centre.transpose();
            assert!((conic.fixed_view::<2, 2>(0, 0) - block).norm() < 1e-11, "{}", solver.name());
            assert!((conic.fixed_view::<2, 1>(0, 2) + centre).norm() < 1e-12, "{}", solver.name());
            assert!((conic - conic.transpose()).norm() < 1e-13 && conic[(2, 2)] == -1.0, "{}", solver.name());
            assert!(section.cost < 1e-20, "{}: {}", solver.name(), section.cost);
        }
    }
}

/// The lines `n^T p = +-sqrt(n^T M n)` touch the conic of the matrix `M`.
#[test]
fn linear_conic_says_what_it_is() {
    let conic = |m: [f64; 3], angles: [f64; 6]| {
        let lines = angles.map(|angle| {
            let normal = Vector2::new(angle.cos(), angle.sin());
            let square = m[0] * normal.x * normal.x + 2.0 * m[1] * normal.x * normal.y + m[2] * normal.y * normal.y;
            assert!(square > 0.0, "no real tangent at {angle}");
            TangentLine { normal, offset: -square.sqrt() - 2.0 * normal.x }
        });
        LinearConic.solve(&section_lines(&lines)).expect("a conic")[0]
    };
    let all_around = [0.1, 1.0, 2.2, 3.3, 4.0, 5.5];
    let ellipse = conic([4.0, 0.0, 1.0], all_around);
    let SectionShape::Ellipse { semi_axes: [long, short] } = ellipse.shape else { panic!("{ellipse:?}") };
    assert!((long - 2.0).abs() < 1e-12 && (short - 1.0).abs() < 1e-12, "{ellipse:?}");
    assert!((ellipse.centre() - Point2::new(2.0, 0.0)).norm() < 1e-12, "{ellipse:?}");
    let circle = ellipse.circle().expect("the nearest circle");
    assert!((circle.radius - 2.5f64.sqrt()).abs() < 1e-12, "{circle:?}");

    let hyperbola = conic([4.0, 0.0, -1.0], [0.1, 0.5, -0.4, 3.3, 3.6, 2.9]);
    assert_eq!(hyperbola.shape, SectionShape::Hyperbola);
    assert_eq!(hyperbola.circle(), None);
}

/// Weights count like repetitions, and a line of weight zero does not count.
#[test]
fn weights_are_repetitions() {
    let mut random = Random::new(16);
    for _ in 0..100 {
        let (_, lines) = cross_section(6, 1e-2, &mut random);
        let weighted: Vec<_> =
            lines.iter().enumerate().map(|(index, line)| SectionLine { weight: (index % 3) as f64, ..*line }).collect();
        let repeated: Vec<_> = lines.iter().enumerate().flat_map(|(index, line)| vec![*line; index % 3]).collect();
        for solver in [&LeastSquares as &dyn SectionSolver, &LinearConic] {
            let [weighted, repeated] = [&weighted, &repeated].map(|lines| solver.solve(lines).expect("a section")[0]);
            assert!((weighted.centre() - repeated.centre()).norm() < 1e-9, "{}", solver.name());
            assert!((weighted.cost - repeated.cost).abs() < 1e-9 * repeated.cost, "{}", solver.name());
        }
    }
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
    for turn in (0..100).map(|step| 0.07 * step as f64) {
        let lines = [turn, turn + TAU / 2.0, turn + 1.0].map(|angle| tangent(&circle, angle));
        for solve in [tangent_circles, minimal_circles] {
            let circles = solve(&lines).expect("two circles");
            assert_eq!(circles.len(), 2, "{circles:?}");
            assert!(circles.iter().all(|found| (found.radius - 1.5).abs() < 1e-14));
            assert!(circles.iter().any(|found| (found.centre - circle.centre).norm() < 1e-14));
        }
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
    for solver in THREE_LINES.into_iter().chain(MANY_LINES) {
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
    let four = tangents(&circle, [0.1, 1.0, 2.0, 4.0]);
    for solver in THREE_LINES {
        assert_eq!(solver.solve(&four), Err(SectionError::TooManyLines { lines: 4, most: 3 }), "{}", solver.name());
    }
}

#[test]
fn lines_that_determine_no_circle_give_errors() {
    let circle = Circle { centre: Point2::new(3.0, 4.0), radius: 1.0 };
    let fails = |solver: &dyn SectionSolver, lines: &[SectionLine], expected: SectionError| {
        assert_eq!(solver.solve(lines), Err(expected), "{}", solver.name());
    };
    let [a, b] = [0.3, 1.7].map(|angle| tangent(&circle, angle));
    fails(&Minimal, &section_lines(&[a, b, a]), CircleError::Concurrent.into());
    fails(&ClosedForm, &section_lines(&[a, b, a]), CircleError::Concurrent.into());
    let parallel: Vec<_> = (0..6).map(|index| TangentLine { offset: index as f64, ..a }).collect();
    let concurrent = tangents(&Circle { radius: 0.0, ..circle }, [0.1, 0.6, 1.3, 1.9, 2.8, 5.0]);
    for solver in MANY_LINES {
        fails(solver, &section_lines(&parallel), CircleError::Parallel.into());
        fails(solver, &concurrent, CircleError::Concurrent.into());
    }
    fails(&LeastSquares, &section_lines(&[a, b, a, b, a]), CircleError::Concurrent.into());
    fails(&LinearConic, &section_lines(&[a, b, a, b, a]), CircleError::Concurrent.into());
    // Four distinct lines touch a whole family of conics.
    let [c, d] = [3.0, 4.4].map(|angle| tangent(&circle, angle));
    fails(&LinearConic, &section_lines(&[a, b, c, d, a, b]), SectionError::NotUnique);
    // Seen from the origin, tangents of the parabola y = x^2: (2 t, -1, -t^2).
    let parabola = [-2.0, -1.0, 0.3, 0.5, 1.0, 2.0].map(|t: f64| {
        let norm = (4.0 * t * t + 1.0).sqrt();
        TangentLine { normal: Vector2::new(2.0 * t, -1.0) / norm, offset: -t * t / norm }
    });
    fails(&LinearConic, &section_lines(&parabola), SectionError::CentreAtInfinity);

    fails(&Navab, &section_lines(&[a, a, b, b]), CircleError::Concurrent.into());
    let views = |views: [usize; 4]| {
        let lines = [a, b, c, d].into_iter().zip(views);
        lines.map(|(line, view)| SectionLine { line, weight: 1.0, view }).collect::<Vec<_>>()
    };
    fails(&Navab, &views([0, 1, 2, 3]), SectionError::TooFewPairs { pairs: 0 });
    fails(&Navab, &views([0, 0, 1, 2]), SectionError::TooFewPairs { pairs: 1 });
    fails(&Navab, &views([5, 0, 5, 5]), SectionError::NotAPair { view: 5, lines: 3 });
}
