//! The time of a robust estimate: 1,000 lines, of which 70 % are not silhouettes, seen by 150
//! cameras. Prints the median over scenes, with and without a known direction, the samples drawn
//! and the scenes whose radius is within 5 % of the truth.
//!
//! `cargo bench -p eliminant-cylinders --bench robust --no-default-features`
//!
//! Against commit 492d224, to which this file was copied with its section of the manifest: 6.80 ms
//! and 3.23 ms there, 2.14 ms and 1.49 ms here, 3.2 and 2.2 times as fast. These are medians of
//! nine runs in turns, each alone on a core of AMD EPYC (`chrt -f 10`), 2026-11-28. Both draw 255
//! samples, and find the radius in all scenes.

#[path = "../examples/make_scene/random.rs"]
#[allow(dead_code, reason = "shared with tests that use more")]
mod random;
#[path = "../examples/make_scene/scene.rs"]
#[allow(dead_code, reason = "scene files are not written here")]
mod scene;

use std::time::Instant;

use eliminant_cylinders::{Calibration, Camera, RansacOptions, RobustOptions, View, triangulate_robustly};
use nalgebra::Vector3;
use random::Random;
use scene::{Setup, photographs, soda_can, soda_can_setup};

const SCENES: u64 = 31;
const CAMERAS: usize = 150;
const LINES: usize = 1000;

/// Views of a soda can: both silhouettes of each camera, whose end points are off by a pixel, among
/// lines through two points anywhere in the image.
fn views(random: &mut Random) -> Vec<View> {
    let setup = Setup { cameras: CAMERAS, noise: 1.0, ..soda_can_setup() };
    let calibration = Calibration::new(&setup.calibration).expect("a calibration");
    let photographs = photographs(&soda_can(), &setup, random);
    let outliers = LINES - 2 * CAMERAS;
    let view = |(index, photograph): (usize, &scene::Photograph)| {
        let mut lines = photograph.lines.to_vec();
        for _ in outliers * index / CAMERAS..outliers * (index + 1) / CAMERAS {
            let mut point = || Vector3::new(random.uniform(0.0, 4000.0), random.uniform(0.0, 3000.0), 1.0);
            lines.push(point().cross(&point()));
        }
        let camera = Camera::from_normalised(&photograph.camera).expect("a camera").with_calibration(calibration);
        View::from_pixel_lines(camera, &lines).expect("lines")
    };
    photographs.iter().enumerate().map(view).collect()
}

fn main() {
    for is_direction_known in [false, true] {
        let (mut times, mut samples, mut found) = (Vec::new(), 0, 0);
        for seed in 0..SCENES {
            let views = views(&mut Random::new(seed));
            let options = RobustOptions::of(&views);
            let options = RobustOptions {
                ransac: RansacOptions { seed, ..options.ransac },
                direction: is_direction_known.then_some(soda_can().direction),
                ..options
            };
            let start = Instant::now();
            let result = triangulate_robustly(&views, &options);
            times.push(start.elapsed().as_secs_f64() * 1e3);
            if let Ok(result) = result {
                samples += result.samples;
                found += usize::from((result.refinement.cylinder.radius / soda_can().radius - 1.0).abs() < 0.05);
            }
        }
        times.sort_by(f64::total_cmp);
        println!(
            "{}: {:.2} ms (median of {SCENES} scenes), {:.0} samples on average, radius within 5 % in {found}",
            if is_direction_known { "direction known" } else { "direction unknown" },
            times[times.len() / 2],
            samples as f64 / SCENES as f64,
        );
    }
}
