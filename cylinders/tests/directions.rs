//! Matching of cylinders of several directions: all are found, and hardly anything else.

#![cfg(feature = "command")]

use eliminant_cylinders::simulation::{ParallelScene, ParallelSetup};
use eliminant_cylinders::{
    Cylinder, MatchError, MatchOptions, Matching, View, match_cylinders, match_directions, match_directions_with,
};

fn scene(directions: usize, seed: u64) -> ParallelScene {
    let setup = ParallelSetup { noise: 0.5, ..ParallelSetup::seven_in_twelve() };
    setup.scene_of_directions(directions, seed).expect("a scene")
}

/// Axis, in the middle of the scene, and radius within a tenth of the radius, direction within a
/// hundredth.
fn is_same(found: &Cylinder, truth: &Cylinder, scene: &ParallelScene) -> bool {
    let middle = truth.axis_at(truth.height(&scene.middle));
    let axis = found.distance(&middle) + found.radius;
    axis.max((found.radius - truth.radius).abs()) < 0.1 * truth.radius
        && found.direction.cross(&truth.direction).norm() < 0.01
}

/// Numbers of cylinders that are found, and of others.
fn right_and_false(matching: &Matching, scene: &ParallelScene) -> [usize; 2] {
    let is_found = |truth: &&Cylinder| matching.cylinders.iter().any(|found| is_same(&found.cylinder, truth, scene));
    let right = scene.cylinders.iter().filter(is_found).count();
    [right, matching.cylinders.len() - right]
}

#[test]
fn cylinders_of_two_and_four_directions_are_found_and_hardly_anything_else() {
    let mut others = 0;
    for directions in [2, 4] {
        for seed in 0..10 {
            let scene = scene(directions, seed);
            let matching = match_directions(&scene.views, &MatchOptions::of(&scene.views)).expect("cylinders");
            let [right, of_scene] = right_and_false(&matching, &scene);
            assert_eq!(right, 7, "{directions} directions, seed {seed}");
            others += of_scene;
            for truth in &scene.directions {
                assert!(matching.directions.iter().any(|found| found.cross(truth).norm() < 0.005), "seed {seed}");
            }
        }
    }
    // Chance may give one cylinder in each of the 60 searches along a direction.
    println!("{others} others in 20 scenes");
    assert!(others <= 3, "{others}");
}

#[test]
fn a_line_is_used_once_and_those_of_no_cylinder_are_listed() {
    let scene = scene(4, 7);
    let matching = match_directions(&scene.views, &MatchOptions::of(&scene.views)).expect("cylinders");
    let matches = matching.cylinders.iter().flat_map(|found| &found.matches).map(|line| (line.view, line.line));
    let mut lines: Vec<_> = matches.chain(matching.unmatched.iter().map(|line| (line.view, line.line))).collect();
    lines.sort_unstable();
    let of_view = |(view, lines): (usize, &View)| (0..lines.lines().len()).map(move |line| (view, line));
    assert_eq!(lines, scene.views.iter().enumerate().flat_map(of_view).collect::<Vec<_>>());
    for found in &matching.cylinders {
        assert!(found.false_alarms <= 1.0 && found.matches.len() >= matching.least_support);
        assert!(matching.directions.contains(&found.cylinder.direction));
        let expected = 1.0 - found.matches.len() as f64 / lines.len() as f64;
        assert!((found.outlier_rate - expected).abs() < 1e-12);
    }
}

#[test]
fn the_number_of_directions_may_be_limited_and_no_cylinder_is_an_error() {
    let scene = scene(4, 1);
    let options = MatchOptions::of(&scene.views);
    let along = |views: &[View], direction: &_| match_cylinders(views, direction, &options);
    let matching = match_directions_with(&scene.views, 2, &options, along).expect("cylinders");
    assert_eq!(matching.directions.len(), 2);
    let none = MatchOptions { least_support: Some(25), ..options };
    assert!(matches!(match_directions(&scene.views, &none), Err(MatchError::NoCylinder { .. })));
    assert!(matches!(match_directions(&[], &options), Err(MatchError::TooFewViews { views: 0 })));
}
