//! `eliminant stability`: interprets the plan on random real instances.

use std::fmt;
use std::path::PathBuf;
use std::time::Instant;

use serde::Serialize;

use super::error::CommandError;
use super::files::Loaded;
use super::progress::bar;
use super::report::{Output, Summary, one_decimal, seconds};
use crate::search::measuring::stability;

/// Measure a template on random real instances
#[derive(clap::Args, Debug)]
#[command(
    after_help = "Interprets the planned solver on instances drawn on the variety of the data. The relative residual of a solution is
max over the equations of |f| / sum of the moduli of its terms. If solutions are missing, a second
attempt is made at twice the precision, as in emitted code.

Example:
  eliminant stability problems/two_circles.rs --trials 10000 --seed 7"
)]
pub(super) struct Arguments {
    /// The problem file, NAME.rs
    file: PathBuf,
    /// The template file, if it is not NAME.template.toml beside the problem
    #[arg(long, value_name = "FILE")]
    template: Option<PathBuf>,
    /// Number of random instances
    #[arg(long, value_name = "N", default_value_t = 1000, value_parser = clap::value_parser!(u64).range(1..=10_000_000))]
    trials: u64,
    /// Seed of the instances
    #[arg(long, value_name = "S", default_value_t = 1)]
    seed: u64,
}

#[derive(Serialize)]
struct StabilityReport {
    #[serde(flatten)]
    summary: Summary,
    trials: usize,
    seed: u64,
    residual_log10: Quantiles,
    /// Number of complex solutions found over all instances.
    found: usize,
    expected: usize,
    /// Number of instances that took a second attempt.
    repeated: usize,
    /// Number of instances that lack a solution.
    incomplete: usize,
    /// Number of instances on which a step failed.
    failures: usize,
    seconds: f64,
}

/// Quantiles of the log10 relative residual; `null` if nothing was found.
#[derive(Serialize)]
struct Quantiles {
    median: Option<f64>,
    p99: Option<f64>,
    p999: Option<f64>,
    max: Option<f64>,
}

pub(super) fn run(arguments: &Arguments) -> Result<Output, CommandError> {
    let start = Instant::now();
    let loaded = Loaded::read(&arguments.file, arguments.template.as_deref())?;
    let trials = arguments.trials as usize;
    let progress = bar(trials);
    let measured = stability(&loaded.planned.plan, trials, arguments.seed, &|| progress.inc(1));
    progress.finish_and_clear();
    Ok(Output::of(&StabilityReport {
        summary: Summary::new(&loaded.problem, &loaded.file.template, &loaded.planned.plan),
        trials,
        seed: arguments.seed,
        residual_log10: Quantiles {
            median: measured.quantile(0.5),
            p99: measured.quantile(0.99),
            p999: measured.quantile(0.999),
            max: measured.quantile(1.0),
        },
        found: measured.found,
        expected: measured.expected,
        repeated: measured.repeated,
        incomplete: measured.incomplete,
        failures: measured.failures,
        seconds: start.elapsed().as_secs_f64(),
    }))
}

impl fmt::Display for StabilityReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Quantiles { median, p99, p999, max } = self.residual_log10;
        write!(f, "{}", self.summary)?;
        writeln!(
            f,
            "\nlog10 relative residual of the complex solutions of {} instances (seed {}):",
            self.trials, self.seed
        )?;
        for (name, value) in [("median", median), ("p99", p99), ("p99.9", p999), ("max", max)] {
            writeln!(f, "  {name:<8}{:>7}", one_decimal(value))?;
        }
        let percent = 100.0 * self.found as f64 / self.expected.max(1) as f64;
        writeln!(f, "found       {} of {} solutions ({percent:.3} %)", self.found, self.expected)?;
        writeln!(f, "repeated    {} instances took a second attempt", self.repeated)?;
        writeln!(f, "incomplete  {} instances lack a solution", self.incomplete)?;
        writeln!(f, "failed      {} instances", self.failures)?;
        let each = 1e6 * self.seconds / self.trials.max(1) as f64;
        writeln!(f, "time        {} ({each:.1} us for each instance, interpreted)", seconds(self.seconds))
    }
}
