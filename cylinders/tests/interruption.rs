//! Work that would take long ends soon after its flag is set, with an error that says so:
//! triangulation, matching, photographs.

#![cfg(feature = "command")]

#[path = "../examples/make_scene/random.rs"]
mod random;
#[path = "../examples/make_scene/scene.rs"]
#[allow(dead_code, reason = "scene files are not written here")]
mod scene;

use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use eliminant_cylinders::detection::GreyImage;
use eliminant_cylinders::distortion::Distortion;
use eliminant_cylinders::matching::refined_matches;
use eliminant_cylinders::photograph::Photograph;
use eliminant_cylinders::photos::{LineOptions, PhotoError, PhotoOptions, Seen, find_in_photographs, seen};
use eliminant_cylinders::simulation::{ParallelScene, ParallelSetup};
use eliminant_cylinders::{
    Calibration, Camera, Estimate, EstimateError, Interrupt, Interrupted, JointError, JointEstimate, JointMethod, Loss,
    MatchError, MatchOptions, Matching, Method, Radii, RansacOptions, RobustError, RobustOptions, View, estimate,
    estimate_together, match_cylinders, match_directions, with_points,
};
use nalgebra::{Point3, Vector3};
use random::Random;
use scene::{Setup, photographs, soda_can, soda_can_setup};

/// When the flag is set. Each work below would take many times as long.
const PATIENCE: Duration = Duration::from_millis(50);

/// The longest step between two looks at the flag, far exceeded.
const SOON: Duration = Duration::from_secs(20);

/// The result of work that is interrupted after a while.
fn interrupted<T>(work: impl FnOnce(Interrupt<'_>) -> T) -> T {
    let flag = AtomicBool::new(false);
    thread::scope(|scope| {
        scope.spawn(|| {
            thread::sleep(PATIENCE);
            flag.store(true, Ordering::Relaxed);
        });
        let start = Instant::now();
        let result = work(Interrupt::by(&flag));
        assert!(start.elapsed() < PATIENCE + SOON, "{:?}", start.elapsed());
        result
    })
}

/// Views of a soda can: both silhouettes of each camera, and so many lines anywhere.
fn views(cameras: usize, others: usize) -> Vec<View> {
    let mut random = Random::new(1);
    let setup = Setup { cameras, ..soda_can_setup() };
    let calibration = Calibration::new(&setup.calibration).expect("a calibration");
    let photographs = photographs(&soda_can(), &setup, &mut random);
    let view = |photograph: &scene::Photograph| {
        let mut point = || Vector3::new(random.uniform(0.0, 4000.0), random.uniform(0.0, 3000.0), 1.0);
        let others = (0..others).map(|_| point().cross(&point()));
        let lines: Vec<_> = photograph.lines.iter().copied().chain(others).collect();
        let camera = Camera::from_normalised(&photograph.camera).expect("a camera").with_calibration(calibration);
        View::from_pixel_lines(camera, &lines).expect("lines")
    };
    photographs.iter().map(view).collect()
}

/// Lines of which one in twenty is a silhouette.
fn clutter() -> ParallelScene {
    let setup = ParallelSetup { cylinders: 10, images: 20, noise: 0.5, detection: 0.8, outlier_rate: 0.95 };
    setup.scene(1).expect("a scene")
}

#[test]
fn ransac() {
    let views = views(20, 20);
    let result = interrupted(|interrupt| {
        let options = RobustOptions::of(&views);
        // No sample agrees within so little.
        let ransac = RansacOptions { threshold: 1e-9, max_samples: usize::MAX, interrupt, ..options.ransac };
        estimate(&views, &Method::Robust(RobustOptions { ransac, ..options }))
    });
    assert_eq!(result, Err(EstimateError::Robust(RobustError::Interrupted(Interrupted))));
}

#[test]
fn cylinders_together_and_with_points() {
    let cylinders = vec![views(20, 0); 2000];
    let method =
        JointMethod { parallel: true, refinement: Some((Radii::Shared, Loss::Quadratic)), ..Default::default() };
    let together = interrupted(|interrupt| estimate_together(&cylinders, &JointMethod { interrupt, ..method }));
    assert_eq!(together, Err(JointError::Interrupted(Interrupted)));

    let one: Estimate = estimate(&cylinders[0], &Method::Refined).expect("a cylinder");
    let estimates = JointEstimate { cylinders: vec![one; cylinders.len()], radius: None };
    let points = vec![Point3::new(0.0, 0.0, 0.0); 1000];
    let both =
        interrupted(|interrupt| with_points(estimates, &cylinders, &points, &JointMethod { interrupt, ..method }));
    assert_eq!(both, Err(JointError::Interrupted(Interrupted)));
}

#[test]
fn matching() {
    let ParallelScene { views, direction, .. } = clutter();
    let options = MatchOptions::of(&views);
    let along = interrupted(|interrupt| match_cylinders(&views, &direction, &MatchOptions { interrupt, ..options }));
    assert_eq!(along, Err(MatchError::Interrupted(Interrupted)));
    let all = interrupted(|interrupt| match_directions(&views, &MatchOptions { interrupt, ..options }));
    assert_eq!(all, Err(MatchError::Interrupted(Interrupted)));
}

#[test]
fn refinement_of_matches() {
    let setup = ParallelSetup { cylinders: 3, images: 8, noise: 0.5, detection: 1.0, outlier_rate: 0.5 };
    let ParallelScene { views, direction, .. } = setup.scene(1).expect("a scene");
    let once = match_cylinders(&views, &direction, &MatchOptions::of(&views)).expect("cylinders");
    assert!(refined_matches(&views, &once, &[], Interrupt::never()).is_ok());
    let cylinders = (0..10_000).flat_map(|_| once.cylinders.clone()).collect();
    let matching = Matching { cylinders, ..once };
    let refined = interrupted(|interrupt| refined_matches(&views, &matching, &[], interrupt));
    assert_eq!(refined.err(), Some(Interrupted));
}

#[test]
fn photographs_of_noise_and_the_search_in_them() {
    let scene = clutter();
    let mut random = Random::new(1);
    let [width, height] = [4000, 3000];
    let noise = (0..width * height).map(|_| random.uniform(0.0, 255.0) as f32).collect();
    let image = GreyImage::new(width, height, noise).expect("an image");
    let camera = *scene.views[0].camera();
    let photograph = Photograph { name: "noise".to_owned(), camera, distortion: Distortion::default() };
    let lines =
        interrupted(|interrupt| seen(&photograph, &image, &LineOptions { interrupt, ..LineOptions::default() }));
    assert_eq!(lines.err(), Some(PhotoError::Interrupted(Interrupted)));

    let of_view = |view: &View| Seen { view: view.clone(), size: [width, height], ribbons: Vec::new() };
    let seen: Vec<Seen> = scene.views.iter().map(of_view).collect();
    for given in [None, Some(scene.direction)] {
        let found = interrupted(|interrupt| {
            let mut options = PhotoOptions::of(&scene.views);
            options.matching.lines = usize::MAX;
            options.matching.interrupt = interrupt;
            find_in_photographs(&seen, given, &options)
        });
        assert_eq!(found, Err(MatchError::Interrupted(Interrupted)));
    }
}
