//! Matching without correspondences: simulated scenes of several cylinders, the exhaustive search
//! itself, and invalid input.

#![cfg(feature = "command")]

use std::cell::Cell;
use std::sync::atomic::{AtomicUsize, Ordering};

use eliminant_cylinders::simulation::{ParallelScene, ParallelSetup};
use eliminant_cylinders::{
    Camera, Cylinder, DistanceUnit, Interrupted, LineResidual, MatchError, MatchOptions, MatchedCylinder, Matching,
    Progress, References, Side, View, default_direction_options, estimate_direction_robustly, match_cylinders,
    match_cylinders_with, match_with_wider_bound,
};
use nalgebra::{Matrix3x4, Unit, Vector3};

fn scene(setup: &ParallelSetup, seed: u64) -> ParallelScene {
    setup.scene(seed).expect("a scene")
}

/// For each cylinder of the scene, the model with most of its silhouettes, whose matches are mostly
/// these, on the right sides.
fn found(scene: &ParallelScene, matching: &Matching) -> Vec<Option<usize>> {
    let of_cylinder = |index: usize| {
        let silhouettes = scene.truth.iter().flatten().flatten().filter(|(cylinder, _)| *cylinder == index).count();
        let shows = |line: &&LineResidual| scene.truth[line.view][line.line] == Some((index, line.side));
        matching.cylinders.iter().position(|model| {
            let right = model.matches.iter().filter(shows).count();
            2 * right > silhouettes && 2 * right > model.matches.len()
        })
    };
    (0..scene.cylinders.len()).map(of_cylinder).collect()
}

fn matched(views: &[View], direction: &Unit<Vector3<f64>>) -> Matching {
    match_cylinders(views, direction, &MatchOptions::of(views)).expect("cylinders")
}

#[test]
fn seven_cylinders_are_found_in_twelve_images_and_nothing_else() {
    let setup = ParallelSetup::seven_in_twelve();
    for seed in 0..20 {
        let scene = scene(&setup, seed);
        let options = MatchOptions { count: Some(7), ..MatchOptions::of(&scene.views) };
        let matching = match_cylinders(&scene.views, &scene.direction, &options).expect("cylinders");
        let models = found(&scene, &matching);
        assert!(models.iter().all(Option::is_some), "seed {seed}: {models:?}");
        let lines: usize = scene.truth.iter().map(Vec::len).sum();
        let silhouettes = scene.truth.iter().flatten().flatten().count();
        let outlier_rate = 1.0 - silhouettes as f64 / (7 * lines) as f64;
        assert!(outlier_rate >= 0.89, "seed {seed}: {outlier_rate}");
    }
}

#[test]
fn told_nothing_the_search_finds_all_seven_and_hardly_anything_else() {
    let setup = ParallelSetup::seven_in_twelve();
    let (mut complete, mut cylinders) = (0, 0);
    for seed in 100..130 {
        let scene = scene(&setup, seed);
        let planes: Vec<_> = scene.views.iter().flat_map(View::planes).collect();
        let direction = estimate_direction_robustly(&planes, &default_direction_options()).expect("a direction");
        let matching = matched(&scene.views, &direction.direction.direction);
        // Axis and radius within a tenth of the radius.
        let is_found = |truth: &Cylinder| {
            let middle = truth.axis_at(truth.height(&scene.middle));
            matching.cylinders.iter().any(|MatchedCylinder { cylinder, .. }| {
                let axis = cylinder.distance(&middle) + cylinder.radius;
                axis.max((cylinder.radius - truth.radius).abs()) < 0.1 * truth.radius
            })
        };
        complete += usize::from(scene.cylinders.iter().all(is_found));
        cylinders += matching.cylinders.len();
        for cylinder in &matching.cylinders {
            assert!(cylinder.false_alarms <= 1.0, "seed {seed}");
        }
    }
    // One cylinder in a hundred may be missed, and at most one cylinder by chance is allowed in
    // each scene.
    assert!(complete >= 29, "{complete} of 30");
    assert!(cylinders <= 7 * 30 + 3, "{cylinders}");
}

/// Half of the silhouettes are not detected: a cylinder has nine lines on average, some have four.
#[test]
fn cylinders_with_few_lines_are_found_where_chance_does_not_give_them() {
    let setup = ParallelSetup { detection: 0.5, ..ParallelSetup::seven_in_twelve() };
    let (mut right, mut others) = (0, 0);
    for seed in 0..12 {
        let scene = scene(&setup, seed);
        let Ok(matching) = match_cylinders(&scene.views, &scene.direction, &MatchOptions::of(&scene.views)) else {
            continue;
        };
        let of_scene = found(&scene, &matching).iter().flatten().count();
        right += of_scene;
        others += matching.cylinders.len() - of_scene;
    }
    println!("{right} of {} found, {others} others", 7 * 12);
    // A bound on chance, in place of its distribution, lets 24 of them stand out.
    assert!(right >= 42 && others <= 2, "{right} {others}");
}

#[test]
fn the_bound_is_doubled_where_noise_fills_it_and_what_chance_gives_less_often_is_taken() {
    let of_noise = |noise: f64| {
        let scene = scene(&ParallelSetup { noise, ..ParallelSetup::seven_in_twelve() }, 3);
        let options = MatchOptions::of(&scene.views);
        let calls = Cell::new(0);
        let search = |options: &MatchOptions| {
            calls.set(calls.get() + 1);
            match_cylinders(&scene.views, &scene.direction, options)
        };
        let (bound, matching) = match_with_wider_bound(&scene.views, &options, search).expect("cylinders");
        let right = found(&scene, &matching).iter().flatten().count();
        (bound / options.threshold, right, calls.get())
    };
    assert_eq!(of_noise(0.25), (1.0, 7, 1));
    let (factor, right, calls) = of_noise(3.0);
    assert!(factor == 2.0 && right >= 5 && calls == 2, "{right}");
    // Where half of the silhouettes are missing, the wider bound is tried and lets chance in.
    let scene = scene(&ParallelSetup { detection: 0.5, ..ParallelSetup::seven_in_twelve() }, 4);
    let search = |options: &MatchOptions| match_cylinders(&scene.views, &scene.direction, options);
    let options = MatchOptions::of(&scene.views);
    let (_, matching) = match_with_wider_bound(&scene.views, &options, search).expect("cylinders");
    let evidence = |matching: &Matching| -> f64 { matching.cylinders.iter().map(|one| -one.false_alarms.ln()).sum() };
    let wider = MatchOptions { threshold: 2.0 * options.threshold, ..options };
    let each = [options, wider].map(|options| search(&options).map_or(0.0, |matching| evidence(&matching)));
    assert_eq!(evidence(&matching), each[0].max(each[1]), "{each:?}");
    // What a wider bound cannot mend is said at once. If both searches fail, the error is that of
    // the bound that the user knows, but an interruption of the second ends it.
    let fails = |first: MatchError, second: MatchError| {
        let is_wider = |tried: &MatchOptions| tried.threshold > options.threshold;
        let search = |tried: &MatchOptions| Err(if is_wider(tried) { second } else { first });
        match_with_wider_bound(&scene.views, &options, search).expect_err("an error")
    };
    let none = MatchError::NoCylinder { least_support: 4, lines: 9 };
    let interrupted = MatchError::Interrupted(Interrupted);
    assert_eq!(fails(MatchError::NoPair, none), MatchError::NoPair);
    assert_eq!(fails(none, MatchError::NoPair), none);
    assert_eq!(fails(none, interrupted), interrupted);
}

#[test]
fn progress_counts_pairs_and_cylinders() {
    let scene = scene(&ParallelSetup::seven_in_twelve(), 2);
    let (announced, searched, found) = (AtomicUsize::new(0), AtomicUsize::new(0), AtomicUsize::new(0));
    let count = |progress| {
        let _ = match progress {
            Progress::Pairs(pairs) => announced.fetch_add(pairs, Ordering::Relaxed),
            Progress::Pair => searched.fetch_add(1, Ordering::Relaxed),
            Progress::Cylinder => found.fetch_add(1, Ordering::Relaxed),
        };
    };
    let options = MatchOptions::of(&scene.views);
    let matching = match_cylinders_with(&scene.views, &scene.direction, &options, &count).expect("cylinders");
    let [announced, searched, found] = [announced, searched, found].map(AtomicUsize::into_inner);
    assert!(announced > 0 && announced == searched);
    assert_eq!(found, matching.cylinders.len());
}

#[test]
fn without_a_number_nothing_is_found_by_chance() {
    let setup = ParallelSetup { cylinders: 3, images: 8, noise: 0.5, detection: 0.9, outlier_rate: 0.8 };
    for seed in 0..10 {
        let scene = scene(&setup, seed);
        let matching = matched(&scene.views, &scene.direction);
        let models = found(&scene, &matching);
        assert_eq!(matching.cylinders.len(), 3, "seed {seed}");
        for (expected, model) in scene.cylinders.iter().zip(models) {
            let found = &matching.cylinders[model.expect("a model")].cylinder;
            let axis = found.distance(&expected.axis_point) + found.radius;
            // Noise of half a pixel is about 0.005 at the distance of the cylinders.
            assert!(
                axis < 0.03 && (found.radius - expected.radius).abs() < 0.03,
                "seed {seed}: {found:?} {expected:?}"
            );
        }
    }
}

#[test]
fn every_line_is_a_match_of_one_cylinder_or_of_none() {
    let scene = scene(&ParallelSetup::seven_in_twelve(), 3);
    let matching = matched(&scene.views, &scene.direction);
    let mut lines: Vec<_> =
        matching.cylinders.iter().flat_map(|model| &model.matches).map(|line| (line.view, line.line)).collect();
    for model in &matching.cylinders {
        let mut silhouettes: Vec<_> = model.matches.iter().map(|line| (line.view, line.side == Side::Left)).collect();
        silhouettes.sort_unstable();
        silhouettes.dedup();
        assert_eq!(silhouettes.len(), model.matches.len(), "two lines on one side in one view");
        assert!(model.matches.len() >= matching.least_support);
        for line in &model.matches {
            let residuals = model.cylinder.residuals(line.view, &scene.views[line.view]).expect("a camera outside");
            assert_eq!(residuals[line.line].side, line.side);
        }
    }
    lines.extend(matching.unmatched.iter().map(|line| (line.view, line.line)));
    lines.sort_unstable();
    let all = scene.truth.iter().enumerate().flat_map(|(view, lines)| (0..lines.len()).map(move |line| (view, line)));
    assert_eq!(lines, all.collect::<Vec<_>>());
}

#[test]
fn the_number_of_threads_does_not_matter() {
    let scene = scene(&ParallelSetup::seven_in_twelve(), 4);
    let with_threads = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| matched(&scene.views, &scene.direction))
    };
    assert_eq!(with_threads(1), with_threads(3));
}

#[test]
fn a_cylinder_that_the_first_image_does_not_show_is_found_from_another() {
    let setup = ParallelSetup { cylinders: 2, images: 8, noise: 0.5, detection: 1.0, outlier_rate: 0.8 };
    let scene = scene(&setup, 1);
    let mut views = scene.views.clone();
    // Of the first image only one silhouette of the second cylinder is left.
    let kept: Vec<_> =
        (0..views[0].lines().len()).filter(|&line| scene.truth[0][line] != Some((1, Side::Left))).collect();
    let lines: Vec<_> = kept.iter().map(|&line| views[0].lines()[line]).collect();
    views[0] = View::from_normalised_lines(*views[0].camera(), &lines).expect("lines");
    let count = |references| {
        let options = MatchOptions { references, ..MatchOptions::of(&views) };
        match_cylinders(&views, &scene.direction, &options).expect("cylinders").cylinders.len()
    };
    assert_eq!((count(References::First), count(References::Every)), (1, 2));
}

/// Lines that lie along a silhouette in the cross-section may be tilted in the image.
#[test]
fn matches_are_within_the_threshold_in_the_image() {
    let setup = ParallelSetup { noise: 3.0, ..ParallelSetup::seven_in_twelve() };
    let mut matches = 0;
    for seed in 0..10 {
        let scene = scene(&setup, seed);
        for threshold in [3.0, 9.0] {
            for count in [None, Some(3)] {
                let options = MatchOptions { threshold, count, ..MatchOptions::of(&scene.views) };
                let Ok(matching) = match_cylinders(&scene.views, &scene.direction, &options) else { continue };
                for cylinder in &matching.cylinders {
                    assert!(cylinder.matches.len() >= 4 && cylinder.false_alarms.is_finite(), "{cylinder:?}");
                    let pixels = |line: &LineResidual| line.pixels.expect("a calibration");
                    assert!(cylinder.matches.iter().all(|line| pixels(line) <= threshold), "{cylinder:?}");
                    matches += cylinder.matches.len();
                }
            }
        }
    }
    assert!(matches > 500, "{matches}");
}

#[test]
fn bad_input_is_a_typed_error() {
    // Little noise, so that no silhouette is at the threshold.
    let scene = scene(&ParallelSetup { noise: 0.25, ..ParallelSetup::seven_in_twelve() }, 5);
    let options = MatchOptions::of(&scene.views);
    let fails = |views: &[View], direction: &Unit<Vector3<f64>>, options: &MatchOptions| {
        match_cylinders(views, direction, options).expect_err("an error")
    };
    for threshold in [0.0, -1.0, f64::NAN, f64::INFINITY, 500.0] {
        let options = MatchOptions { threshold, ..options };
        assert!(matches!(fails(&scene.views, &scene.direction, &options), MatchError::Threshold { view: 0, .. }));
    }
    let few = MatchOptions { least_support: Some(3), ..options };
    assert_eq!(fails(&scene.views, &scene.direction, &few), MatchError::LeastSupport { least_support: 3 });
    assert_eq!(fails(&[], &scene.direction, &options), MatchError::TooFewViews { views: 0 });
    assert_eq!(fails(&scene.views[..1], &scene.direction, &options), MatchError::TooFewViews { views: 1 });

    // Across the axes there are no lines in the images of two neighbours.
    let across = Unit::new_normalize(scene.views[0].camera().rotation().row(0).transpose());
    assert_eq!(fails(&scene.views[..2], &across, &options), MatchError::TooFewViews { views: 0 });

    let same: Vec<_> = (0..3).map(|_| scene.views[0].clone()).collect();
    assert_eq!(fails(&same, &scene.direction, &options), MatchError::SingleViewpoint);

    let bare = |view: &View| {
        let camera = view.camera();
        let matrix = Matrix3x4::from_fn(|row, column| match column {
            3 => camera.translation()[row],
            _ => camera.rotation()[(row, column)],
        });
        let camera = Camera::from_normalised(&matrix).expect("a camera");
        View::from_normalised_lines(camera, view.lines()).expect("lines")
    };
    let uncalibrated: Vec<_> = scene.views.iter().map(bare).collect();
    assert_eq!(fails(&uncalibrated, &scene.direction, &options), MatchError::NoCalibration { view: 0 });
    // The threshold in radians describes the same scene.
    let radians = MatchOptions { unit: DistanceUnit::Radians, threshold: 0.003, ..options };
    let matching = match_cylinders(&uncalibrated, &scene.direction, &radians).expect("cylinders");
    // A line at the threshold may be within the one and not the other.
    let in_pixels = matched(&scene.views, &scene.direction);
    let differ =
        |one: &Matching, other: &Matching| one.unmatched.iter().filter(|line| !other.unmatched.contains(line)).count();
    assert_eq!(matching.cylinders.len(), in_pixels.cylinders.len());
    assert!(differ(&matching, &in_pixels) + differ(&in_pixels, &matching) <= 1);
    for (one, other) in matching.cylinders.iter().zip(&in_pixels.cylinders) {
        let [one, other] = [one.cylinder, other.cylinder];
        let axis = one.distance(&other.axis_point) + one.radius;
        assert!(axis < 0.01 && (one.radius - other.radius).abs() < 0.01, "{one:?} {other:?}");
    }

    let one_each: Vec<_> = scene.views.iter().map(|view| with_camera(view, &view.lines()[..1])).collect();
    assert_eq!(fails(&one_each, &scene.direction, &options), MatchError::NoPair);
    let alone: Vec<_> = scene.views.iter().take(2).map(|view| with_camera(view, &view.lines()[..2])).collect();
    assert!(matches!(fails(&alone, &scene.direction, &options), MatchError::NoCylinder { lines: 4, .. }));
}

/// The camera of a view with other lines.
fn with_camera(view: &View, lines: &[Vector3<f64>]) -> View {
    View::from_normalised_lines(*view.camera(), lines).expect("lines")
}
