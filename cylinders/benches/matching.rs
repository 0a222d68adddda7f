//! The time of matching: twelve images with 24, 50, 100 and 200 lines each, among them the
//! silhouettes of seven cylinders, whose end points are off by noise of a quarter and of a tenth of
//! a pixel. Prints the median over scenes, the cylinders found and the false ones.
//!
//! `cargo bench -p eliminant-cylinders --bench matching [LINES...]`

use std::time::Instant;

use eliminant_cylinders::simulation::{ParallelScene, ParallelSetup};
use eliminant_cylinders::{Cylinder, MatchOptions, MatchedCylinder, match_cylinders};

const SCENES: u64 = 3;
const NOISE: [f64; 2] = [0.25, 0.1];
const LINES: [usize; 4] = [24, 50, 100, 200];

/// A scene with about this number of lines in each image.
fn scene(lines: usize, noise: f64, seed: u64) -> ParallelScene {
    let paper = ParallelSetup { noise, ..ParallelSetup::seven_in_twelve() };
    // Without clutter there are only silhouettes, whose number decides the rate of outliers.
    let bare = ParallelSetup { outlier_rate: 0.0, ..paper }.scene(seed).expect("a scene");
    let silhouettes = bare.truth.iter().flatten().count() as f64;
    let outlier_rate = 1.0 - silhouettes / (paper.cylinders * paper.images * lines) as f64;
    ParallelSetup { outlier_rate, ..paper }.scene(seed).expect("a scene")
}

/// Whether axis and radius are off by less than a tenth of the radius.
fn is_found(scene: &ParallelScene, truth: &Cylinder, found: &MatchedCylinder) -> bool {
    let axis = found.cylinder.distance(&truth.axis_at(truth.height(&scene.middle))) + found.cylinder.radius;
    axis.max((found.cylinder.radius - truth.radius).abs()) < 0.1 * truth.radius
}

fn main() {
    let asked: Vec<usize> = std::env::args().filter_map(|argument| argument.parse().ok()).collect();
    let lines = if asked.is_empty() { LINES.to_vec() } else { asked };
    for (lines, noise) in lines.iter().flat_map(|&lines| NOISE.map(|noise| (lines, noise))) {
        let (mut times, mut cylinders, mut right) = (Vec::new(), 0, 0);
        for seed in 0..SCENES {
            let scene = scene(lines, noise, seed);
            let start = Instant::now();
            let found = match_cylinders(&scene.views, &scene.direction, &MatchOptions::of(&scene.views));
            times.push(start.elapsed().as_secs_f64());
            let found = found.map(|matching| matching.cylinders).unwrap_or_default();
            cylinders += found.len();
            let is_right = |truth: &&Cylinder| found.iter().any(|found| is_found(&scene, truth, found));
            right += scene.cylinders.iter().filter(is_right).count();
        }
        times.sort_by(f64::total_cmp);
        println!(
            "{lines} lines in each image, {noise} pixels: {:.2} s (median of {SCENES} scenes), {right} of {} cylinders found, {} others",
            times[times.len() / 2],
            7 * SCENES,
            cylinders - right.min(cylinders),
        );
    }
}
