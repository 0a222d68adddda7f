//! The circle of the cross-section: exact tangents give the circle, noisy ones the global minimum.

#[path = "../examples/make_scene/random.rs"]
mod random;

use std::f64::consts::TAU;

use eliminant_cylinders::circle::{fit_circle, fit_circle_in_front};
use eliminant_cylinders::rectify::TangentLine;
use eliminant_cylinders::{Circle, CircleError, LeastSquares, SectionLine, SectionSolver, Sight};
use nalgebra::{Matrix2, Matrix6, Matrix6x2, Point2, Vector2, Vector6};
use random::Random;

/// Tangents of a circle at angles in `[start, start + range)`, on either side, with normal noise in
/// the offset.
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

/// Sides of regular polygons: some of the nine stationary points are at infinity, and the point
/// nearest to all lines is the centre itself, so that both of its coordinates vanish after the
/// normalisation. With a little noise this holds approximately.
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

/// The cost of the best circle about a centre `p`, as a quartic: `m^T K m` with the monomials
/// `m = (x^2, x y, x, y^2, y, 1)` of `p - origin` and the weighted covariance `K` of the
/// coefficients of the squared distances.
struct Quartic {
    origin: Point2<f64>,
    matrix: Matrix6<f64>,
}

impl Quartic {
    fn new(lines: &[SectionLine], origin: Point2<f64>) -> Self {
        let total: f64 = lines.iter().map(|line| line.weight).sum();
        let (mut mean, mut square) = (Vector6::zeros(), Matrix6::zeros());
        for SectionLine { line, weight, .. } in lines {
            let (a, b, c) = (line.normal.x, line.normal.y, line.distance(&origin));
            let row = Vector6::from([a * a, 2.0 * a * b, 2.0 * a * c, b * b, 2.0 * b * c, c * c]);
            mean += row * (weight / total);
            square += row * row.transpose() * (weight / total);
        }
        Self { origin, matrix: square - mean * mean.transpose() }
    }

    /// Value, gradient and Hessian.
    fn at(&self, at: &Vector2<f64>) -> (f64, Vector2<f64>, Matrix2<f64>) {
        let (x, y) = (at.x, at.y);
        let monomials = Vector6::from([x * x, x * y, x, y * y, y, 1.0]);
        let derivatives = Matrix6x2::from_columns(&[
            [2.0 * x, y, 1.0, 0.0, 0.0, 0.0].into(),
            [0.0, x, 0.0, 2.0 * y, 1.0, 0.0].into(),
        ]);
        let image = self.matrix * monomials;
        let curvature = Matrix2::new(2.0 * image[0], image[1], image[1], 2.0 * image[3]);
        let gradient = derivatives.tr_mul(&image) * 2.0;
        let hessian = (derivatives.tr_mul(&(self.matrix * derivatives)) + curvature) * 2.0;
        (monomials.dot(&image), gradient, hessian)
    }

    /// Levenberg-Marquardt from one start: Newton steps, damped until the cost falls.
    fn descend(&self, mut at: Vector2<f64>) -> Vector2<f64> {
        let (mut value, mut gradient, mut hessian) = self.at(&at);
        let mut damping = 0.0;
        for _ in 0..100 {
            let damped = hessian + Matrix2::identity() * damping;
            let smaller = 1e-3 * (hessian.trace().abs() + hessian.norm());
            if damped.determinant() <= 0.0 || damped.trace() <= 0.0 {
                damping = (damping * 4.0).max(smaller);
                continue;
            }
            let step = damped.try_inverse().unwrap_or_else(Matrix2::zeros) * gradient;
            let next = self.at(&(at - step));
            if next.0 < value {
                at -= step;
                (value, gradient, hessian) = next;
                damping = if damping > smaller { damping * 0.1 } else { 0.0 };
            } else {
                damping = (damping * 4.0).max(smaller);
            }
            if step.norm() < 1e-10 {
                break;
            }
        }
        at
    }
}

/// Weighted mean of `(r^2 - h^2)^2` with the best radius about a centre, on the lines.
fn cost(lines: &[SectionLine], centre: &Point2<f64>) -> f64 {
    let total: f64 = lines.iter().map(|line| line.weight).sum();
    let mean = |value: &dyn Fn(f64) -> f64| {
        lines.iter().map(|line| line.weight / total * value(line.line.distance(centre).powi(2))).sum::<f64>()
    };
    let square = mean(&|squared| squared);
    mean(&|squared| (squared - square).powi(2))
}

/// Standard deviation of normal noise, from negligible to gross.
fn random_noise(random: &mut Random) -> f64 {
    10f64.powf(random.uniform(-4.0, -0.5))
}

/// Starts of the descents in one scene.
const STARTS: usize = 200;

/// Compares the first section of `LeastSquares` with the best of many descents. Returns whether the
/// descents reached the same cost; otherwise they cannot serve as a reference.
fn check_global_minimum(lines: &[SectionLine], near: &Point2<f64>, place: &str, random: &mut Random) -> bool {
    let found = LeastSquares.solve(lines).unwrap_or_else(|error| panic!("{place}: {error}"));
    let found = found[0].cost;
    let quartic = Quartic::new(lines, *near);
    let ends = (0..STARTS).map(|_| {
        let at = quartic.descend(Vector2::new(random.uniform(-8.0, 8.0), random.uniform(-8.0, 8.0)));
        cost(lines, &(quartic.origin + at))
    });
    let best = ends.fold(f64::INFINITY, f64::min);
    // Near an exact fit the cost is the square of residuals that have only a few digits.
    let rounding = 1e-14 * best.sqrt();
    assert!(found <= best * (1.0 + 1e-9) + rounding, "{place}: cost {found:e}, descent reaches {best:e}");
    best <= found * (1.0 + 1e-9) + rounding
}

#[test]
fn noisy_tangents_give_the_global_minimum() {
    let mut random = Random::new(2);
    let mut reached = 0;
    for instance in 0..10_000 {
        let circle = random_circle(&mut random);
        // The scenes have four to twenty lines, from a narrow range to all directions. Every other
        // scene has equal weights.
        let count = random.uniform(4.0, 21.0) as usize;
        let (start, range) = (random.uniform(0.0, TAU), random.uniform(0.5, TAU));
        let noise = random_noise(&mut random);
        let lines = tangents(&circle, count, start, range, noise, &mut random);
        let weighted = lines.into_iter().map(|line| {
            let weight = if instance % 2 == 0 { 1.0 } else { random.uniform(0.1, 1.0) };
            SectionLine { line, weight, view: 0 }
        });
        let lines: Vec<_> = weighted.collect();
        let place = format!("instance {instance}");
        reached += usize::from(check_global_minimum(&lines, &circle.centre, &place, &mut random));
    }
    assert!(reached > 9_900, "the descents reach the minimum in {reached} of 10,000 scenes");
}

/// Sides of a parallelogram or a regular polygon at nearly equal distances: a few of the nine
/// stationary points are at infinity or near it, and others have equal coordinates.
#[test]
fn balanced_directions_give_the_global_minimum() {
    let mut random = Random::new(5);
    let mut reached = 0;
    for instance in 0..1_000 {
        let circle = random_circle(&mut random);
        let (start, noise, opening) = (random.uniform(0.0, TAU), random_noise(&mut random), random.uniform(0.5, 2.5));
        let unbalance = [0.0, 1e-12, 1e-8, 1e-4][instance % 4];
        let sides = random.uniform(3.0, 12.0) as usize;
        let angles: Vec<f64> = match sides {
            3 => [0.0, opening, TAU / 2.0, TAU / 2.0 + opening].into(),
            _ => (0..sides).map(|index| TAU * index as f64 / sides as f64).collect(),
        };
        let side = |angle: f64| {
            let angle = start + angle + unbalance * random.normal();
            let normal = Vector2::new(angle.cos(), angle.sin());
            let offset = circle.radius - normal.dot(&circle.centre.coords) + noise * random.normal();
            SectionLine { line: TangentLine { normal, offset }, weight: 1.0, view: 0 }
        };
        let lines: Vec<_> = angles.into_iter().map(side).collect();
        let place = format!("instance {instance}: {sides} sides, {unbalance:e} off balance");
        reached += usize::from(check_global_minimum(&lines, &circle.centre, &place, &mut random));
    }
    assert!(reached > 990, "the descents reach the minimum in {reached} of 1,000 scenes");
}

/// Two cameras on either side of a circle, and its silhouettes turned by noise. Often a circle
/// behind one of the cameras fits better.
#[test]
fn the_circle_in_front_of_the_cameras_is_taken_where_there_is_one() {
    let mut random = Random::new(6);
    let (mut behind, mut moved) = (0, 0);
    for instance in 0..2_000 {
        let circle = Circle { centre: Point2::new(0.0, 0.0), radius: 1.0 };
        let start = random.uniform(0.0, TAU);
        let (mut lines, mut sights) = (Vec::new(), Vec::new());
        for angle in [start, start + TAU / 2.0 + random.uniform(-0.2, 0.2)] {
            let camera = Point2::new(angle.cos(), angle.sin()) * random.uniform(10.0, 20.0);
            let half = (circle.radius / camera.coords.norm()).asin();
            for side in [half, -half] {
                let bearing = angle + TAU / 2.0 + side + 0.002 * random.normal();
                let ray = Vector2::new(bearing.cos(), bearing.sin());
                let normal = Vector2::new(-ray.y, ray.x);
                lines.push(TangentLine { normal, offset: -normal.dot(&camera.coords) });
                sights.push(Sight { camera, ray: Some(ray) });
            }
        }
        let in_front = |circle: &Circle| sights.iter().all(|sight| sight.has_in_front(circle));
        let best = fit_circle(&lines, 20.0).expect("a circle").circle;
        let chosen = fit_circle_in_front(&lines, &sights, 20.0).expect("a circle").circle;
        if in_front(&best) {
            assert_eq!(chosen, best, "instance {instance}");
        } else {
            behind += 1;
            // Except for saddle points, no stationary circle in front of the cameras costs less.
            let cost = |circle: &Circle| {
                let square = |line: &TangentLine| circle.radius.powi(2) - line.distance(&circle.centre).powi(2);
                lines.iter().map(|line| square(line).powi(2)).sum::<f64>()
            };
            moved += usize::from(chosen != best);
            assert!(chosen == best || (in_front(&chosen) && cost(&chosen) >= cost(&best)), "instance {instance}");
            assert!(chosen.centre.coords.norm() < 5.0 && chosen.radius < 3.0, "instance {instance}: {chosen:?}");
        }
    }
    assert!(behind > 10 && moved == behind, "{behind} {moved}");
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
