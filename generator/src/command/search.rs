//! `eliminant search`: finds, measures and chooses a template, and writes it beside the problem.

use std::fmt;
use std::path::PathBuf;
use std::time::Instant;

use serde::Serialize;

use super::error::CommandError;
use super::files::{read_named_problem, template_path, write};
use super::progress::spinner;
use super::report::{Output, Summary, counted, one_decimal, seconds, table};
use crate::check::check;
use crate::choose::{Choice, Measured, choose};
use crate::generate::plan;
use crate::presolve::Presolve;
use crate::problem::Problem;
use crate::search::{SearchError, SearchOptions, candidates};
use crate::stability::Stability;
use crate::template::file::TemplateFile;

/// Search an elimination template and write it beside the problem
#[derive(clap::Args, Debug)]
#[command(
    after_help = "The candidates are measured on random real instances, cheapest first; the cheapest one is chosen that solves
nearly all instances completely and to a small residual. The same problem and options give the same file.

Example:
  eliminant search problems/two_circles.rs    writes problems/two_circles.template.toml"
)]
pub(super) struct Arguments {
    /// The problem file, NAME.rs
    file: PathBuf,
    /// Seed of the random instances and of the shuffled orders of deletion
    #[arg(long, default_value_t = SearchOptions::default().seed)]
    seed: u64,
    /// No template has more columns before it is reduced
    #[arg(long, value_name = "N", default_value_t = SearchOptions::default().max_columns as u64, value_parser = clap::value_parser!(u64).range(2..=20_000))]
    max_columns: u64,
    /// Shuffled orders of deletion besides the two fixed ones
    #[arg(long, value_name = "N", default_value_t = SearchOptions::default().shuffles, value_parser = clap::value_parser!(u64).range(0..=10_000))]
    shuffles: u64,
    /// Random real instances on which each candidate is measured
    #[arg(long, value_name = "N", default_value_t = 300, value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    trials: u64,
    /// Where the template goes instead of NAME.template.toml beside the problem
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

#[derive(Serialize)]
struct Report {
    #[serde(flatten)]
    summary: Summary,
    /// How many different templates were found.
    found_templates: usize,
    trials: usize,
    chosen: usize,
    candidates: Vec<Row>,
    file: String,
    seconds: f64,
}

/// A candidate that was measured.
#[derive(Serialize)]
struct Row {
    rows: usize,
    columns: usize,
    basis: usize,
    action: String,
    presolve: &'static str,
    growth: String,
    operations: usize,
    /// log10 of the relative residual.
    median: Option<f64>,
    p99: Option<f64>,
    incomplete: usize,
    failures: usize,
}

pub(super) fn run(arguments: &Arguments) -> Result<Output, CommandError> {
    let start = Instant::now();
    let path = &arguments.file;
    let problem = read_named_problem(path)?;
    let options = SearchOptions {
        seed: arguments.seed,
        max_columns: arguments.max_columns as usize,
        shuffles: arguments.shuffles,
    };
    let progress = spinner();
    let say = |message: &str| progress.set_message(message.to_owned());
    say("counting solutions");
    let algebra = check(&problem)?;
    let fail = |error: SearchError| CommandError::Search { path: path.clone(), error };
    let found = candidates(&problem, algebra.solutions, &options, &say).map_err(fail)?;
    let none = || fail(SearchError::NotFound { max_columns: options.max_columns, tried: 0, rows: 0, columns: 0 });
    let choice = choose(&found, arguments.trials as usize, arguments.seed, &say).ok_or_else(none)?;
    let chosen = &choice.measured[choice.chosen];
    let file = to_file(chosen, &problem, &options);
    // Nothing is written that would not be accepted.
    plan(&problem, &file).map_err(|error| CommandError::Generate { problem: path.clone(), error: error.into() })?;
    let out = arguments.out.clone().unwrap_or_else(|| template_path(path));
    write(&out, &file.to_text(&problem.unknowns))?;
    progress.finish_and_clear();
    Ok(Output::of(&Report {
        summary: Summary::new(&problem, &chosen.candidate.template, &chosen.candidate.plan),
        found_templates: found.len(),
        trials: chosen.stability.trials,
        chosen: choice.chosen,
        candidates: rows(&choice, &problem),
        file: out.display().to_string(),
        seconds: start.elapsed().as_secs_f64(),
    }))
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

fn rows(choice: &Choice, problem: &Problem) -> Vec<Row> {
    let row = |measured: &Measured| {
        let (candidate, stability) = (&measured.candidate, &measured.stability);
        Row {
            rows: candidate.template.rows(),
            columns: candidate.template.columns(),
            basis: candidate.template.basis.len(),
            action: candidate.template.action.display(&problem.unknowns).to_string(),
            presolve: match candidate.presolve {
                Presolve::None => "none",
                Presolve::Constant => "constant",
                Presolve::Linear => "linear",
            },
            growth: candidate.growth.to_string(),
            operations: candidate.plan.operations().total(),
            median: stability.quantile(0.5),
            p99: stability.quantile(0.99),
            incomplete: stability.incomplete,
            failures: stability.failures,
        }
    };
    choice.measured.iter().map(row).collect()
}

const HEAD: [&str; 11] =
    ["", "size", "action", "presolve", "growth", "|B|", "operations", "median", "p99", "incomplete", "failed"];

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.summary)?;
        let cells = |(at, row): (usize, &Row)| {
            vec![
                if at == self.chosen { "*" } else { "" }.to_owned(),
                format!("{} x {}", row.rows, row.columns),
                row.action.clone(),
                row.presolve.to_owned(),
                row.growth.clone(),
                row.basis.to_string(),
                row.operations.to_string(),
                one_decimal(row.median),
                one_decimal(row.p99),
                row.incomplete.to_string(),
                row.failures.to_string(),
            ]
        };
        let rows: Vec<Vec<String>> = self.candidates.iter().enumerate().map(cells).collect();
        writeln!(
            f,
            "\n{} found, {} measured on {} each:",
            counted(self.found_templates, "template"),
            rows.len(),
            counted(self.trials, "instance")
        )?;
        write!(f, "{}", table(&HEAD, &rows, 5))?;
        writeln!(f, "(* chosen; median and p99 of the log10 relative residual)\n")?;
        writeln!(f, "wrote {} in {}", self.file, seconds(self.seconds))
    }
}
