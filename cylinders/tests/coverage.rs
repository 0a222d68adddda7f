//! Standard deviations hold what they promise, whatever the noise: with no threshold given, among
//! other lines, with and without end points.

#[path = "../examples/make_scene/random.rs"]
mod random;
#[path = "../examples/make_scene/scene.rs"]
#[allow(dead_code, reason = "scene files are not written here")]
mod scene;
mod scenes;

use eliminant_cylinders::{Method, RobustOptions, View, estimate};
use nalgebra::Point2;
use random::Random;
use scene::{Photograph, Setup};

/// Number of scenes for each noise.
const SCENES: u64 = 1000;

/// What the deviations promise, and how often they hold it.
struct Coverage {
    /// Part of the scenes whose radius is within one deviation of the truth.
    one: f64,
    /// Part within 1.96 deviations.
    two: f64,
    /// Part of the silhouettes that are no inliers.
    missed: f64,
    /// Root mean square error of the radius over the noise, millimetres for each pixel.
    error: f64,
}

/// The soda can in fifteen images, seen over a part of its height, with as many other lines as
/// silhouettes.
fn views(noise: f64, has_ends: bool, part: [f64; 2], random: &mut Random) -> Vec<View> {
    let can = scene::soda_can();
    let setup = Setup { cameras: 15, noise, ..scene::soda_can_setup() };
    let photographs = scene::photographs(&can, &setup, random);
    let view = |photograph: &Photograph| {
        let mut segments: Vec<_> =
            [1.0, -1.0].map(|side| scenes::silhouette(&can, &setup, photograph, (side, part), random)).to_vec();
        for _ in 0..2 {
            segments.push([0, 1].map(|_| Point2::new(random.uniform(0.0, 4000.0), random.uniform(0.0, 3000.0))));
        }
        let camera = *scenes::view(&setup, &photograph.camera, &[]).camera();
        let view = View::from_pixel_segments(camera, &segments).expect("segments");
        let ends = if has_ends { view.ends().to_vec() } else { vec![None; segments.len()] };
        view.with_ends(ends).expect("end points")
    };
    photographs.iter().map(view).collect()
}

fn coverage(noise: f64, has_ends: bool, part: [f64; 2]) -> Coverage {
    let can = scene::soda_can();
    let (mut one, mut two, mut found, mut squares) = (0, 0, 0, 0.0);
    for seed in 0..SCENES {
        let views = views(noise, has_ends, part, &mut Random::new(seed));
        let estimate = estimate(&views, &Method::Robust(RobustOptions::of(&views))).expect("a cylinder");
        let (refinement, _) = estimate.refinement.expect("a refinement");
        let error = estimate.cylinder.radius - can.radius;
        one += u32::from(error.abs() < refinement.deviation.radius);
        two += u32::from(error.abs() < 1.96 * refinement.deviation.radius);
        squares += error * error;
        found += estimate.consensus.expect("inliers").inliers.iter().filter(|place| place.line < 2).count();
    }
    let count = SCENES as f64;
    let result = Coverage {
        one: f64::from(one) / count,
        two: f64::from(two) / count,
        missed: 1.0 - found as f64 / (30.0 * count),
        error: (squares / count).sqrt() / noise,
    };
    println!(
        "noise {noise}, end points {has_ends}, {part:?}: {:.1} % within one deviation, {:.1} % within 1.96; {:.2} % of \
         the silhouettes missed; error {:.4} mm for each pixel",
        100.0 * result.one,
        100.0 * result.two,
        100.0 * result.missed,
        result.error
    );
    result
}

/// The sampling error of the two parts is 1.5 and 0.7 points.
#[test]
fn deviations_cover_the_truth_at_any_noise() {
    let mut errors = Vec::new();
    for noise in [0.5, 1.0, 2.0, 3.0, 5.0] {
        let found = coverage(noise, true, [0.0, 1.0]);
        assert!((found.one - 0.683).abs() < 0.03 && (found.two - 0.95).abs() < 0.03);
        assert!(found.missed < 0.003, "a good line is excluded once in a thousand");
        errors.push(found.error);
    }
    let (least, largest) = errors.iter().fold((f64::INFINITY, 0.0_f64), |(l, m), &e| (l.min(e), m.max(e)));
    assert!(largest < 1.05 * least, "the error grows like the noise: {errors:?}");
}

/// Where the lines were seen is not known to the estimator: over the whole can, a fifth of it, or
/// far beyond it.
#[test]
fn deviations_without_end_points_follow_from_the_scatter() {
    for part in [[0.0, 1.0], [0.3, 0.5], [-1.0, 2.0]] {
        for noise in [0.5, 2.0] {
            let found = coverage(noise, false, part);
            assert!((found.one - 0.683).abs() < 0.05 && (found.two - 0.95).abs() < 0.04);
        }
    }
}
