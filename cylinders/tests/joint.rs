//! Cylinders that share a direction or a radius, estimated together.

#[path = "../examples/make_scene/random.rs"]
mod random;
#[path = "../examples/make_scene/scene.rs"]
#[allow(dead_code, reason = "scene files are not written here")]
mod scene;
mod scenes;

use std::path::Path;

use eliminant_cylinders::{
    Estimate, JointError, JointMethod, Loss, Method, Radii, TriangulateError, View, Warning, estimate,
    estimate_together, read_scene,
};
use nalgebra::{Point2, Unit, Vector2, Vector3};
use random::Random;
use scene::{Can, Photograph, Setup};

const PARALLEL: bool = true;

/// Cans of one radius beside each other: parallel, or each turned by a tenth of a radian.
fn cans(parallel: bool, random: &mut Random) -> Vec<Can> {
    let first = scene::soda_can();
    let can = |index: usize| {
        let turn = if parallel { Vector3::zeros() } else { Vector3::from_fn(|_, _| random.uniform(-0.1, 0.1)) };
        let direction = Unit::new_normalize(first.direction.into_inner() + turn);
        Can { base: first.base + Vector3::x() * (200.0 * index as f64), direction, ..first }
    };
    (0..4).map(can).collect()
}

/// Views of each can from half a circle, with end points or without.
fn views(cans: &[Can], cameras: usize, has_ends: bool, random: &mut Random) -> Vec<Vec<View>> {
    views_of_arc(cans, (cameras, 2 * cameras), has_ends, random)
}

/// Views from the first of so many sectors around each can.
fn views_of_arc(
    cans: &[Can],
    (cameras, sectors): (usize, usize),
    has_ends: bool,
    random: &mut Random,
) -> Vec<Vec<View>> {
    let setup = Setup { cameras: sectors, noise: 1.0, ..scene::soda_can_setup() };
    let of_can = |can: &Can| {
        let photographs = scene::photographs(can, &setup, random);
        photographs[..cameras].iter().map(|photograph| view(can, &setup, photograph, has_ends, random)).collect()
    };
    cans.iter().map(of_can).collect()
}

fn view(can: &Can, setup: &Setup, photograph: &Photograph, has_ends: bool, random: &mut Random) -> View {
    let segments = [1.0, -1.0].map(|side| scenes::silhouette(can, setup, photograph, (side, [0.0, 1.0]), random));
    let camera = *scenes::view(setup, &photograph.camera, &[]).camera();
    let view = View::from_pixel_segments(camera, &segments).expect("segments");
    let ends = if has_ends { view.ends().to_vec() } else { vec![None; 2] };
    view.with_ends(ends).expect("end points")
}

fn method(parallel: bool, radii: Radii) -> JointMethod<'static> {
    JointMethod { parallel, refinement: Some((radii, Loss::Quadratic)), ..JointMethod::default() }
}

/// Mean of the squared errors over their variances, and the mean square error of the shared radius
/// over that of single radii.
fn chi_square_and_gain(parallel: bool, cameras: usize, has_ends: bool) -> [f64; 2] {
    const SCENES: u64 = 300;
    let (mut chi_square, mut shared, mut single) = (0.0, 0.0, 0.0);
    for seed in 0..SCENES {
        let mut random = Random::new(seed);
        let cans = cans(parallel, &mut random);
        let views = views(&cans, cameras, has_ends, &mut random);
        let radius = estimate_together(&views, &method(parallel, Radii::Shared)).expect("cylinders").radius;
        let radius = radius.expect("a shared radius");
        let square = (radius.value - cans[0].radius).powi(2);
        chi_square += square / radius.deviation.powi(2) / SCENES as f64;
        shared += square;
        for (can, views) in cans.iter().zip(&views) {
            let alone = estimate(views, &Method::Refined).expect("a cylinder").cylinder;
            single += (alone.radius - can.radius).powi(2) / cans.len() as f64;
        }
    }
    [chi_square, shared / single]
}

#[test]
fn a_shared_radius_has_the_deviation_that_it_claims_and_is_better_than_single_ones() {
    // The mean of 300 squares has a deviation of 8 %; few lines without end points have a scatter
    // that is known from few numbers.
    for (parallel, cameras, has_ends) in
        [(PARALLEL, 4, true), (!PARALLEL, 4, true), (PARALLEL, 4, false), (PARALLEL, 12, false)]
    {
        let [chi_square, gain] = chi_square_and_gain(parallel, cameras, has_ends);
        println!("parallel {parallel}, {cameras} cameras, ends {has_ends}: chi^2 {chi_square:.3}, gain {gain:.3}");
        assert!((0.75..1.33).contains(&chi_square), "{chi_square}");
        // Four independent radii have a mean of a quarter of the mean square error.
        assert!(gain < 0.4, "{gain}");
    }
}

#[test]
fn one_cylinder_that_shares_nothing_is_refined_as_alone() {
    let mut random = Random::new(1);
    for _ in 0..20 {
        let (can, setup) = scenes::random_scene(&mut random, 0.5);
        let views = scenes::views(&setup, &scene::photographs(&can, &setup, &mut random));
        let alone = estimate(&views, &Method::Refined).expect("a cylinder");
        let together = estimate_together(&[views], &method(!PARALLEL, Radii::Own)).expect("a cylinder");
        let (alone, _) = alone.refinement.expect("a refinement");
        let (together, _) = together.cylinders[0].refinement.clone().expect("a refinement");
        let apart = scenes::difference(&together.cylinder, &alone.cylinder, &alone.reference);
        assert!(apart < 1e-6, "{apart}");
        let covariances = (together.covariance - alone.covariance).amax() / alone.covariance.amax();
        assert!(covariances < 1e-4, "{covariances}");
    }
}

#[test]
fn parallel_cylinders_have_one_direction_that_is_better_than_single_ones() {
    let (mut shared, mut single) = (0.0, 0.0);
    for seed in 0..50 {
        let mut random = Random::new(seed);
        let cans = cans(PARALLEL, &mut random);
        let views = views(&cans, 4, true, &mut random);
        let together = estimate_together(&views, &method(PARALLEL, Radii::Own)).expect("cylinders").cylinders;
        let first = &together[0];
        for (estimate_of_can, views) in together.iter().zip(&views) {
            let [own, other] = [first, estimate_of_can].map(|found| found.refinement.as_ref().expect("a refinement"));
            assert_eq!(own.0.cylinder.direction, other.0.cylinder.direction);
            assert!((own.0.deviation.direction / other.0.deviation.direction - 1.0).abs() < 1e-9);
            let alone = estimate(views, &Method::Refined).expect("a cylinder").cylinder;
            let error = |direction: &Vector3<f64>| cans[0].direction.cross(direction).norm_squared();
            shared += error(&estimate_of_can.cylinder.direction);
            single += error(&alone.direction);
        }
    }
    assert!(shared < 0.4 * single, "{shared} {single}");
}

#[test]
fn a_known_radius_makes_the_axis_more_certain() {
    let (mut known, mut unknown) = (0.0, 0.0);
    for seed in 0..100 {
        let mut random = Random::new(seed);
        let cans = cans(PARALLEL, &mut random);
        // Four cameras within twelve degrees: size and distance are hard to tell apart.
        let views = views_of_arc(&cans, (4, 120), true, &mut random);
        let together = |radii| estimate_together(&views, &method(PARALLEL, radii)).expect("cylinders").cylinders;
        let error = |estimate: &Estimate, can: &Can| {
            let middle = can.base + can.direction.into_inner() * (can.height / 2.0);
            (estimate.cylinder.distance(&middle) + estimate.cylinder.radius).powi(2)
        };
        for (estimate, can) in together(Radii::Known(cans[0].radius)).iter().zip(&cans) {
            assert!((estimate.cylinder.radius / can.radius - 1.0).abs() < 1e-12);
            let (refinement, _) = estimate.refinement.as_ref().expect("a refinement");
            assert_eq!(refinement.deviation.radius, 0.0);
            known += error(estimate, can);
        }
        unknown += together(Radii::Own).iter().zip(&cans).map(|(estimate, can)| error(estimate, can)).sum::<f64>();
    }
    assert!(known < 0.5 * unknown, "{known} {unknown}");
}

/// The camera of a view with these lines.
fn with_ends(view: &View, ends: &[Option<[Point2<f64>; 2]>]) -> View {
    let line = |ends: &Option<[Point2<f64>; 2]>| {
        let [first, second] = ends.expect("end points");
        first.to_homogeneous().cross(&second.to_homogeneous())
    };
    let lines: Vec<_> = ends.iter().map(line).collect();
    scenes::with_lines(view, &lines).with_ends(ends.to_vec()).expect("end points")
}

/// The warnings of each cylinder, least squares first, then refined.
fn warnings(views: &[Vec<View>]) -> [Vec<Vec<Warning>>; 2] {
    [None, Some((Radii::Own, Loss::Quadratic))].map(|refinement| {
        let method = JointMethod { parallel: true, refinement, ..JointMethod::default() };
        let together = estimate_together(views, &method).expect("cylinders");
        together.cylinders.into_iter().map(|estimate| estimate.warnings).collect()
    })
}

#[test]
fn parallel_cylinders_have_the_warnings_of_single_ones() {
    let mut random = Random::new(3);
    let cans = cans(PARALLEL, &mut random);
    let good = views(&cans, 6, true, &mut random);
    for of_method in warnings(&good) {
        assert_eq!(of_method, vec![Vec::new(); 4]);
    }
    // Three lines of the first cylinder.
    let mut few = good.clone();
    few[0] = good[0].iter().take(2).cloned().collect();
    few[0][1] = with_ends(&good[0][1], &good[0][1].ends()[..1]);
    for of_method in warnings(&few) {
        assert!(of_method[0].contains(&Warning::ThreeLines), "{of_method:?}");
        assert!(of_method[0].iter().any(|warning| matches!(warning, Warning::Ambiguous { .. })), "{of_method:?}");
        assert_eq!(of_method[1..], vec![Vec::new(); 3]);
    }
    // A line of the second cylinder is moved by 60 pixels.
    let mut wrong = good.clone();
    let ends = wrong[1][2].ends()[0].expect("end points");
    let moved = [Some(ends.map(|end| end + Vector2::new(0.02, 0.02))), wrong[1][2].ends()[1]];
    wrong[1][2] = with_ends(&good[1][2], &moved);
    for of_method in warnings(&wrong) {
        let is_it =
            |warning: &Warning| matches!(warning, Warning::WrongLine { line, .. } if (line.view, line.line) == (2, 0));
        assert!(of_method[1].iter().any(is_it), "{of_method:?}");
        assert!(of_method[1].iter().any(|warning| matches!(warning, Warning::BadFit { .. })), "{of_method:?}");
    }
    // With a bounded loss the wrong line has little influence.
    let error = |loss| {
        let method = JointMethod { parallel: true, refinement: Some((Radii::Shared, loss)), ..JointMethod::default() };
        let radius = estimate_together(&wrong, &method).expect("cylinders").radius.expect("a radius");
        (radius.value - cans[0].radius).abs()
    };
    assert!(error(Loss::Cauchy { scale: 3.0 }) < 0.2 * error(Loss::Quadratic));
}

#[test]
fn a_cylinder_that_is_not_determined_is_named() {
    let mut random = Random::new(4);
    let mut views = views(&cans(PARALLEL, &mut random), 3, true, &mut random);
    views[2] = views[2].iter().take(1).cloned().collect();
    let error = JointError::Cylinder { cylinder: 2, error: TriangulateError::TooFewLines { lines: 2 }.into() };
    for refinement in [None, Some((Radii::Shared, Loss::Quadratic))] {
        let method = JointMethod { parallel: true, refinement, ..JointMethod::default() };
        assert_eq!(estimate_together(&views, &method), Err(error));
    }
    assert!(estimate_together(&[], &method(PARALLEL, Radii::Shared)).is_err());
    assert!(matches!(estimate_together(&[], &method(!PARALLEL, Radii::Shared)), Err(JointError::Refine(_))));
}

/// Data that are not part of the project.
#[test]
fn the_pillars_have_one_radius() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data/rollercoaster/scene.json");
    if !path.exists() {
        eprintln!("skipped: {} is not there", path.display());
        return;
    }
    let cylinders = read_scene(&path).expect("a scene").cylinders();
    let views: Vec<_> = cylinders.into_iter().map(|lines| lines.views).collect();
    let alone = views.iter().map(|views| estimate(views, &Method::Refined).expect("a cylinder").cylinder.radius);
    let alone: Vec<_> = alone.collect();
    let together = estimate_together(&views, &method(!PARALLEL, Radii::Shared)).expect("cylinders");
    let radius = together.radius.expect("a shared radius");
    let [least, largest] = [f64::min, f64::max].map(|of| alone.iter().copied().reduce(of).expect("five radii"));
    assert!((least..largest).contains(&radius.value), "{radius:?}, {alone:?}");
    assert!(radius.deviation < (largest - least) / 4.0, "{radius:?}, {alone:?}");
    assert!(together.cylinders.iter().all(|estimate| estimate.cylinder.radius == radius.value));
    println!("{radius:?} from {alone:?}");
}
