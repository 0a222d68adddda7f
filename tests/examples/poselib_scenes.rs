//! Scenes with our solutions, one JSON object in each line, for `tests/poselib/compare.py`:
//!
//! ```text
//! {"case": "five", "family": "General", "data": [..], "truth": [..], "found": [..],
//!  "nanoseconds": 4300}
//! ```
//!
//! `data` and `truth` are those of the benchmark `peers`, `found` holds the solutions one after
//! the other, each as long as `truth`. The time is the shortest of three solves.

use std::error::Error;
use std::io::{self, BufWriter, Write};
use std::time::Instant;

use clap::Parser;
use eliminant_generator::algebra::Random;
use eliminant_tests::ground_truth::Motion;
use serde::Serialize;

#[allow(dead_code, unreachable_pub)]
#[path = "../benches/peers/ours/mod.rs"]
mod ours;
#[allow(dead_code, unreachable_pub)]
#[path = "../benches/peers/scenes.rs"]
mod scenes;

use ours::{Instance, absolute_pose, relative_pose};
use scenes::Scene;

/// Scenes of four problems, and special motions of two of them.
#[derive(Parser)]
struct Arguments {
    /// Scenes of each problem and of each motion.
    #[arg(long, default_value_t = 10_000)]
    instances: u64,
    /// Seed of the first scene.
    #[arg(long, default_value_t = 1)]
    seed: u64,
}

/// A line of the output.
#[derive(Serialize)]
struct Line<'a> {
    case: &'a str,
    family: &'a str,
    data: Vec<f64>,
    truth: Vec<f64>,
    found: Vec<f64>,
    nanoseconds: f64,
}

/// Where the lines go.
type Output<'a> = BufWriter<io::StdoutLock<'a>>;

/// Solves one scene and writes its line.
fn write<I: Instance>(out: &mut Output<'_>, case: &str, family: &str, scene: Scene) -> Result<(), Box<dyn Error>> {
    let instance = I::load(&scene.data);
    let (mut found, mut nanoseconds) = (Vec::with_capacity(1024), f64::INFINITY);
    for _ in 0..3 {
        found.clear();
        let start = Instant::now();
        instance.solve(&mut found);
        nanoseconds = nanoseconds.min(start.elapsed().as_secs_f64() * 1e9);
    }
    // JSON has no infinity: a solution that is not finite is none.
    let length = scene.truth.len();
    let finite = found.chunks_exact(length).filter(|solution| solution.iter().all(|x| x.is_finite()));
    let found = finite.flatten().copied().collect();
    let line = Line { case, family, data: scene.data, truth: scene.truth, found, nanoseconds };
    Ok(writeln!(out, "{}", serde_json::to_string(&line)?)?)
}

fn main() -> Result<(), Box<dyn Error>> {
    let Arguments { instances, seed } = Arguments::parse();
    let mut out = BufWriter::new(io::stdout().lock());
    let randoms = || (0..instances).map(move |k| Random::new(seed + k));
    for motion in Motion::ALL.into_iter().filter(|motion| *motion != Motion::Undistorted) {
        let family = format!("{motion:?}");
        for mut random in randoms() {
            let scene = scenes::five_points_of(&mut random, motion);
            write::<relative_pose::FivePoint>(&mut out, "five", &family, scene)?;
        }
    }
    for motion in Motion::ALL.into_iter().filter(|motion| *motion != Motion::Undistorted) {
        let family = format!("{motion:?}");
        for mut random in randoms() {
            let scene = scenes::six_points_focal_of(&mut random, motion);
            write::<relative_pose::SixPointFocal>(&mut out, "six", &family, scene)?;
        }
    }
    for mut random in randoms() {
        write::<absolute_pose::ThreePoint>(&mut out, "three", "General", scenes::three_points(&mut random))?;
    }
    for mut random in randoms() {
        let scene = scenes::four_points_focal(&mut random);
        write::<absolute_pose::ThreeAndAHalfPoint>(&mut out, "four", "General", scene)?;
    }
    out.flush()?;
    Ok(())
}
