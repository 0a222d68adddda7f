//! `eliminant stability`: what solvers do on many instances, judged by true solutions.
//!
//! ```text
//! problems --family, seed--> instances --emitted code--> points --oracle--> outcomes --> figures
//!              files of instances --'                                                      |
//!                                    text, JSON, CSV, a page; worst instances; baseline <--'
//! ```

mod baseline;
mod condition;
mod family;
mod figures;
mod instance;
mod measure;
mod outcome;
mod page;
mod report;
mod solve;
mod subjects;

use std::path::{Path, PathBuf};
use std::time::Instant;

use self::baseline::{Accepted, Baseline};
use self::family::Family;
use self::instance::{Instance, read_instances, write_instances};
use self::measure::{Measured, measure_emitted, measure_interpreted, microseconds};
use self::report::{Checked, StabilityReport};
use self::subjects::{Subject, read_subjects};
use super::error::CommandError;
use super::files::write;
use super::interrupt::listen;
use super::progress::bar;
use super::report::Output;
use crate::plan::Plan;

/// Measure solvers on many instances, judged by true solutions
#[derive(clap::Args, Debug)]
#[command(
    after_help = "Emits the solvers, compiles them in a crate of their own in a temporary folder, and runs them. With --interpreted
the plans are interpreted instead: the same bits, no times, and nothing is compiled.

What they return is judged by the true solutions in numbers of 237 bits: Newton's method from the returned points, and
where solutions are missing the same template with more digits. Where these are not as many as the problem has for
general data, the count is uncertain, and said to be: solutions may be multiple, infinite or none.

The relative residual of a point is max over the equations of |f| / sum of the moduli of its terms; its forward error
the distance to its true solution, over the length of that one. A point has a solution of its own if it is at most
0.01 away; the closest pairs go together, points left over are spurious, and solutions left over are missed.

Examples:
  eliminant stability problems/two_circles.rs --trials 10000 --seed 7
  eliminant stability problems --html report.html --csv figures.csv --worst worst.jsonl
  eliminant stability problems --replay worst.jsonl
  eliminant stability problems --trials 200 --check

Example of a line of a file of instances (data are flat; level and solutions may be absent):
  {\"problem\": \"two_circles\", \"family\": \"scene\", \"level\": -3, \"data\": [0.5, 1, 2, 1], \"solutions\": [[1, 2]]}"
)]
pub(super) struct Arguments {
    /// Problem files, NAME.rs with NAME.template.toml beside them, and folders of such
    #[arg(required = true)]
    problems: Vec<PathBuf>,
    /// The template file of a single problem, if it is not NAME.template.toml beside it
    #[arg(long, value_name = "FILE")]
    template: Option<PathBuf>,
    /// Number of instances of each family and problem; one for a problem without data
    #[arg(long, value_name = "N", default_value_t = 1000, value_parser = clap::value_parser!(u64).range(1..=10_000_000))]
    trials: u64,
    /// Seconds that each family of a problem may take on one core, by a rough count; large problems
    /// get fewer instances, but at least 8
    #[arg(long, value_name = "SECONDS", default_value_t = 60, value_parser = clap::value_parser!(u64).range(1..))]
    work: u64,
    /// Seed of the instances
    #[arg(long, value_name = "S", default_value_t = 1)]
    seed: u64,
    /// Families of instances that are drawn, separated by commas; all of them unless a file is
    /// given
    #[arg(long, value_name = "LIST", value_enum, value_delimiter = ',')]
    families: Option<Vec<Family>>,
    /// A file of instances; may be given several times
    #[arg(long, value_name = "FILE")]
    instances: Vec<PathBuf>,
    /// A file of instances, each of which is reported
    #[arg(long, value_name = "FILE", conflicts_with_all = ["families", "instances", "check", "update_baseline"])]
    replay: Option<PathBuf>,
    /// Interpret the plans: the same solutions, no times, nothing to compile
    #[arg(long)]
    interpreted: bool,
    /// The folder of the runtime crate, for emitted code
    #[arg(long, value_name = "FOLDER")]
    runtime: Option<PathBuf>,
    /// Write the figures as CSV
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// Write a page to be opened in a browser
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
    /// Write the worst instances, for --replay
    #[arg(long, value_name = "FILE")]
    worst: Option<PathBuf>,
    /// Compare with the accepted figures: exit status 1 if one got worse beyond the error of
    /// sampling
    #[arg(long, conflicts_with = "update_baseline")]
    check: bool,
    /// Accept the figures
    #[arg(long)]
    update_baseline: bool,
    /// The accepted figures, if they are not stability.toml beside the first problem
    #[arg(long, value_name = "FILE")]
    baseline: Option<PathBuf>,
}

/// Instances that every family has, whatever they take: one of each level.
const FEWEST: usize = 8;
/// Worst instances of each problem that are kept.
const WORST: usize = 5;

pub(super) fn run(arguments: &Arguments) -> Result<Output, CommandError> {
    let start = Instant::now();
    listen();
    let subjects = read_subjects(&arguments.problems, arguments.template.as_deref(), !arguments.interpreted)?;
    let plans: Vec<&Plan> = subjects.iter().map(|subject| &subject.loaded.planned.plan).collect();
    let mut files = Vec::new();
    for path in arguments.instances.iter().chain(&arguments.replay) {
        files.extend(read_instances(path, &plans)?);
    }
    let baseline = arguments.baseline_path();
    let accepted = match (arguments.check, arguments.update_baseline && baseline.exists()) {
        (false, false) => Baseline::default(),
        _ => Baseline::read(&baseline)?,
    };
    let instances: Vec<Vec<Instance>> = plans.iter().map(|plan| arguments.instances_of(plan, &files)).collect();
    let progress = bar(subjects.len() + instances.iter().map(Vec::len).sum::<usize>());
    let measured = match arguments.interpreted {
        true => measure_interpreted(&subjects, instances, &progress),
        false => measure_emitted(&subjects, instances, arguments.runtime.as_deref(), &progress),
    };
    progress.finish_and_clear();
    let measured = measured?;
    let worst: Vec<&Measured> = measured.iter().flat_map(|measured| worst_of(measured)).collect();
    let now: Vec<Accepted> = measured.iter().flat_map(|measured| accepted_of(measured)).collect();
    let checked = match arguments.check {
        true => Some(Checked::of(&baseline, accepted.compare(&baseline, &now)?)),
        false => None,
    };
    let mut report = StabilityReport::new(&subjects, &measured, &worst, arguments.replay.is_some());
    (report.trials, report.seed, report.is_emitted) = (arguments.trials, arguments.seed, !arguments.interpreted);
    report.check = checked;
    report.seconds = start.elapsed().as_secs_f64();
    if let Some(path) = &arguments.worst {
        let noted =
            |measured: &&Measured| Instance { note: Some(measured.outcome.words()), ..measured.instance.clone() };
        write_instances(path, &worst.iter().map(noted).collect::<Vec<_>>())?;
    }
    if let Some(path) = &arguments.csv {
        write(path, &report.csv())?;
    }
    if let Some(path) = &arguments.html {
        write(path, &page::page(&report))?;
    }
    if arguments.update_baseline {
        accepted.update(&baseline, &now)?;
    }
    Ok(Output::of(&report).at_fault_if(report.is_worse()))
}

impl Arguments {
    fn baseline_path(&self) -> PathBuf {
        let folder = |problem: &PathBuf| match problem.is_dir() {
            true => problem.clone(),
            false => problem.parent().unwrap_or(Path::new("")).to_owned(),
        };
        let beside = || self.problems.first().map(folder).unwrap_or_default().join("stability.toml");
        self.baseline.clone().unwrap_or_else(beside)
    }

    /// The instances of one problem: those of its families, then those from files.
    fn instances_of(&self, plan: &Plan, files: &[Instance]) -> Vec<Instance> {
        let families: &[Family] = match &self.families {
            Some(families) => families,
            None if self.instances.is_empty() && self.replay.is_none() => &Family::ALL,
            None => &[],
        };
        let affordable = ((1e6 * self.work as f64 / microseconds(plan)) as usize).max(FEWEST);
        let count = affordable.min(self.trials as usize);
        let drawn = families.iter().flat_map(|family| family.instances(plan, count, self.seed));
        drawn.chain(files.iter().filter(|instance| instance.problem == plan.name).cloned()).collect()
    }
}

/// The worst instances of a problem, the worst one first.
fn worst_of(measured: &[Measured]) -> Vec<&Measured> {
    let mut order: Vec<&Measured> = measured.iter().collect();
    let badness = |measured: &&Measured| measured.outcome.badness();
    order.sort_by(|a, b| badness(b).partial_cmp(&badness(a)).unwrap_or(std::cmp::Ordering::Equal));
    order.truncate(WORST);
    order
}

/// The figures of each family of a problem, over all levels.
fn accepted_of(measured: &[Measured]) -> Vec<Accepted> {
    report::groups(measured, false)
        .into_iter()
        .map(|((problem, family, _), outcomes)| Accepted::of(problem, family, &outcomes))
        .collect()
}
