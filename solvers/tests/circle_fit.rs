//! The circle of the cross-section: exact tangents give the circle, noisy ones the global minimum.

#[path = "../examples/make_scene/random.rs"]
mod random;

use std::f64::consts::TAU;

use eliminant_solvers::cylinder::circle::fit_circle;
use eliminant_solvers::cylinder::rectify::TangentLine;
use eliminant_solvers::cylinder::{Circle, CircleError};
use nalgebra::{Matrix3, Point2, Vector2, Vector3};
use random::Random;

/// Tangents of a circle at angles in `[start, start + range)`, on either side, with normal noise in the offset.
fn tangents(
    circle: &Circle,
    count: usize,
    start: f64,
    range: f64,
    noise: f64,
    random: &mut Random,
) -> Vec<TangentLine> {
    let tangent = |_| {
        let angle = start + random.uniform(0.0, range);
        let normal = Vector2::new(angle.cos(), angle.sin());
        let side = if random.uniform(0.0, 1.0) < 0.5 { -1.0 } else { 1.0 };
        let offset = side * circle.radius - normal.dot(&circle.centre.coords) + noise * random.normal();
        TangentLine { normal, offset }
    };
    (0..count).map(tangent).collect()
}

fn random_circle(random: &mut Random) -> Circle {
    let centre = Point2::new(random.uniform(0.0, 10.0), random.uniform(0.0, 10.0));
    Circle { centre, radius: random.uniform(1.0, 2.0) }
}

#[test]
fn exact_tangents_give_the_circle() {
    let mut random = Random::new(1);
    let mut errors: Vec<f64> = (0..10_000)
        .map(|index| {
            let circle = random_circle(&mut random);
            let lines = tangents(&circle, 20, 0.0, TAU, 0.0, &mut random);
            let fit = fit_circle(&lines, 10.0).unwrap_or_else(|error| panic!("instance {index}: {error}"));
            let centre = (fit.circle.centre - circle.centre).norm() / circle.centre.coords.norm();
            centre.max((fit.circle.radius - circle.radius).abs() / circle.radius)
        })
        .collect();
    errors.sort_by(f64::total_cmp);
    let [median, p999, worst] = [errors.len() / 2, errors.len() * 999 / 1000, errors.len() - 1].map(|at| errors[at]);
    println!("relative error: median {median:.1e}, 99.9 % {p999:.1e}, worst {worst:.1e}");
    assert!(median < 1e-13 && p999 < 1e-11 && worst < 1e-9, "median {median:e}, 99.9 % {p999:e}, worst {worst:e}");
}

/// Sides of regular polygons: some of the nine stationary points are at infinity, and the point nearest to all lines is the
/// centre itself, so that both of its coordinates vanish after the normalisation. With a little noise it is nearly so.
#[test]
fn symmetric_tangents_give_the_circle() {
    let circle = Circle { centre: Point2::new(3.0, -1.0), radius: 1.5 };
    let mut random = Random::new(4);
    for count in 4..40 {
        for turn in [0.0, 0.3, 0.25 * TAU] {
            for noise in [0.0, 1e-15, 1e-13, 1e-11, 1e-9, 1e-7, 1e-5, 1e-3] {
                let lines: Vec<_> = (0..count)
                    .map(|index| {
                        let angle = turn + TAU * index as f64 / count as f64 + noise * random.normal();
                        let normal = Vector2::new(angle.cos(), angle.sin());
                        let offset = circle.radius - normal.dot(&circle.centre.coords) + noise * random.normal();
                        TangentLine { normal, offset }
                    })
                    .collect();
                let place = format!("{count} lines turned by {turn}, noise {noise:e}");
                let fit = fit_circle(&lines, 10.0).unwrap_or_else(|error| panic!("{place}: {error}"));
                let error = (fit.circle.centre - circle.centre).norm().max((fit.circle.radius - circle.radius).abs());
                assert!(error <= 1e-13 + 6.0 * noise, "{place}: off by {error:e}");
            }
        }
    }
}

/// Sum of `(s - h^2)^2` over the lines, with its gradient and Gauss-Newton matrix; unknowns `x, y, s` with `s = r^2`.
fn cost(lines: &[TangentLine], unknowns: &Vector3<f64>) -> (f64, Vector3<f64>, Matrix3<f64>) {
    let mut sum = (0.0, Vector3::zeros(), Matrix3::zeros());
    for line in lines {
        let distance = line.distance(&Point2::new(unknowns[0], unknowns[1]));
        let residual = unknowns[2] - distance * distance;
        let derivative = Vector3::new(-2.0 * distance * line.normal.x, -2.0 * distance * line.normal.y, 1.0);
        sum.0 += residual * residual;
        sum.1 += derivative * residual;
        sum.2 += derivative * derivative.transpose();
    }
    sum
}

/// Levenberg-Marquardt from one start.
fn descend(lines: &[TangentLine], mut unknowns: Vector3<f64>) -> f64 {
    let (mut best, mut gradient, mut matrix) = cost(lines, &unknowns);
    let mut damping = 1e-3;
    for _ in 0..200 {
        let damped = matrix + Matrix3::identity() * damping * matrix.trace();
        let Some(step) = damped.lu().solve(&gradient) else { break };
        let (value, next_gradient, next_matrix) = cost(lines, &(unknowns - step));
        if value < best {
            unknowns -= step;
            (best, gradient, matrix) = (value, next_gradient, next_matrix);
            damping *= 0.1;
        } else {
            damping *= 10.0;
        }
        if damping > 1e12 {
            break;
        }
    }
    best
}

#[test]
fn noisy_tangents_give_the_global_minimum() {
    let mut random = Random::new(2);
    for instance in 0..1000 {
        let circle = random_circle(&mut random);
        // From four to twenty lines; from a narrow view to all around; up to gross noise.
        let count = random.uniform(4.0, 21.0) as usize;
        let (start, range) = (random.uniform(0.0, TAU), random.uniform(0.5, TAU));
        let noise = 10f64.powf(random.uniform(-4.0, -0.5));
        let lines = tangents(&circle, count, start, range, noise, &mut random);
        let fit = fit_circle(&lines, 10.0).unwrap_or_else(|error| panic!("instance {instance}: {error}"));
        let Circle { centre, radius } = fit.circle;
        let (found, ..) = cost(&lines, &Vector3::new(centre.x, centre.y, radius * radius));
        let starts = (0..200).map(|_| {
            let [x, y] = [circle.centre.x, circle.centre.y].map(|centre| centre + random.uniform(-8.0, 8.0));
            descend(&lines, Vector3::new(x, y, random.uniform(0.0, 9.0)))
        });
        let best = starts.fold(f64::INFINITY, f64::min);
        // Near an exact fit the cost is the square of residuals with few digits of their own.
        let rounding = 1e-14 * (best * count as f64).sqrt();
        assert!(
            found <= best * (1.0 + 1e-9) + rounding,
            "instance {instance}: cost {found:e}, descent reaches {best:e}"
        );
    }
}

#[test]
fn bad_lines_give_errors() {
    let circle = Circle { centre: Point2::new(3.0, 4.0), radius: 1.0 };
    let good = tangents(&circle, 6, 0.0, TAU, 0.0, &mut Random::new(3));

    let with = |index: usize, line: TangentLine| {
        let mut lines = good.clone();
        lines[index] = line;
        fit_circle(&lines, 10.0)
    };
    for offset in [f64::NAN, f64::INFINITY, 1e200] {
        assert_eq!(with(2, TangentLine { offset, ..good[2] }), Err(CircleError::OutOfRange));
    }
    let normal = Vector2::new(f64::NAN, 0.0);
    assert_eq!(with(0, TangentLine { normal, ..good[0] }), Err(CircleError::OutOfRange));
    assert_eq!(fit_circle(&[good[0], good[0], good[0]], 10.0), Err(CircleError::Parallel));
    assert_eq!(fit_circle(&[good[0], good[1], good[0]], 10.0), Err(CircleError::Concurrent));

    // A triangle has an incircle and three excircles.
    let triangle = [0.1, 2.0, 4.5].map(|angle: f64| {
        let normal = Vector2::new(angle.cos(), angle.sin());
        TangentLine { normal, offset: circle.radius - normal.dot(&circle.centre.coords) }
    });
    assert_eq!(fit_circle(&triangle, 10.0), Err(CircleError::Ambiguous { circles: 4 }));
    let regular = [0, 1, 2].map(|third| {
        let normal = Vector2::new((TAU * third as f64 / 3.0).cos(), (TAU * third as f64 / 3.0).sin());
        TangentLine { normal, offset: circle.radius - normal.dot(&circle.centre.coords) }
    });
    assert_eq!(fit_circle(&regular, 10.0), Err(CircleError::Ambiguous { circles: 4 }));
}
