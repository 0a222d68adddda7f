//! Cylinders that were found are refined together: with one direction where they have one, with
//! their own where they have not.

#![cfg(feature = "command")]

#[path = "../examples/make_scene/random.rs"]
mod random;
#[path = "../examples/make_scene/scene.rs"]
#[allow(dead_code, reason = "scene files are not written here")]
mod scene;
mod scenes;

use eliminant_cylinders::matching::{RefinedMatch, refined_matches};
use eliminant_cylinders::simulation::ParallelSetup;
use eliminant_cylinders::{
    Cylinder, Estimate, Interrupt, MatchOptions, MatchedCylinder, Matching, View, estimate_from, match_cylinders,
};
use nalgebra::{Point3, Unit, Vector3};
use random::Random;
use scene::{Can, Setup};

fn angle(cylinder: &Cylinder, direction: &Unit<Vector3<f64>>) -> f64 {
    cylinder.direction.cross(direction).norm().asin()
}

fn estimates(refined: &[RefinedMatch]) -> Vec<&Estimate> {
    refined.iter().map(|one| one.estimate.as_ref().expect("a refined cylinder")).collect()
}

/// Seven parallel cylinders in twelve images: the direction is known better by all of them.
#[test]
fn parallel_cylinders_share_their_direction() {
    let setup = ParallelSetup { outlier_rate: 0.86, ..ParallelSetup::seven_in_twelve() };
    let (mut alone, mut shared, mut parallel) = (0.0, 0.0, 0);
    for seed in 0..30 {
        let scene = setup.scene(seed).expect("a scene");
        let options = MatchOptions { count: Some(7), ..MatchOptions::of(&scene.views) };
        let matching = match_cylinders(&scene.views, &scene.direction, &options).expect("cylinders");
        let refined = refined_matches(&scene.views, &matching, &[], Interrupt::never()).expect("the end");
        let estimates = estimates(&refined);
        parallel += usize::from(refined.iter().all(|one| one.is_parallel));
        for (one, (found, estimate)) in refined.iter().zip(matching.cylinders.iter().zip(estimates)) {
            let own = estimate_from(&one.lines.views, &found.cylinder).expect("a refined cylinder");
            alone += angle(&own.cylinder, &scene.direction).powi(2);
            shared += angle(&estimate.cylinder, &scene.direction).powi(2);
        }
    }
    println!("{parallel} of 30 scenes parallel; the squared error of the direction falls by {:.1}", alone / shared);
    assert!(parallel >= 28 && shared < alone / 3.0);
}

/// Cans in images of their own, each turned by up to so many radians; points on them.
fn turned(turn: f64, random: &mut Random) -> (Vec<Can>, Vec<View>, Matching, Vec<Point3<f64>>) {
    let first = scene::soda_can();
    let setup = Setup { cameras: 6, noise: 1.0, ..scene::soda_can_setup() };
    let (mut cans, mut views, mut points) = (Vec::new(), Vec::new(), Vec::new());
    for index in 0..3 {
        let by = Vector3::from_fn(|_, _| random.uniform(-turn, turn));
        let direction = Unit::new_normalize(first.direction.into_inner() + by);
        let can = Can { base: first.base + Vector3::x() * (300.0 * f64::from(index)), direction, ..first };
        let photographs = scene::photographs(&can, &setup, random);
        views.extend(photographs.iter().map(|photograph| {
            let segments =
                [1.0, -1.0].map(|side| scenes::silhouette(&can, &setup, photograph, (side, [0.0, 1.0]), random));
            let camera = *scenes::view(&setup, &photograph.camera, &[]).camera();
            View::from_pixel_segments(camera, &segments).expect("segments")
        }));
        for _ in 0..60 {
            let around = Unit::new_normalize(direction.cross(&Vector3::from_fn(|_, _| random.normal())));
            let noise = Vector3::from_fn(|_, _| 0.2 * random.normal());
            let surface = around.into_inner() * can.radius + direction.into_inner() * random.uniform(0.0, can.height);
            points.push(can.base + surface + noise);
        }
        cans.push(can);
    }
    let found = |(index, can): (usize, &Can)| {
        // As the search leaves them: of one direction.
        let cylinder = Cylinder::new(&can.base, first.direction, can.radius);
        let of_view = |view: usize| cylinder.residuals(view, &views[view]).expect("cameras outside");
        let matches = (6 * index..6 * (index + 1)).flat_map(of_view).collect();
        MatchedCylinder { cylinder, rms: 0.0, matches, outlier_rate: 0.0, false_alarms: 0.0 }
    };
    let cylinders = cans.iter().enumerate().map(found).collect();
    let matching = Matching { directions: vec![first.direction], cylinders, unmatched: Vec::new(), least_support: 4 };
    (cans, views, matching, points)
}

#[test]
fn cylinders_that_are_not_parallel_keep_their_directions() {
    for (turn, is_parallel) in [(0.0, true), (0.03, false)] {
        let mut right = 0;
        for seed in 0..100 {
            let (cans, views, matching, points) = turned(turn, &mut Random::new(seed));
            let refined = refined_matches(&views, &matching, &[], Interrupt::never()).expect("the end");
            right += usize::from(refined.iter().all(|one| one.is_parallel == is_parallel));
            let with_points = refined_matches(&views, &matching, &points, Interrupt::never()).expect("the end");
            for (can, (of_lines, of_both)) in
                cans.iter().zip(estimates(&refined).into_iter().zip(estimates(&with_points)))
            {
                // Directions that differ by less than the noise may be taken as one.
                let [lines, both] = [of_lines, of_both].map(|estimate| angle(&estimate.cylinder, &can.direction));
                assert!(lines < 0.015 && both < 0.015, "{seed}: {lines} {both}");
                assert!(of_both.surface_points.is_some_and(|found| found.count > 15.0), "{seed}");
            }
        }
        println!("turned by up to {turn}: {right} of 100 right");
        assert!(right >= 95, "{turn}: {right}");
    }
}
