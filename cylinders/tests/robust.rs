//! Robust estimation: outliers, few lines, the choice among circles, invariance, determinism,
//! refused input.

#[path = "../examples/make_scene/random.rs"]
mod random;
#[path = "../examples/make_scene/scene.rs"]
#[allow(dead_code, reason = "scene files are not written here")]
mod scene;
mod scenes;

use std::time::Instant;

use eliminant_cylinders::{
    LineId, RansacOptions, RansacOptionsError, RobustError, RobustOptions, View, triangulate, triangulate_robustly,
};
use nalgebra::{Point3, Vector3};
use random::Random;
use scene::{Can, Photograph, Setup};
use scenes::{Motion, difference, truth, view, with_lines};

/// Line through two points of the image, uniform.
fn line_anywhere(random: &mut Random) -> Vector3<f64> {
    let mut point = || Vector3::new(random.uniform(0.0, 4000.0), random.uniform(0.0, 3000.0), 1.0);
    point().cross(&point())
}

/// Image of a line in space that is parallel to the axis, such as the edge of an object beside the
/// can.
fn parallel_line(can: &Can, setup: &Setup, photograph: &Photograph, random: &mut Random) -> Vector3<f64> {
    let beside = Vector3::from_fn(|_, _| random.uniform(-150.0, 150.0));
    let ends = [0.0, can.height].map(|height| {
        let point: Point3<f64> = can.base + can.direction.into_inner() * height + beside;
        let image = setup.calibration * photograph.camera * point.to_homogeneous();
        image / image.z + Vector3::new(random.normal(), random.normal(), 0.0) * setup.noise
    });
    ends[0].cross(&ends[1])
}

/// A soda can seen by fifteen cameras, both silhouettes in each, with end points that are off by a
/// pixel, among other lines. The inliers come at random places of each view. Also says which lines
/// are silhouettes.
fn scene_with_outliers(
    seed: u64,
    share: f64,
    mut outlier: impl FnMut(&Can, &Setup, &Photograph, &mut Random) -> Vector3<f64>,
) -> (Can, Vec<View>, Vec<LineId>) {
    let (can, setup) = (scene::soda_can(), Setup { cameras: 15, noise: 1.0, ..scene::soda_can_setup() });
    let mut random = Random::new(seed);
    let photographs = scene::photographs(&can, &setup, &mut random);
    let outliers = (2.0 * setup.cameras as f64 * share / (1.0 - share)).round() as usize;
    let (mut views, mut silhouettes) = (Vec::new(), Vec::new());
    for (index, photograph) in photographs.iter().enumerate() {
        let count = outliers * (index + 1) / setup.cameras - outliers * index / setup.cameras;
        let mut lines: Vec<_> = (0..count).map(|_| outlier(&can, &setup, photograph, &mut random)).collect();
        let place = random.uniform(0.0, count as f64 + 1.0) as usize;
        lines.splice(place..place, photograph.lines);
        silhouettes.extend([place, place + 1].map(|line| LineId { view: index, line }));
        views.push(view(&setup, &photograph.camera, &lines));
    }
    (can, views, silhouettes)
}

fn anywhere(_: &Can, _: &Setup, _: &Photograph, random: &mut Random) -> Vector3<f64> {
    line_anywhere(random)
}

fn with_seed(options: RobustOptions, seed: u64) -> RobustOptions {
    RobustOptions { ransac: RansacOptions { seed, ..options.ransac }, ..options }
}

/// Number of scenes out of a hundred in which the radius is within five percent.
fn successes(share: f64, outlier: fn(&Can, &Setup, &Photograph, &mut Random) -> Vector3<f64>) -> usize {
    let (mut found, mut samples, mut missed, mut extra, mut time) = (0, 0, 0, 0, 0.0);
    let mut errors = Vec::new();
    for seed in 0..100 {
        let (can, views, silhouettes) = scene_with_outliers(seed, share, outlier);
        let start = Instant::now();
        let result = triangulate_robustly(&views, &with_seed(RobustOptions::of(&views), seed));
        time += start.elapsed().as_secs_f64();
        let Ok(result) = result else {
            println!("seed {seed}: {:?}", result.err());
            continue;
        };
        let error = (result.refinement.cylinder.radius / can.radius - 1.0).abs();
        errors.push(error);
        found += usize::from(error < 0.05);
        samples += result.samples;
        missed += silhouettes.iter().filter(|line| !result.inliers.contains(line)).count();
        extra += result.inliers.iter().filter(|line| !silhouettes.contains(line)).count();
    }
    errors.sort_by(f64::total_cmp);
    println!(
        "{:.0} % outliers: {found} of 100 within 5 %, median {:.3} %, worst {:.3} %; {} samples, {:.2} ms, \
         {} silhouettes missed of 3000, {} other lines taken",
        100.0 * share,
        100.0 * errors[errors.len() / 2],
        100.0 * errors[errors.len() - 1],
        samples / 100,
        1e3 * time / 100.0,
        missed,
        extra,
    );
    found
}

#[test]
fn seventy_percent_outliers() {
    assert!(successes(0.7, anywhere) >= 99);
}

#[test]
fn seventy_percent_outliers_parallel_to_the_axis() {
    assert!(successes(0.7, parallel_line) >= 99);
}

#[test]
fn ninety_percent_outliers() {
    assert!(successes(0.9, anywhere) >= 99);
}

#[test]
fn noise_free_lines_give_the_cylinder() {
    let mut random = Random::new(1);
    let mut errors: Vec<f64> = (0..200)
        .map(|index| {
            let (can, setup) = scenes::random_scene(&mut random, 0.0);
            let photographs = scene::photographs(&can, &setup, &mut random);
            let lines = |photograph: &Photograph| {
                let [left, right] = photograph.lines;
                let mut other = || Vector3::from_fn(|_, _| random.normal());
                view(&setup, &photograph.camera, &[left, other(), right])
            };
            let views: Vec<_> = photographs.iter().map(lines).collect();
            let result = triangulate_robustly(&views, &RobustOptions::of(&views));
            let result = result.unwrap_or_else(|error| panic!("scene {index}: {error}"));
            assert!(result.inliers.len() >= 2 * views.len(), "scene {index}");
            assert_eq!(result.residuals.len(), 3 * views.len());
            difference(&result.refinement.cylinder, &truth(&can), &can.base)
        })
        .collect();
    errors.sort_by(f64::total_cmp);
    let (median, worst) = (errors[errors.len() / 2], errors[errors.len() - 1]);
    println!("relative error: median {median:.1e}, worst {worst:.1e}");
    assert!(median < 1e-12 && worst < 1e-9, "median {median:e}, worst {worst:e}");
}

#[test]
fn without_outliers_the_result_is_that_of_refinement() {
    let (_, views, silhouettes) = scene_with_outliers(3, 0.0, anywhere);
    let robust = triangulate_robustly(&views, &RobustOptions::of(&views)).expect("a cylinder");
    assert_eq!(robust.inliers, silhouettes);
    let direct = triangulate(&views).expect("a cylinder");
    let refined = scenes::refined(&views, &direct.cylinder);
    let off = difference(&robust.refinement.cylinder, &refined.cylinder, &refined.reference);
    assert!(off < 1e-7, "differs by {off:e}");
}

#[test]
fn a_known_direction_needs_fewer_samples_to_agree() {
    let (can, views, silhouettes) = scene_with_outliers(4, 0.7, anywhere);
    let options = RobustOptions { direction: Some(can.direction), ..RobustOptions::of(&views) };
    let result = triangulate_robustly(&views, &options).expect("a cylinder");
    assert_eq!(result.inliers, silhouettes);
    let error = result.refinement.cylinder.radius / can.radius - 1.0;
    assert!(error.abs() < 0.01, "{error}");
}

#[test]
fn without_calibration_the_unit_is_the_radian() {
    let (can, views, silhouettes) = scene_with_outliers(5, 0.7, anywhere);
    let bare: Vec<_> = views.iter().map(scenes::without_calibration).collect();
    let result = triangulate_robustly(&bare, &RobustOptions::of(&bare)).expect("a cylinder");
    assert_eq!(result.inliers, silhouettes);
    assert!((result.refinement.cylinder.radius / can.radius - 1.0).abs() < 0.01);
}

#[test]
fn the_same_seed_gives_the_same_result_and_another_one_the_same_cylinder() {
    let (_, views, _) = scene_with_outliers(6, 0.7, anywhere);
    let options = RobustOptions::of(&views);
    let first = triangulate_robustly(&views, &options).expect("a cylinder");
    assert_eq!(triangulate_robustly(&views, &options).expect("a cylinder"), first);
    let other = triangulate_robustly(&views, &with_seed(options, 77)).expect("a cylinder");
    assert_eq!(other.inliers, first.inliers);
    let refinement = &first.refinement;
    let off = difference(&other.refinement.cylinder, &refinement.cylinder, &refinement.reference);
    assert!(off < 1e-7, "differs by {off:e}");
}

#[test]
fn world_frame_order_and_signs_do_not_matter() {
    let mut random = Random::new(7);
    for seed in 0..20 {
        let (_, views, _) = scene_with_outliers(seed, 0.5, anywhere);
        let original = triangulate_robustly(&views, &RobustOptions::of(&views)).expect("a cylinder");
        let motion = Motion::random(&mut random);
        let flipped = |view: &View| with_lines(view, &view.lines().iter().rev().map(|line| -line).collect::<Vec<_>>());
        let moved: Vec<_> = views.iter().rev().map(|view| flipped(&motion.view(view))).collect();
        let result = triangulate_robustly(&moved, &RobustOptions::of(&moved)).expect("a cylinder");
        assert_eq!(result.inliers.len(), original.inliers.len());
        let expected = motion.cylinder(&original.refinement.cylinder);
        let at = motion.point(&original.refinement.reference);
        let off = difference(&result.refinement.cylinder, &expected, &at);
        assert!(off < 1e-7, "seed {seed}: differs by {off:e}");
    }
}

// Refused input.

#[test]
fn few_lines_say_what_to_pass() {
    let (_, views, _) = scene_with_outliers(8, 0.0, anywhere);
    let views = vec![views[0].clone(), with_lines(&views[1], &views[1].lines()[..1])];
    let error = triangulate_robustly(&views, &RobustOptions::of(&views)).expect_err("three lines");
    assert_eq!(error, RobustError::TooFewLines { lines: 3 });
    assert!(error.to_string().contains("pass at least four lines"), "{error}");
}

#[test]
fn four_lines_are_enough() {
    let found = (0..100).filter(|&seed| {
        let (can, views, _) = scene_with_outliers(seed, 0.0, anywhere);
        let views = [views[0].clone(), views[4].clone()];
        let result = triangulate_robustly(&views, &RobustOptions::of(&views));
        result.is_ok_and(|result| {
            let error = result.refinement.cylinder.radius / can.radius - 1.0;
            result.inliers.len() == 4 && error.abs() < 0.05
        })
    });
    // One in some thousand lines is further from its silhouette than the threshold.
    assert!(found.count() >= 99);
}

#[test]
fn lines_that_do_not_agree() {
    let (_, views, _) = scene_with_outliers(10, 0.0, anywhere);
    let mut random = Random::new(10);
    let views: Vec<_> =
        views[..5].iter().map(|view| with_lines(view, &[Vector3::from_fn(|_, _| random.normal())])).collect();
    let options = RobustOptions::of(&views);
    let options = RobustOptions { ransac: RansacOptions { max_samples: 2000, ..options.ransac }, ..options };
    let result = triangulate_robustly(&views, &options);
    // Three searches with growing thresholds.
    assert!(matches!(result, Err(RobustError::NoConsensus { lines: 5, samples: 6000, .. })), "{result:?}");
}

#[test]
fn cameras_at_one_place_are_named_at_once() {
    let (_, views, _) = scene_with_outliers(11, 0.0, anywhere);
    let options = RobustOptions::of(&views);
    for views in [vec![views[0].clone(); 4], vec![with_lines(&views[0], &[views[0].lines()[0]]); 4]] {
        let result = triangulate_robustly(&views, &options);
        assert_eq!(result, Err(RobustError::SingleViewpoint));
    }
}

#[test]
fn a_cylinder_behind_the_cameras_is_none() {
    let (_, views, _) = scene_with_outliers(12, 0.0, anywhere);
    // Each camera is turned by half a turn about its y axis, so it sees the same viewing planes
    // from the other side.
    let behind: Vec<_> = views.iter().map(scenes::turned_round).collect();
    let options = RobustOptions::of(&behind);
    let options = RobustOptions { ransac: RansacOptions { max_samples: 2000, ..options.ransac }, ..options };
    assert!(triangulate(&behind).is_ok(), "the planes are tangent");
    let result = triangulate_robustly(&behind, &options);
    assert!(matches!(result, Err(RobustError::NoConsensus { .. })), "{result:?}");
}

#[test]
fn options_are_checked() {
    let (_, views, _) = scene_with_outliers(13, 0.0, anywhere);
    let options = RobustOptions::of(&views);
    for (threshold, confidence) in [(0.0, 0.9), (f64::NAN, 0.9), (1.0, 1.0), (1.0, f64::NAN)] {
        let ransac = RansacOptions { threshold, confidence, ..options.ransac };
        let result = triangulate_robustly(&views, &RobustOptions { ransac, ..options });
        assert!(
            matches!(
                result,
                Err(RobustError::Options(RansacOptionsError::Threshold { .. } | RansacOptionsError::Confidence { .. }))
            ),
            "{result:?}"
        );
    }
}
