//! `eliminant search`: finds, measures and chooses a template, and writes it beside the problem.

use std::path::PathBuf;
use std::time::Instant;

use super::error::CommandError;
use super::files::{read_named_problem, template_path, write};
use super::progress::Watch;
use super::report::{Output, one_decimal};
use super::search_report::Report;
use crate::check::check;
use crate::choose::{Measured, Measuring, choose};
use crate::generate::plan;
use crate::monitor::Monitor;
use crate::preference::Preference;
use crate::problem::Problem;
use crate::search::{SearchError, SearchOptions, candidates};
use crate::stability::Stability;
use crate::template::file::TemplateFile;

/// Search an elimination template and write it beside the problem
#[derive(clap::Args, Debug)]
#[command(
    after_help = "The candidates are measured on random real instances in the order of the preference. The first one is chosen that fails on none of --confirm
instances, lacks a solution on at most one in 1000, and has small residuals. The same problem and options give the same file.

Example:
  eliminant search problems/two_circles.rs    writes problems/two_circles.template.toml"
)]
pub(super) struct Arguments {
    /// The problem file, NAME.rs
    file: PathBuf,
    /// What is looked for first among templates that solve well
    #[arg(long, value_enum, value_name = "WHAT", default_value_t)]
    prefer: Preference,
    /// Seed of the random instances and of the shuffled orders of deletion
    #[arg(long, default_value_t = SearchOptions::default().seed)]
    seed: u64,
    /// No template has more columns before it is reduced
    #[arg(long, value_name = "N", default_value_t = SearchOptions::default().max_columns as u64, value_parser = clap::value_parser!(u64).range(2..=20_000))]
    max_columns: u64,
    /// Shuffled orders of deletion besides the two fixed ones
    #[arg(long, value_name = "N", default_value_t = SearchOptions::default().shuffles, value_parser = clap::value_parser!(u64).range(0..=10_000))]
    shuffles: u64,
    /// Random real instances on which candidates are screened
    #[arg(long, value_name = "N", default_value_t = 300, value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    trials: u64,
    /// Random real instances on which the chosen one must hold
    #[arg(long, value_name = "N", default_value_t = 10_000, value_parser = clap::value_parser!(u64).range(1..=10_000_000))]
    confirm: u64,
    /// Where the template goes instead of NAME.template.toml beside the problem
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

pub(super) fn run(arguments: &Arguments) -> Result<Output, CommandError> {
    let start = Instant::now();
    let path = &arguments.file;
    let problem = read_named_problem(path)?;
    let options = SearchOptions {
        seed: arguments.seed,
        max_columns: arguments.max_columns as usize,
        shuffles: arguments.shuffles,
        prefer: arguments.prefer,
    };
    let (trials, confirm) = (arguments.trials as usize, arguments.confirm as usize);
    let measuring = Measuring { trials, confirm, seed: arguments.seed };
    let watch = Watch::new();
    watch.say("counting solutions");
    let algebra = check(&problem)?;
    let fail = |error: SearchError| CommandError::Search { path: path.clone(), error };
    let found = candidates(&problem, algebra.solutions, &options, &watch).map_err(fail)?;
    let none = || fail(SearchError::NotFound { max_columns: options.max_columns, tried: 0, rows: 0, columns: 0 });
    let choice = choose(&found, options.prefer, measuring, &watch).ok_or_else(none)?;
    let file = to_file(&choice.measured[choice.chosen], &problem, &options);
    // Nothing is written that would not be accepted.
    plan(&problem, &file).map_err(|error| CommandError::Generate { problem: path.clone(), error: error.into() })?;
    let out = arguments.out.clone().unwrap_or_else(|| template_path(path));
    write(&out, &file.to_text(&problem.unknowns))?;
    watch.finish();
    let seconds = start.elapsed().as_secs_f64();
    Ok(Output::of(&Report::new(&problem, options.prefer, found.len(), &choice, out.display().to_string(), seconds)))
}

/// The file of the chosen candidate, with its measurement; figures are rounded so that the last bits of a machine do not matter.
fn to_file(chosen: &Measured, problem: &Problem, options: &SearchOptions) -> TemplateFile {
    let mut file = chosen.candidate.to_file(problem, options);
    let Stability { trials, found, expected, incomplete, .. } = &chosen.stability;
    let quantile = |q: f64| one_decimal(chosen.stability.quantile(q));
    file.provenance.extend([
        ("trials".to_owned(), trials.to_string()),
        ("residual_log10".to_owned(), format!("median {}, p99 {}", quantile(0.5), quantile(0.99))),
        ("complex_solutions".to_owned(), format!("{found} of {expected} found; {incomplete} instances incomplete")),
    ]);
    file
}
