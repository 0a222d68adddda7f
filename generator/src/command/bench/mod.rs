//! `eliminant bench`: compiles emitted solvers and times them.

mod fit;
mod subject;
mod timing_crate;

use std::fmt;
use std::path::PathBuf;
use std::time::Instant;

use rayon::prelude::*;
use serde::Serialize;

use self::fit::{Fit, Sample};
use self::subject::Subject;
use self::timing_crate::{BuildCost, Times, TimingCrate};
use super::error::CommandError;
use super::files::Loaded;
use super::progress::bar;
use super::report::{Output, seconds, table};
use crate::algebra::Random;
use crate::generate::generate;
use crate::plan::Plan;
use crate::plan::time::counts;
use crate::search::measuring::interpreted::InterpretedSolver;
use crate::search::measuring::{in_pool, random_instance, seed_of};

/// Compile solvers and measure the time of a solve
#[derive(clap::Args, Debug)]
#[command(
    after_help = "Emits the solvers, compiles them in a crate of their own in a temporary folder, and runs them on instances drawn
on the variety of the data, or on scenes. All solvers take turns in one process, so that a drifting clock hits all alike: several
templates of one problem, in folders of their own, are compared with each other.

Needs cargo, and the runtime crate `eliminant`: that of the checkout in which the first problem stands,
that of --runtime, or else the published one of this version.

Example:
  eliminant bench problems/two_circles.rs smaller/two_circles.rs --instances 2000
  eliminant bench problems/two_circles.rs --scenes"
)]
pub(super) struct Arguments {
    /// The problem files, NAME.rs, each with its template NAME.template.toml beside it
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// Number of instances
    #[arg(long, value_name = "N", default_value_t = 1000, value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    instances: u64,
    /// Number of rounds; times are medians over them
    #[arg(long, value_name = "R", default_value_t = 21, value_parser = clap::value_parser!(u64).range(1..=10_000))]
    rounds: u64,
    /// Seed of the instances
    #[arg(long, value_name = "S", default_value_t = 1)]
    seed: u64,
    /// Solve scenes, which the function with `#[scene]` of each problem file draws, not random data
    #[arg(long)]
    scenes: bool,
    /// Fit the model by which the search predicts the time of a solve, and say how far it is off
    #[arg(long)]
    fit: bool,
    /// The folder of the runtime crate
    #[arg(long, value_name = "FOLDER")]
    runtime: Option<PathBuf>,
}

#[derive(Serialize)]
struct BenchReport {
    solvers: Vec<SolverReport>,
    instances: u64,
    scenes: bool,
    rounds: u64,
    seed: u64,
    /// The model of `--fit`.
    fit: Option<Fit>,
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
    /// The portion of instances on which the search for all complex solutions takes a second
    /// attempt.
    repeated: f64,
    /// Nanoseconds of a solve that the model of the search predicts.
    predicted: f64,
    #[serde(flatten)]
    times: Times,
    source_bytes: usize,
    #[serde(flatten)]
    cost: BuildCost,
}

/// Instances of which the portion of second attempts is counted: as many as this number of
/// operations allows, but at least [`FEWEST_COUNTED`].
const COUNTING_WORK: usize = 300_000_000;
const FEWEST_COUNTED: usize = 50;

pub(super) fn run(arguments: &Arguments) -> Result<Output, CommandError> {
    let start = Instant::now();
    let (mut reports, mut subjects, mut all_counts) = (Vec::new(), Vec::new(), Vec::new());
    let progress = bar(2 * arguments.files.len());
    for file in &arguments.files {
        let loaded = Loaded::read(file, None)?;
        let source = generate(&loaded.problem, &loaded.file)
            .map_err(|error| CommandError::Generate { problem: file.clone(), error: error.into() })?;
        let (plan, template) = (&loaded.planned.plan, &loaded.file.template);
        let operations = plan.operations().total();
        let count = arguments.instances as usize;
        let counted = count.min((COUNTING_WORK / operations.max(1)).max(FEWEST_COUNTED));
        let instances: Vec<Vec<f64>> = match arguments.scenes {
            false => (0..count).map(|k| random_instance(plan, arguments.seed, k)).collect(),
            true => {
                scenes(plan, count, arguments.seed).ok_or_else(|| CommandError::NoScene { problem: file.clone() })?
            }
        };
        let repeated = repeats(plan, &instances[..counted]);
        all_counts.push(counts(plan, repeated));
        reports.push(SolverReport {
            file: file.display().to_string(),
            problem: plan.name.clone(),
            rows: template.rows(),
            columns: template.columns(),
            basis: template.basis.len(),
            roots: plan.roots().name(),
            operations,
            repeated,
            predicted: plan.predicted_nanoseconds(repeated),
            times: Times::default(),
            source_bytes: source.len(),
            cost: BuildCost::default(),
        });
        subjects.push(Subject {
            name: plan.name.clone(),
            source,
            parameters: plan.data.clone(),
            eigenvalues: plan.chains.is_none().then_some(template.basis.len()),
            count,
            instances: instances.concat(),
        });
        progress.inc(1);
    }
    let timing = TimingCrate::new(&subjects, arguments.runtime.as_deref(), &arguments.files[0])?;
    let costs = timing.compile(&|| progress.inc(1))?;
    progress.finish_and_clear();
    let mut samples = Vec::new();
    let measured = timing.run(arguments.rounds)?.into_iter().zip(costs).zip(all_counts);
    for (report, ((times, cost), counts)) in reports.iter_mut().zip(measured) {
        (report.times, report.cost) = (times, cost);
        samples.push(Sample { counts, times });
    }
    Ok(Output::of(&BenchReport {
        solvers: reports,
        instances: arguments.instances,
        scenes: arguments.scenes,
        rounds: arguments.rounds,
        seed: arguments.seed,
        fit: arguments.fit.then(|| Fit::of(&samples)),
        seconds: start.elapsed().as_secs_f64(),
    }))
}

/// The data of scenes; `None` if the problem states none.
fn scenes(plan: &Plan, count: usize, seed: u64) -> Option<Vec<Vec<f64>>> {
    let scene = plan.scene.as_ref()?;
    (0..count).map(|k| scene.draw(&mut Random::new(seed_of(seed, k))).map(|scene| scene.data)).collect()
}

/// The portion of instances of which the complex solutions take a second attempt.
fn repeats(plan: &Plan, instances: &[Vec<f64>]) -> f64 {
    let solver = InterpretedSolver::of(plan);
    let is_repeated = |data: &Vec<f64>| {
        solver.instance(data).is_ok_and(|mut instance| {
            let _ = instance.solve_complex();
            instance.attempts() > 1
        })
    };
    let count = in_pool(|| instances.par_iter().filter(|data| is_repeated(data)).count());
    count as f64 / instances.len() as f64
}

const HEAD: [&str; 16] = [
    "solver",
    "roots",
    "template",
    "basis",
    "coefficients",
    "elimination",
    "eigenvalues",
    "solutions",
    "repeats",
    "total",
    "predicted",
    "p99",
    "found",
    "repeated",
    "program KB",
    "compile s",
];

impl SolverReport {
    fn cells(&self) -> Vec<String> {
        let Times { coefficients, elimination, eigenvalues, solutions, second_attempts, total, p99, found } =
            self.times;
        let mut cells = vec![self.file.clone(), self.roots.to_owned(), format!("{}x{}", self.rows, self.columns)];
        cells.push(self.basis.to_string());
        let times = [coefficients, elimination, eigenvalues, solutions, second_attempts, total, self.predicted, p99];
        cells.extend(times.map(|x| format!("{x:.0}")));
        cells.extend([format!("{found:.2}"), format!("{:.2} %", 100.0 * self.repeated)]);
        cells.extend([self.cost.program_bytes.div_ceil(1000).to_string(), format!("{:.1}", self.cost.compile_seconds)]);
        cells
    }
}

impl fmt::Display for BenchReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "Nanoseconds per solve, medians of {} rounds of {} {} (seed {}):\n",
            self.rounds,
            self.instances,
            if self.scenes { "scenes" } else { "instances" },
            self.seed
        )?;
        let rows: Vec<Vec<String>> = self.solvers.iter().map(SolverReport::cells).collect();
        write!(f, "{}", table(&HEAD, &rows, 2))?;
        writeln!(
            f,
            "
coefficients: from the data, with one residual; eigenvalues: 0 where a determinant has the roots;
solutions: roots of a determinant, vectors, polish; repeats: second attempts;
predicted: the total by the model of the search; p99: of single solves; found: real solutions per instance;
repeated: instances of which the complex solutions take a second attempt;
program, compile: what the solver adds to a program, and the time to compile and link it alone"
        )?;
        if let Some(fit) = &self.fit {
            write!(f, "{fit}")?;
        }
        writeln!(f, "\nall took {}", seconds(self.seconds))
    }
}
