//! Points of the scene as evidence beside the lines.

#[path = "../examples/make_scene/random.rs"]
mod random;
#[path = "../examples/make_scene/scene.rs"]
#[allow(dead_code, reason = "scene files are not written here")]
mod scene;
mod scenes;

use eliminant_cylinders::{
    Estimate, JointEstimate, JointMethod, Loss, Method, Radii, RobustOptions, View, Warning, estimate,
    estimate_together, with_points,
};
use nalgebra::{Point3, Vector3};
use random::Random;
use scene::{Can, Setup};

/// Number of scenes.
const SCENES: u64 = 1000;

/// The can in the first of so many sectors around it, with end points.
fn views(can: &Can, (cameras, sectors): (usize, usize), noise: f64, random: &mut Random) -> Vec<View> {
    let setup = Setup { cameras: sectors, noise, ..scene::soda_can_setup() };
    let photographs = scene::photographs(can, &setup, random);
    let view = |photograph| {
        let segments = [1.0, -1.0].map(|side| scenes::silhouette(can, &setup, photograph, (side, [0.0, 1.0]), random));
        View::from_pixel_segments(*scenes::view(&setup, &photograph.camera, &[]).camera(), &segments).expect("segments")
    };
    photographs[..cameras].iter().map(view).collect()
}

/// Points on all sides of the can, of which the cameras see some, and as many anywhere near it.
fn points(can: &Can, count: usize, deviation: f64, random: &mut Random) -> Vec<Point3<f64>> {
    let direction = can.direction.into_inner();
    let across = direction.cross(&Vector3::x()).normalize();
    let mut points = Vec::new();
    for _ in 0..count {
        let turn = nalgebra::Rotation3::from_axis_angle(&can.direction, random.uniform(0.0, std::f64::consts::TAU));
        let surface = turn * across * can.radius + direction * random.uniform(0.0, can.height);
        points.push(can.base + surface + Vector3::from_fn(|_, _| random.normal()) * deviation);
        let middle = can.base + direction * (can.height / 2.0);
        points.push(middle + Vector3::from_fn(|_, _| random.uniform(-1.0, 1.0)) * can.height);
    }
    points
}

fn alone(estimate: Estimate) -> JointEstimate {
    JointEstimate { cylinders: vec![estimate], radius: None }
}

/// Four photographs from a third of a circle, points with the given noise: errors of the radius
/// over their deviations, by lines and by both.
#[test]
fn points_help_as_much_as_the_deviations_say() {
    let can = scene::soda_can();
    for (noise, deviation) in [(1.0, 0.3), (3.0, 0.1), (0.3, 1.0)] {
        let (mut squares, mut one, mut two, mut warned, mut used, mut spread) = ([0.0; 2], 0, 0, 0, 0.0, 0.0);
        for seed in 0..SCENES {
            let random = &mut Random::new(seed);
            let views = views(&can, (4, 12), noise, random);
            let points = points(&can, 100, deviation, random);
            let of_lines = estimate(&views, &Method::Refined).expect("a cylinder");
            let radius = of_lines.cylinder.radius;
            let both = with_points(alone(of_lines), &[views], &points, &JointMethod::default()).expect("a cylinder");
            let both = &both.cylinders[0];
            let (refinement, _) = both.refinement.as_ref().expect("a refinement");
            let error = both.cylinder.radius - can.radius;
            squares[0] += (radius - can.radius).powi(2);
            squares[1] += error * error;
            one += u32::from(error.abs() < refinement.deviation.radius);
            two += u32::from(error.abs() < 1.96 * refinement.deviation.radius);
            warned += u32::from(both.warnings.contains(&Warning::PointsDisagree));
            let found = both.surface_points.expect("points");
            used += found.count;
            spread += found.deviation;
        }
        let count = SCENES as f64;
        let [lines, both] = squares.map(|sum| (sum / count).sqrt());
        let (one, two) = (f64::from(one) / count, f64::from(two) / count);
        println!(
            "lines {noise} pixels, points {deviation} mm: error {lines:.4} mm by lines, {both:.4} by both; {:.1} % and \
             {:.1} % within 1 and 1.96 deviations; {:.1} points used, {:.3} mm; {warned} warnings",
            100.0 * one,
            100.0 * two,
            used / count,
            spread / count
        );
        // The noise is estimated with 11 degrees of freedom: 66 and 92 % for lines alone, too.
        assert!(both < 1.01 * lines && (one - 0.66).abs() < 0.045 && (two - 0.92).abs() < 0.03);
        assert!((spread / count / deviation - 1.0).abs() < 0.1);
        assert!(f64::from(warned) < 0.01 * count);
    }
}

/// The cylinder of both, from lines with this method.
fn of_both(views: &[View], points: &[Point3<f64>], method: &Method) -> Estimate {
    let of_lines = estimate(views, method).expect("a cylinder");
    let both = with_points(alone(of_lines), &[views.to_vec()], points, &JointMethod::default());
    both.expect("a cylinder").cylinders.remove(0)
}

/// Points that lie on another cylinder are not taken in silence; points that lie on none are not
/// taken.
#[test]
fn points_that_do_not_fit_draw_a_warning() {
    let can = scene::soda_can();
    for seed in 0..100 {
        let random = &mut Random::new(seed);
        let views = views(&can, (4, 12), 1.0, random);
        for radius in [0.95 * can.radius, 1.05 * can.radius, 1.15 * can.radius] {
            let both = of_both(&views, &points(&Can { radius, ..can }, 100, 0.3, random), &Method::Refined);
            let found = both.surface_points.expect("asked");
            assert!(both.warnings.contains(&Warning::PointsDisagree) || found.count == 0.0, "{seed}: {found:?}");
        }

        let elsewhere: Vec<_> = points(&can, 100, 0.3, random).into_iter().skip(1).step_by(2).collect();
        let refined = estimate(&views, &Method::Refined).expect("a cylinder");
        let both = of_both(&views, &elsewhere, &Method::Refined);
        assert_eq!(both.surface_points.expect("asked").count, 0.0, "{seed}");
        assert!((both.cylinder.radius - refined.cylinder.radius).abs() < 1e-6 * can.radius, "{seed}");
        assert_eq!(both.warnings, refined.warnings);
    }
}

/// Without any noise nothing is divided by 0, and where one kind is exact, so is the cylinder.
#[test]
fn exact_points_and_lines_are_exact() {
    let can = scene::soda_can();
    for (noise, deviation, tolerance) in [(0.0, 0.0, 1e-6), (1.0, 0.0, 1e-4), (0.0, 0.3, 1e-6)] {
        let random = &mut Random::new(5);
        let views = views(&can, (4, 12), noise, random);
        let points = points(&can, 100, deviation, random);
        for method in [Method::LeastSquares, Method::Refined, Method::Robust(RobustOptions::of(&views))] {
            let error = of_both(&views, &points, &method).cylinder.radius / can.radius - 1.0;
            assert!(error.abs() < tolerance, "{noise} {deviation} {method:?}: {error:e}");
        }
    }
}

/// Three cans of one radius, points on each: the shared radius follows all of them.
#[test]
fn cylinders_share_what_they_share() {
    let can = scene::soda_can();
    let cans = [0.0, 150.0, 300.0].map(|shift| Can { base: can.base + Vector3::x() * shift, ..can });
    let refinement = Some((Radii::Shared, Loss::Quadratic));
    let method = JointMethod { parallel: true, refinement, ..JointMethod::default() };
    let mut squares = [0.0; 2];
    for seed in 0..100 {
        let random = &mut Random::new(seed);
        let of_cans: Vec<_> = cans.iter().map(|can| views(can, (4, 12), 2.0, random)).collect();
        let points: Vec<_> = cans.iter().flat_map(|can| points(can, 60, 0.3, random)).collect();
        let of_lines = estimate_together(&of_cans, &method).expect("cylinders");
        let both = with_points(of_lines.clone(), &of_cans, &points, &method).expect("cylinders");
        let radii = [&of_lines, &both].map(|joint| joint.radius.expect("a shared radius"));
        squares.iter_mut().zip(radii).for_each(|(sum, radius)| *sum += (radius.value - can.radius).powi(2));
        assert!(radii[1].deviation < radii[0].deviation, "{seed}: {radii:?}");
        assert!((radii[1].value - can.radius).abs() < 5.0 * radii[1].deviation, "{seed}: {radii:?}");
        assert!(both.cylinders.iter().all(|one| one.cylinder.radius == radii[1].value));
        let direction = both.cylinders[0].cylinder.direction;
        assert!(both.cylinders.iter().all(|one| one.cylinder.direction == direction));
        assert!(both.cylinders.iter().all(|one| one.surface_points.is_some_and(|found| found.count > 20.0)));
    }
    assert!(squares[1] < squares[0] / 4.0, "{squares:?}");
}

/// Three lines touch up to four cylinders. Points tell which of them it is.
#[test]
fn points_decide_between_cylinders() {
    let can = scene::soda_can();
    let (mut ambiguous, mut right) = (0, 0);
    for seed in 0..100 {
        let random = &mut Random::new(seed);
        let all = views(&can, (2, 6), 0.3, random);
        let one = View::from_normalised_lines(*all[1].camera(), &all[1].lines()[..1]).expect("a line");
        let one = one.with_ends(all[1].ends()[..1].to_vec()).expect("end points");
        let three = [all[0].clone(), one];
        let points = points(&can, 100, 0.1, random);
        let Ok(of_lines) = estimate(&three, &Method::Refined) else { continue };
        if !of_lines.plausible.as_ref().is_some_and(|plausible| plausible.is_ambiguous()) {
            continue;
        }
        ambiguous += 1;
        let both = with_points(alone(of_lines), &[three.to_vec()], &points, &JointMethod::default());
        let both = both.expect("a cylinder").cylinders.remove(0);
        let is_certain = !both.plausible.as_ref().is_some_and(|plausible| plausible.is_ambiguous());
        let is_right = (both.cylinder.radius / can.radius - 1.0).abs() < 0.01;
        assert!(is_right || !is_certain, "{seed}: {}", both.cylinder.radius);
        right += u32::from(is_right && is_certain);
    }
    println!("{right} of {ambiguous} ambiguous ones decided");
    assert!(ambiguous > 50 && right * 20 >= ambiguous * 19);
}
