//! Refinement: recovery, covariance against scatter, robust losses, invariance, refused input.

#[path = "../examples/make_scene/random.rs"]
mod random;
#[path = "../examples/make_scene/scene.rs"]
#[allow(dead_code, reason = "scene files are not written here")]
mod scene;
mod scenes;

use eliminant_cylinders::{
    Cylinder, DistanceUnit, Loss, Metric, MetricError, RefineError, RefineOptions, View, refine, triangulate,
};
use nalgebra::{Matrix3x4, Matrix5, Point3, Rotation3, SVector, Unit, Vector2, Vector3};
use random::Random;
use scene::{Can, Setup};
use scenes::{Motion, difference, disturbed, random_scene, truth, view, views, with_lines};

fn options(views: &[View]) -> RefineOptions {
    RefineOptions { metric: Metric::of(views), loss: Loss::Quadratic }
}

fn middle(can: &Can) -> Point3<f64> {
    can.base + can.direction.into_inner() * (can.height / 2.0)
}

#[test]
fn noise_free_lines_give_the_cylinder() {
    let mut random = Random::new(1);
    for unit in [DistanceUnit::Pixels, DistanceUnit::Radians] {
        let mut errors: Vec<f64> = (0..500)
            .map(|index| {
                let (can, setup) = random_scene(&mut random, 0.0);
                let views = views(&setup, &scene::photographs(&can, &setup, &mut random));
                let options = RefineOptions { metric: Metric { unit, ..Metric::of(&views) }, loss: Loss::Quadratic };
                let start = disturbed(&can, 0.1, &mut random);
                let result = refine(&views, &start, &options).unwrap_or_else(|error| panic!("scene {index}: {error}"));
                difference(&result.cylinder, &truth(&can), &middle(&can))
            })
            .collect();
        errors.sort_by(f64::total_cmp);
        let (median, worst) = (errors[errors.len() / 2], errors[errors.len() - 1]);
        println!("{unit:?}: relative error: median {median:.1e}, worst {worst:.1e}");
        assert!(median < 1e-13 && worst < 1e-11, "{unit:?}: median {median:e}, worst {worst:e}");
    }
}

/// The lines through two points at `+-half_length` of the point nearest to the principal point,
/// each moved by noise.
fn disturbed_lines(view: &View, setup: &Setup, half_length: f64, noise: f64, random: &mut Random) -> Vec<Vector3<f64>> {
    let calibration = view.camera().calibration().expect("a calibration");
    let principal = setup.calibration.column(2).xy();
    let line = |line: &Vector3<f64>| {
        let line = calibration.line_to_pixels(line);
        let line = line / line.xy().norm();
        let foot = principal - line.xy() * line.dot(&principal.push(1.0));
        let along = Vector2::new(-line.y, line.x) * half_length;
        let [near, far] = [foot - along, foot + along]
            .map(|point| point.push(1.0) + Vector3::new(random.normal(), random.normal(), 0.0) * noise);
        near.cross(&far)
    };
    view.lines().iter().map(line).collect()
}

#[test]
fn covariance_is_the_scatter() {
    let (can, setup) = (scene::soda_can(), Setup { noise: 0.0, cameras: 5, ..scene::soda_can_setup() });
    let photographs = scene::photographs(&can, &setup, &mut Random::new(2));
    let exact = views(&setup, &photographs);
    let reference = refine(&exact, &truth(&can), &options(&exact)).expect("a cylinder");
    let half_length = Metric::of(&exact).half_length * 3000.0;

    let mut random = Random::new(3);
    let runs = 2000;
    let (mut errors, mut covariance) = (Vec::new(), Matrix5::zeros());
    for _ in 0..runs {
        let noisy: Vec<_> = (exact.iter().zip(&photographs))
            .map(|(exact, photograph)| {
                view(&setup, &photograph.camera, &disturbed_lines(exact, &setup, half_length, 0.5, &mut random))
            })
            .collect();
        let result = refine(&noisy, &truth(&can), &options(&noisy)).expect("a cylinder");
        let [f1, f2] = reference.across;
        let turn = result.cylinder.direction.into_inner() - reference.cylinder.direction.into_inner();
        let at = reference.reference;
        let nearest = result.cylinder.axis_point
            + result.cylinder.direction.into_inner()
                * result.cylinder.direction.dot(&(at - result.cylinder.axis_point));
        let shift = nearest - at;
        let radius = result.cylinder.radius - can.radius;
        errors.push(SVector::from([f1.dot(&turn), f2.dot(&turn), f1.dot(&shift), f2.dot(&shift), radius]));
        covariance += result.covariance / runs as f64;
        assert!((result.deviation.radius - result.covariance[(4, 4)].sqrt()).abs() < 1e-15);
        let trace = result.covariance[(0, 0)] + result.covariance[(1, 1)];
        assert!((result.deviation.direction - trace.sqrt()).abs() < 1e-15);
    }
    // With the predicted covariance scaled to the identity, the entries of the mean and of the
    // scatter are off by their own sampling errors: four standard deviations are allowed for twenty
    // numbers.
    let factor = covariance.cholesky().expect("a covariance").l();
    let white: Vec<SVector<f64, 5>> =
        errors.iter().map(|error| factor.solve_lower_triangular(error).expect("a regular factor")).collect();
    let count = runs as f64;
    let mean = white.iter().sum::<SVector<f64, 5>>() / count;
    let scatter = white.iter().map(|error| error * error.transpose()).sum::<Matrix5<f64>>() / count;
    println!("mean {mean:.3}, scatter {scatter:.3}");
    for row in 0..5 {
        assert!(mean[row].abs() < 4.0 / count.sqrt(), "mean {mean}");
        for column in 0..5 {
            let (expected, variance) = if row == column { (1.0, 2.0) } else { (0.0, 1.0) };
            let off = (scatter[(row, column)] - expected).abs();
            assert!(off < 4.0 * (variance / count).sqrt(), "scatter {scatter}");
        }
    }
}

#[test]
fn refinement_is_better_than_least_squares_on_the_dual_conic() {
    let (can, setup) = (scene::soda_can(), Setup { cameras: 4, ..scene::soda_can_setup() });
    let (mut before, mut after) = (0.0, 0.0);
    for seed in 0..300 {
        let views = views(&setup, &scene::photographs(&can, &setup, &mut Random::new(seed)));
        let linear = triangulate(&views).expect("a cylinder").cylinder;
        let refined = refine(&views, &linear, &options(&views)).expect("a cylinder").cylinder;
        before += (linear.radius - can.radius).powi(2);
        after += (refined.radius - can.radius).powi(2);
    }
    let [before, after] = [before, after].map(|sum: f64| (sum / 300.0).sqrt());
    println!("root mean square error of the radius: {before:.4} before, {after:.4} after");
    assert!(after < before, "{before} before, {after} after");
}

#[test]
fn robust_losses_tone_down_a_wrong_line() {
    let (can, setup) = (scene::soda_can(), scene::soda_can_setup());
    let mut photographs = scene::photographs(&can, &setup, &mut Random::new(4));
    photographs[2].lines[1].z += 40.0;
    let views = views(&setup, &photographs);
    let error = |loss| {
        let options = RefineOptions { loss, ..options(&views) };
        (refine(&views, &truth(&can), &options).expect("a cylinder").cylinder.radius - can.radius).abs()
    };
    let quadratic = error(Loss::Quadratic);
    let huber = error(Loss::Huber { scale: 1.0 });
    let cauchy = error(Loss::Cauchy { scale: 1.0 });
    println!("radius error: {quadratic:.3} quadratic, {huber:.3} Huber, {cauchy:.3} Cauchy");
    assert!(huber < quadratic / 2.0 && cauchy < huber);
}

#[test]
fn the_world_frame_does_not_matter() {
    let mut random = Random::new(5);
    for _ in 0..100 {
        let (can, setup) = random_scene(&mut random, 0.5);
        let views = views(&setup, &scene::photographs(&can, &setup, &mut random));
        let original = refine(&views, &truth(&can), &options(&views)).expect("a cylinder");
        let motion = Motion::random(&mut random);
        let moved: Vec<_> = views.iter().map(|view| motion.view(view)).collect();
        let result = refine(&moved, &motion.cylinder(&truth(&can)), &options(&moved)).expect("a cylinder");
        let expected = motion.cylinder(&original.cylinder);
        let off = difference(&result.cylinder, &expected, &motion.point(&original.reference));
        assert!(off < 1e-7, "differs by {off:e}");
        let deviations = [
            (result.deviation.direction, original.deviation.direction),
            (result.deviation.position, original.deviation.position * motion.scale),
            (result.deviation.radius, original.deviation.radius * motion.scale),
        ];
        for (found, expected) in deviations {
            assert!((found - expected).abs() < 1e-6 * expected, "{found} instead of {expected}");
        }
    }
}

#[test]
fn order_and_signs_do_not_matter() {
    let mut random = Random::new(6);
    for _ in 0..100 {
        let (can, setup) = random_scene(&mut random, 0.5);
        let views = views(&setup, &scene::photographs(&can, &setup, &mut random));
        let original = refine(&views, &truth(&can), &options(&views)).expect("a cylinder");
        let flipped = |view: &View| with_lines(view, &[view.lines()[1] * -3.0, -view.lines()[0]]);
        let other: Vec<_> = views.iter().rev().map(flipped).collect();
        let start = Cylinder { direction: -can.direction, ..truth(&can) };
        let result = refine(&other, &start, &options(&other)).expect("a cylinder");
        let off = difference(&result.cylinder, &original.cylinder, &original.reference);
        assert!(off < 1e-7, "differs by {off:e}");
    }
}

// Refused input.

fn good() -> (Can, Vec<View>) {
    let (can, setup) = (scene::soda_can(), scene::soda_can_setup());
    let views = views(&setup, &scene::photographs(&can, &setup, &mut Random::new(7)));
    (can, views)
}

#[test]
fn options_and_starts_are_checked() {
    let (can, views) = good();
    let start = truth(&can);
    assert_eq!(refine(&views[..1], &start, &options(&views)), Err(RefineError::TooFewLines { lines: 2 }));
    for scale in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        for loss in [Loss::Huber { scale }, Loss::Cauchy { scale }] {
            let result = refine(&views, &start, &RefineOptions { loss, ..options(&views) });
            assert!(matches!(result, Err(RefineError::LossScale { .. })), "{result:?}");
        }
        let metric = Metric { half_length: scale, ..Metric::of(&views) };
        let result = refine(&views, &start, &RefineOptions { metric, ..options(&views) });
        assert!(matches!(result, Err(RefineError::Metric(MetricError::HalfLength { .. }))), "{result:?}");
    }
    for radius in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let result = refine(&views, &Cylinder { radius, ..start }, &options(&views));
        assert_eq!(result, Err(RefineError::NotACylinder));
    }
    let result = refine(&views, &Cylinder { radius: 1e4, ..start }, &options(&views));
    assert_eq!(result, Err(RefineError::CameraInside { view: 0 }));
}

#[test]
fn pixels_need_a_calibration() {
    let (can, mut views) = good();
    let metric = Metric::of(&views);
    views[2] = scenes::without_calibration(&views[2]);
    let result = refine(&views, &truth(&can), &RefineOptions { metric, loss: Loss::Quadratic });
    assert_eq!(result, Err(RefineError::Metric(MetricError::NoCalibration { view: 2 })));
    assert_eq!(Metric::of(&views).unit, DistanceUnit::Radians);
    assert!(refine(&views, &truth(&can), &options(&views)).is_ok());
}

#[test]
fn cameras_at_one_place_determine_no_cylinder() {
    let (can, views) = good();
    let repeated = vec![views[0].clone(); 4];
    assert_eq!(refine(&repeated, &truth(&can), &options(&repeated)), Err(RefineError::NotDetermined));
}

#[test]
fn images_of_the_axis_leave_no_radius() {
    let (can, views) = good();
    let axis = |view: &View| {
        let camera = view.camera();
        let [near, far] = [can.base, can.base + can.direction.into_inner()]
            .map(|point| camera.rotation() * point.coords + camera.translation());
        with_lines(view, &[near.cross(&far)])
    };
    let views: Vec<_> = views.iter().map(axis).collect();
    assert_eq!(refine(&views, &truth(&can), &options(&views)), Err(RefineError::NoRadius));
}

#[test]
fn a_camera_stays_outside() {
    // Seven lines touch the unit circle from cameras around it. One camera stands inside that
    // circle, and the best cylinder leaves it just outside.
    let look = |centre: Vector3<f64>, normal: Vector3<f64>| {
        let camera = Matrix3x4::from_columns(&[Vector3::x(), Vector3::y(), Vector3::z(), -centre]);
        let camera = eliminant_cylinders::Camera::from_normalised(&camera).expect("a camera");
        View::from_normalised_lines(camera, &[normal]).expect("a line")
    };
    let tangent = |angle: f64| {
        let normal = Vector3::new(angle.cos(), 0.0, angle.sin());
        look(normal + Vector3::new(-angle.sin(), 0.0, angle.cos()) * 3.0, normal)
    };
    let mut views: Vec<_> = (0..7).map(|index| tangent(0.9 * index as f64)).collect();
    views.push(look(Vector3::new(0.0, 0.0, -0.5), Vector3::new(0.1, 0.0, 1.0)));
    let start = Cylinder::new(&Point3::new(0.0, 0.0, 0.2), Unit::new_normalize(Vector3::y()), 0.4);
    let result = refine(&views, &start, &options(&views)).expect("a cylinder");
    let clearance = result.cylinder.distance(&Point3::new(0.0, 0.0, -0.5));
    assert!(clearance > 0.0 && clearance < 0.1, "{result:?}");
    assert!(result.cylinder.radius > 0.6, "{result:?}");
}

#[test]
fn values_out_of_range_give_no_panic() {
    let (can, views) = good();
    for scale in [1e-300, 1e-150, 1e100, 1e200, 1e300] {
        let motion = Motion { rotation: Rotation3::identity(), shift: Vector3::zeros(), scale };
        let moved: Vec<_> = views.iter().map(|view| motion.view(view)).collect();
        if let Ok(result) = refine(&moved, &motion.cylinder(&truth(&can)), &options(&moved)) {
            assert!(result.cylinder.radius.is_finite() && result.cylinder.radius > 0.0, "{result:?}");
        }
    }
}
