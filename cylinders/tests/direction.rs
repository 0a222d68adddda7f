//! Directions shared by parallel cylinders, and directions among wrong planes.

#[path = "../examples/make_scene/random.rs"]
mod random;
#[path = "../examples/make_scene/scene.rs"]
#[allow(dead_code, reason = "scene files are not written here")]
mod scene;
mod scenes;

use eliminant_cylinders::direction::{estimate_direction, estimate_shared_direction};
use eliminant_cylinders::{
    CircleError, DirectionError, ParallelError, RansacOptions, RansacOptionsError, TriangulateError, View,
    ViewingPlane, common_direction, default_direction_options, estimate_direction_robustly, triangulate,
    triangulate_parallel,
};
use nalgebra::{Point3, Unit, Vector3};
use random::Random;
use scene::{Can, Setup};
use scenes::{random_direction, views};

/// Three parallel cans of different size beside each other, each with its own views.
fn parallel_cans(noise: f64, cameras: usize, random: &mut Random) -> (Vec<Can>, Vec<Vec<View>>) {
    let setup = Setup { cameras, noise, ..scene::soda_can_setup() };
    let first = scene::soda_can();
    let across = Unit::new_normalize(first.direction.cross(&Vector3::x()));
    let can = |index: f64| Can {
        base: first.base + across.into_inner() * (200.0 * index),
        radius: 20.0 + 10.0 * index,
        ..first
    };
    let cans = [0.0, 1.0, 2.0].map(can).to_vec();
    let views = cans.iter().map(|can| views(&setup, &scene::photographs(can, &setup, random))).collect();
    (cans, views)
}

fn planes(views: &[View]) -> Vec<ViewingPlane> {
    views.iter().flat_map(View::planes).collect()
}

fn angle(left: &Unit<Vector3<f64>>, right: &Unit<Vector3<f64>>) -> f64 {
    left.cross(right).norm().asin()
}

#[test]
fn two_planes_have_one_direction_in_common() {
    let mut random = Random::new(1);
    let (cans, cylinders) = parallel_cans(0.0, 3, &mut random);
    let planes = planes(&cylinders[0]);
    assert!(angle(&common_direction(&planes[0], &planes[2]).expect("a direction"), &cans[0].direction) < 1e-12);
    assert_eq!(common_direction(&planes[0], &planes[0]), None);
}

#[test]
fn parallel_cylinders_share_a_direction() {
    let (cans, cylinders) = parallel_cans(0.0, 3, &mut Random::new(2));
    let lists: Vec<_> = cylinders.iter().map(|views| planes(views)).collect();
    let shared = estimate_shared_direction(&lists).expect("a direction");
    assert!(angle(&shared.direction.direction, &cans[0].direction) < 1e-12);
    assert!(shared.deviations.len() == 3 && shared.deviations.iter().all(|&deviation| deviation < 1e-12));
    // The planes need no labels.
    assert_eq!(estimate_direction(&lists.concat()).expect("a direction"), shared.direction);
}

#[test]
fn a_shared_direction_is_better_than_one_for_each() {
    let (mut alone, mut shared) = (0.0, 0.0);
    for seed in 0..200 {
        let (cans, cylinders) = parallel_cans(0.5, 3, &mut Random::new(seed));
        let result = triangulate_parallel(&cylinders).expect("cylinders");
        for ((can, views), together) in cans.iter().zip(&cylinders).zip(&result.cylinders) {
            let single = triangulate(views).expect("a cylinder");
            alone += angle(&single.cylinder.direction, &can.direction).powi(2);
            shared += angle(&together.cylinder.direction, &can.direction).powi(2);
            assert_eq!(together.residuals.len(), 6);
        }
    }
    println!("angle: {:.1e} alone, {:.1e} shared", (alone / 600.0_f64).sqrt(), (shared / 600.0_f64).sqrt());
    // The variance is a third, up to sampling.
    assert!(shared < alone / 2.0);
}

#[test]
fn cylinders_that_are_not_parallel_show() {
    let (_, mut cylinders) = parallel_cans(0.5, 4, &mut Random::new(3));
    let other = Can { direction: Unit::new_normalize(Vector3::new(0.3, -0.2, 0.97)), ..scene::soda_can() };
    let setup = Setup { cameras: 4, ..scene::soda_can_setup() };
    cylinders[1] = views(&setup, &scene::photographs(&other, &setup, &mut Random::new(4)));
    let deviations = triangulate_parallel(&cylinders).expect("cylinders").direction.deviations;
    assert!(deviations[1] > 1.2 * deviations[0] && deviations[1] > 1.2 * deviations[2], "{deviations:?}");
}

#[test]
fn degenerate_parallel_cylinders() {
    let (_, mut cylinders) = parallel_cans(0.5, 3, &mut Random::new(5));
    cylinders[1].truncate(1);
    let single = TriangulateError::TooFewLines { lines: 2 };
    assert_eq!(triangulate_parallel(&cylinders), Err(ParallelError::Cylinder { cylinder: 1, error: single }));
    cylinders[1] = vec![cylinders[0][0].clone(); 3];
    let error = TriangulateError::SingleViewpoint;
    assert_eq!(triangulate_parallel(&cylinders), Err(ParallelError::Cylinder { cylinder: 1, error }));
    let empty = triangulate_parallel(&[]);
    assert_eq!(empty, Err(ParallelError::Direction(DirectionError::NoDecomposition { planes: 0 })));
    // Three lines have four circles, even if the direction is known.
    cylinders[1] = parallel_cans(0.5, 2, &mut Random::new(6)).1.swap_remove(1);
    cylinders[1][1] = scenes::with_lines(&cylinders[1][1], &cylinders[1][1].lines()[..1]);
    let error = TriangulateError::Circle(CircleError::Ambiguous { circles: 4 });
    assert_eq!(triangulate_parallel(&cylinders), Err(ParallelError::Cylinder { cylinder: 1, error }));
}

/// Planes of three parallel cans, alternating with twice as many others.
fn with_outliers(noise: f64, random: &mut Random) -> (Unit<Vector3<f64>>, Vec<ViewingPlane>, Vec<usize>) {
    let (cans, cylinders) = parallel_cans(noise, 5, random);
    let (mut all, mut inliers) = (Vec::new(), Vec::new());
    for plane in cylinders.iter().flat_map(|views| planes(views)) {
        for _ in 0..2 {
            all.push(ViewingPlane { normal: random_direction(random).into_inner(), ..plane });
        }
        inliers.push(all.len());
        all.push(plane);
    }
    (cans[0].direction, all, inliers)
}

#[test]
fn wrong_planes_do_not_matter() {
    let options = default_direction_options();
    for seed in 0..100 {
        let (direction, planes, inliers) = with_outliers(0.5, &mut Random::new(seed));
        let options = RansacOptions { seed, ..options };
        let result = estimate_direction_robustly(&planes, &options).expect("a direction");
        assert_eq!(estimate_direction_robustly(&planes, &options).expect("a direction"), result);
        let missed = inliers.iter().filter(|index| !result.inliers.contains(index)).count();
        assert!(missed <= 1, "seed {seed}: {missed} of {} planes missed", inliers.len());
        let off = angle(&result.direction.direction, &direction);
        assert!(off < 2.0 * options.threshold / (inliers.len() as f64).sqrt(), "seed {seed}: {off}");
    }
}

#[test]
fn degenerate_planes() {
    let options = RansacOptions { max_samples: 1000, ..default_direction_options() };
    let plane = |normal: Vector3<f64>| ViewingPlane { normal, centre: Point3::origin(), forward: Vector3::z() };
    let parallel = vec![plane(Vector3::x()); 5];
    let result = estimate_direction_robustly(&parallel, &options);
    assert!(matches!(result, Err(DirectionError::ParallelPlanes { .. })), "{result:?}");
    let result = estimate_direction_robustly(&parallel[..2], &options);
    assert_eq!(result, Err(DirectionError::NoDecomposition { planes: 2 }));
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()].map(plane);
    let result = estimate_direction_robustly(&axes, &options);
    assert_eq!(result, Err(DirectionError::NoConsensus { inliers: 2, planes: 3 }));
    let result = estimate_direction_robustly(&axes, &RansacOptions { threshold: -1.0, ..options });
    assert_eq!(result, Err(DirectionError::Options(RansacOptionsError::Threshold { threshold: -1.0 })));
}
