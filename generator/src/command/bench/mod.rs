//! `eliminant bench`: compiles emitted solvers and times them.

mod timing_crate;

use std::fmt;
use std::path::PathBuf;
use std::time::Instant;

use serde::Serialize;

use self::timing_crate::{Subject, Times, TimingCrate};
use super::error::CommandError;
use super::files::Loaded;
use super::report::{Output, seconds};
use crate::algebra::Random;
use crate::expression::arithmetic::Float64;
use crate::generate::generate;
use crate::problem::instance::draw_inputs;

/// Compile solvers and measure the time of a solve
#[derive(clap::Args, Debug)]
#[command(
    after_help = "Emits the solvers, compiles them in a crate of their own in a temporary folder, and runs them on instances drawn
on the variety of the data. All solvers take turns in one process, so that a drifting clock hits all alike: several
templates of one problem, in folders of their own, are compared with each other.

Needs cargo, and the runtime crate `eliminant`: that of the checkout in which the first problem stands,
that of --runtime, or else the published one of this version.

Example:
  eliminant bench problems/two_circles.rs smaller/two_circles.rs --instances 2000"
)]
pub(super) struct Arguments {
    /// The problem files, NAME.rs, each with its template NAME.template.toml beside it
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// Number of random instances
    #[arg(long, value_name = "N", default_value_t = 1000, value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    instances: u64,
    /// Number of rounds; times are medians over them
    #[arg(long, value_name = "R", default_value_t = 21, value_parser = clap::value_parser!(u64).range(1..=10_000))]
    rounds: u64,
    /// Seed of the instances
    #[arg(long, value_name = "S", default_value_t = 1)]
    seed: u64,
    /// The folder of the runtime crate
    #[arg(long, value_name = "FOLDER")]
    runtime: Option<PathBuf>,
}

#[derive(Serialize)]
struct BenchReport {
    solvers: Vec<SolverReport>,
    instances: u64,
    rounds: u64,
    seed: u64,
    /// Seconds to compile all solvers, without the runtime.
    compile_seconds: f64,
    seconds: f64,
}

#[derive(Serialize)]
struct SolverReport {
    file: String,
    problem: String,
    rows: usize,
    columns: usize,
    /// |B|.
    basis: usize,
    /// `determinant` or `eigenvalues`.
    roots: &'static str,
    operations: usize,
    source_bytes: usize,
    #[serde(flatten)]
    times: Times,
}

pub(super) fn run(arguments: &Arguments) -> Result<Output, CommandError> {
    let start = Instant::now();
    let (mut reports, mut subjects) = (Vec::new(), Vec::new());
    for file in &arguments.files {
        let loaded = Loaded::read(file, None)?;
        let source = generate(&loaded.problem, &loaded.file)
            .map_err(|error| CommandError::Generate { problem: file.clone(), error: error.into() })?;
        let plan = &loaded.planned.plan;
        let template = &loaded.file.template;
        let mut random = Random::new(arguments.seed);
        let draw = |_| draw_inputs(&plan.data, Float64, &mut random);
        let instances = (0..arguments.instances).flat_map(draw).collect();
        reports.push(SolverReport {
            file: file.display().to_string(),
            problem: plan.name.clone(),
            rows: template.rows(),
            columns: template.columns(),
            basis: template.basis.len(),
            roots: plan.roots().name(),
            operations: plan.operations().total(),
            source_bytes: source.len(),
            times: Times::default(),
        });
        let parameters = plan.data.iter().map(|parameter| parameter.shape.clone()).collect();
        subjects.push(Subject {
            name: plan.name.clone(),
            source,
            parameters,
            unknowns: plan.unknowns.len(),
            instances,
        });
    }
    let timing = TimingCrate::new(&subjects, arguments.runtime.as_deref(), &arguments.files[0])?;
    let compile_seconds = timing.compile()?;
    for (report, times) in reports.iter_mut().zip(timing.run(subjects.len(), arguments.rounds)?) {
        report.times = times;
    }
    Ok(Output::of(&BenchReport {
        solvers: reports,
        instances: arguments.instances,
        rounds: arguments.rounds,
        seed: arguments.seed,
        compile_seconds,
        seconds: start.elapsed().as_secs_f64(),
    }))
}

impl fmt::Display for BenchReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let width = self.solvers.iter().map(|solver| solver.file.len()).max().unwrap_or(0).max(6);
        writeln!(
            f,
            "Nanoseconds per solve, medians of {} rounds of {} instances (seed {}):",
            self.rounds, self.instances, self.seed
        )?;
        writeln!(
            f,
            "\n{:width$} {:>9} {:>5} {:<11} {:>12} {:>11} {:>9} {:>9} {:>9} {:>7} {:>9}",
            "solver",
            "template",
            "basis",
            "roots",
            "coefficients",
            "elimination",
            "solutions",
            "total",
            "p99",
            "found",
            "source"
        )?;
        for SolverReport { file, rows, columns, basis, roots, source_bytes, times, .. } in &self.solvers {
            let size = format!("{rows}x{columns}");
            let Times { coefficients, elimination, solutions, total, p99, found } = times;
            writeln!(
                f,
                "{file:width$} {size:>9} {basis:>5} {roots:<11} {coefficients:>12.0} {elimination:>11.0} {solutions:>9.0} {total:>9.0} {p99:>9.0} {found:>7.2} {:>6} KB",
                source_bytes.div_ceil(1000)
            )?;
        }
        writeln!(
            f,
            "\ncoefficients: from the data, with one residual; solutions: roots, vectors, polish, second attempts; found: real\nsolutions per instance"
        )?;
        writeln!(f, "compiled in {}; all took {}", seconds(self.compile_seconds), seconds(self.seconds))
    }
}
