//! The command line of `eliminant search`.

use std::path::PathBuf;
use std::time::Duration;

use super::settings::{Settings, Tracing};
use crate::search::preference::Preference;
use crate::search::shard::Shard;
use crate::search::{MORE_COLUMNS, MOST_COLUMNS, SearchOptions};

/// Search an elimination template and write it beside the problem
#[derive(clap::Args, Debug)]
#[command(after_help = "\
The candidates are measured on random real instances, in the order of the preference. The first
one is chosen that fails on none of --confirm instances, lacks a solution on at most one in 1000,
and has small residuals. The same problem and options give the same file, on any number of threads.
Ctrl-C ends the search within two seconds, with the best template found so far if it can be planned
and verified in that time. Otherwise, or on Ctrl-C again, all files are left as they were.

Example:
  eliminant search problems/two_circles.rs    writes problems/two_circles.template.toml
  eliminant search --check problems/*.rs      tells which of these the search would not write again
  for i in 1 2 3 4; do eliminant search problems/two_circles.rs --shard $i/4; done
  eliminant search problems/two_circles.rs --merge problems/two_circles.shard-*.json
                                              writes the same file as one search")]
pub(crate) struct Arguments {
    /// The problem file, NAME.rs
    #[arg(required_unless_present = "check")]
    pub(super) file: Option<PathBuf>,
    /// What is looked for first among templates that solve well
    #[arg(long, value_enum, value_name = "WHAT", default_value_t)]
    prefer: Preference,
    /// Seed of the random instances and of the shuffled orders of deletion
    #[arg(long, default_value_t = SearchOptions::default().seed)]
    seed: u64,
    /// Most columns of a template before it is reduced
    /// [default: 600, and then 1500 if nothing that solves well is found and the search is not
    /// sharded]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(2..=MOST_COLUMNS as u64))]
    max_columns: Option<u64>,
    /// Makes a template by the trace of a Gröbner basis at once, whatever its size. Otherwise this
    /// is done where nothing is found, unless `--max-columns` or `--shard` is given
    #[arg(long, conflicts_with_all = ["max_columns", "shard", "merge"])]
    trace: bool,
    /// Largest basis, which is the size of the eigenvalue problem; never below the number of
    /// solutions
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=20_000))]
    max_basis: Option<u64>,
    /// How often each of the smallest templates is enlarged and reduced anew in a shuffled order
    #[arg(
        long,
        value_name = "N",
        default_value_t = SearchOptions::default().shuffles,
        value_parser = clap::value_parser!(u64).range(0..=10_000)
    )]
    shuffles: u64,
    /// Random real instances on which candidates are screened; fewer if templates are very large
    #[arg(
        long,
        value_name = "N",
        default_value_t = 300,
        value_parser = clap::value_parser!(u64).range(1..=1_000_000)
    )]
    trials: u64,
    /// Random real instances on which the chosen template must hold; fewer if it is very large
    #[arg(
        long,
        value_name = "N",
        default_value_t = 10_000,
        value_parser = clap::value_parser!(u64).range(1..=10_000_000)
    )]
    confirm: u64,
    /// Ends after about this time with the best template found so far; results may then differ from
    /// run to run
    #[arg(long, value_name = "SECONDS", value_parser = parse_seconds)]
    pub(super) budget: Option<Duration>,
    /// Searches only part I of N and writes what it finds for `--merge`,
    /// to NAME.shard-I-of-N.json unless `--out` names another file
    #[arg(long, value_name = "I/N")]
    pub(super) shard: Option<Shard>,
    /// Chooses among what the shards of one search found; options are those of the shards
    #[arg(
        long,
        value_name = "FILES",
        num_args = 1..,
        conflicts_with_all = ["prefer", "seed", "max_columns", "max_basis", "shuffles", "trials", "confirm", "shard"]
    )]
    pub(super) merge: Vec<PathBuf>,
    /// Writes the result to this file instead of NAME.template.toml beside the problem
    #[arg(long, value_name = "FILE")]
    pub(super) out: Option<PathBuf>,
    /// Repeats the search of each problem with the options that its template file records, and
    /// tells what differs; writes nothing. Exit status 1 if anything differs
    #[arg(
        long,
        value_name = "FILES",
        num_args = 1..,
        conflicts_with_all = [
            "file", "prefer", "seed", "max_columns", "max_basis", "shuffles", "trials", "confirm", "budget", "shard",
            "merge", "out", "trace",
        ]
    )]
    pub(super) check: Vec<PathBuf>,
}

fn parse_seconds(text: &str) -> Result<Duration, String> {
    let seconds = text.parse().ok().and_then(|seconds| Duration::try_from_secs_f64(seconds).ok());
    seconds.filter(|seconds| !seconds.is_zero()).ok_or_else(|| "expected a number of seconds above 0".to_owned())
}

impl Arguments {
    /// What the search is asked for.
    pub(super) fn settings(&self) -> Settings {
        let default = SearchOptions::default().max_columns;
        let options = SearchOptions {
            seed: self.seed,
            max_columns: self.max_columns.map_or(default, |limit| limit as usize),
            max_basis: self.max_basis.map(|most| most as usize),
            shuffles: self.shuffles,
            prefer: self.prefer,
            shard: self.shard.unwrap_or(Shard::ALL),
        };
        // A shard does not know whether the others find something within the first limit.
        let may_widen = self.max_columns.is_none() && self.shard.is_none();
        let settings = Settings::new(options, self.trials as usize, self.confirm as usize);
        let tracing = match may_widen {
            _ if self.trace => Tracing::AtOnce,
            true => Tracing::WhereNothingIsFound,
            false => Tracing::Never,
        };
        Settings { wider: may_widen.then_some(MORE_COLUMNS), tracing, ..settings }
    }
}
