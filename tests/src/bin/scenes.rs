//! Writes scenes of the catalogue's problems, and special motions, as a file of instances that
//! `eliminant stability templates --instances FILE` reads.
//!
//! ```text
//! cargo run --release -p eliminant-tests --bin scenes -- --instances 100 > scenes.jsonl
//! ```
//!
//! Known solutions are written where they are values of the unknowns that a solver returns. Scenes
//! whose known solution is something else, such as an essential matrix, come without.

use std::error::Error;
use std::io::{self, BufWriter, Write};

use clap::Parser;
use eliminant_generator::algebra::Random;
use eliminant_tests::ground_truth::{KnownInstance, Make, Motion, makers};
use eliminant_tests::statistics::complex;
use eliminant_tests::{Case, cases};
use serde::Serialize;

/// Scenes of the catalogue's problems, and special motions, one JSON object in each line.
#[derive(Parser)]
struct Arguments {
    /// Only these problems.
    problems: Vec<String>,
    /// Scenes of each problem, and of each motion.
    #[arg(long, default_value_t = 100)]
    instances: u64,
    /// Seed of the first instance.
    #[arg(long, default_value_t = 1)]
    seed: u64,
}

/// A line of the file.
#[derive(Serialize)]
struct Line<'a> {
    problem: &'a str,
    family: &'a str,
    data: Vec<f64>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    solutions: Vec<Vec<f64>>,
}

/// The relative residual of a known solution is at most this: it is known to the precision of
/// `f64`, and some digits are lost where it is made.
const EXACT: f64 = 1e-10;

/// Whether a truth is a solution, in the unknowns that are solved for.
fn is_solution(case: &Case, data: &[f64], unknowns: usize, truth: &[f64]) -> bool {
    let residual = || (case.residual)(data, &complex(truth));
    truth.len() == unknowns && residual().is_ok_and(|residual| residual <= EXACT)
}

fn line<'a>(case: &Case, family: &'a str, instance: KnownInstance) -> Line<'a> {
    let unknowns = case.problem().unknowns.len();
    let KnownInstance { data, truths } = instance;
    let solutions = truths.into_iter().filter(|truth| is_solution(case, &data, unknowns, truth)).collect();
    Line { problem: case.name, family, data, solutions }
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments = Arguments::parse();
    let mut out = BufWriter::new(io::stdout().lock());
    let mut write =
        |line: &Line<'_>| -> Result<(), Box<dyn Error>> { Ok(writeln!(out, "{}", serde_json::to_string(line)?)?) };
    let is_wanted = |name: &str| arguments.problems.is_empty() || arguments.problems.iter().any(|p| p == name);
    let cases = cases();
    if let Some(unknown) = arguments.problems.iter().find(|name| !cases.iter().any(|case| case.name == **name)) {
        return Err(format!("there is no problem `{unknown}` in the catalogue").into());
    }
    for maker in makers().iter().filter(|maker| is_wanted(maker.name)) {
        let Some(case) = cases.iter().find(|case| case.name == maker.name) else { continue };
        for k in 0..arguments.instances {
            write(&line(case, "scene", maker.make.draw(&mut Random::new(arguments.seed + k))))?;
        }
        let Make::TwoCameras(make) = maker.make else { continue };
        for motion in Motion::ALL.into_iter().filter(|motion| *motion != Motion::General) {
            let family = format!("{motion:?}");
            for k in 0..arguments.instances {
                write(&line(case, &family, make(&mut Random::new(arguments.seed + k), motion)))?;
            }
        }
    }
    out.flush()?;
    Ok(())
}
