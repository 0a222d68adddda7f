//! `eliminant search`: finds, measures and chooses a template, and writes it beside the problem.

use std::path::PathBuf;
use std::time::Duration;

use super::error::CommandError;
use super::files::{read_named_problem, template_path, write};
use super::report::{Output, one_decimal};
use super::search_report::{Cut, Report, ShardReport};
use super::settings::Settings;
use super::shard::{Common, ShardCandidate, ShardFile, merge};
use super::watch::{End, Watch};
use crate::check::{SolutionCount, check};
use crate::generate::plan;
use crate::problem::Problem;
use crate::search::choose::{Measured, choose, screen};
use crate::search::measuring::Stability;
use crate::search::monitor::Monitor;
use crate::search::preference::Preference;
use crate::search::share::Share;
use crate::search::{Candidate, Found, MOST_COLUMNS, SearchError, SearchOptions, candidates};
use crate::template::file::TemplateFile;

/// The limit on the number of columns of a second try.
const MORE_COLUMNS: usize = 1500;

/// Search an elimination template and write it beside the problem
#[derive(clap::Args, Debug)]
#[command(
    after_help = "The candidates are measured on random real instances in the order of the preference. The first one is chosen that fails on none of --confirm
instances, lacks a solution on at most one in 1000, and has small residuals. The same problem and options give the same file, on any number of
threads. Ctrl-C ends the search with the best found so far; pressed again it leaves everything as it was.

Example:
  eliminant search problems/two_circles.rs    writes problems/two_circles.template.toml
  for i in 1 2 3 4; do eliminant search problems/two_circles.rs --shard $i/4; done
  eliminant search problems/two_circles.rs --merge problems/two_circles.shard-*.json    writes the same file as one search"
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
    /// No template has more columns before it is reduced [default: 600, and then 1500 where nothing is found and the search is not shared]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(2..=MOST_COLUMNS as u64))]
    max_columns: Option<u64>,
    /// No template has a larger basis, which is the size of the eigenvalue problem, where a smaller one can hold all solutions
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=20_000))]
    max_basis: Option<u64>,
    /// How often each of the smallest templates is enlarged and reduced anew in a shuffled order
    #[arg(long, value_name = "N", default_value_t = SearchOptions::default().shuffles, value_parser = clap::value_parser!(u64).range(0..=10_000))]
    shuffles: u64,
    /// Random real instances on which candidates are screened; fewer where templates are very large
    #[arg(long, value_name = "N", default_value_t = 300, value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    trials: u64,
    /// Random real instances on which the chosen one must hold; fewer where the template is very large
    #[arg(long, value_name = "N", default_value_t = 10_000, value_parser = clap::value_parser!(u64).range(1..=10_000_000))]
    confirm: u64,
    /// Ends after about this time with the best found so far; results may then differ from run to run
    #[arg(long, value_name = "SECONDS", value_parser = parse_seconds)]
    budget: Option<Duration>,
    /// Searches only part I of N and writes what it finds for `--merge`, to NAME.shard-I-of-N.json unless `--out` says otherwise
    #[arg(long, value_name = "I/N")]
    shard: Option<Share>,
    /// Chooses among what the shards of one search found; options are those of the shards
    #[arg(
        long,
        value_name = "FILES",
        num_args = 1..,
        conflicts_with_all = ["prefer", "seed", "max_columns", "max_basis", "shuffles", "trials", "confirm", "shard"]
    )]
    merge: Vec<PathBuf>,
    /// Where the result goes instead of NAME.template.toml beside the problem
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

fn parse_seconds(text: &str) -> Result<Duration, String> {
    let seconds = text.parse().ok().and_then(|seconds| Duration::try_from_secs_f64(seconds).ok());
    seconds.filter(|seconds| !seconds.is_zero()).ok_or_else(|| "expected a number of seconds above 0".to_owned())
}

impl Arguments {
    /// How many columns are tried, one limit after the other until something is found.
    fn limits(&self) -> Vec<usize> {
        match (self.max_columns, self.shard) {
            (Some(limit), _) => vec![limit as usize],
            (None, Some(_)) => vec![SearchOptions::default().max_columns],
            (None, None) => vec![SearchOptions::default().max_columns, MORE_COLUMNS],
        }
    }

    fn settings(&self) -> Settings {
        let options = SearchOptions {
            seed: self.seed,
            max_columns: SearchOptions::default().max_columns,
            max_basis: self.max_basis.map(|most| most as usize),
            shuffles: self.shuffles,
            prefer: self.prefer,
            share: self.shard.unwrap_or(Share::ALL),
        };
        Settings::new(options, self.trials as usize, self.confirm as usize)
    }
}

pub(super) fn run(arguments: &Arguments) -> Result<Output, CommandError> {
    let path = &arguments.file;
    let problem = read_named_problem(path)?;
    let watch = Watch::new(arguments.budget);
    if !arguments.merge.is_empty() {
        let merged = merge(path, &problem, &arguments.merge)?;
        let known = |candidate: &Candidate| merged.known(candidate);
        return conclude(arguments, &problem, &merged.settings, &merged.found, merged.templates, &known, &watch);
    }
    let mut settings = arguments.settings();
    watch.say("counting solutions");
    let algebra = check(&problem)?;
    let found = first_found(&problem, &algebra, &mut settings.options, &arguments.limits(), &watch);
    match (arguments.shard, found) {
        (Some(share), found) => hand_over(arguments, &problem, &settings, share, found, &watch),
        (None, Ok(found)) => {
            let templates = found.candidates.len();
            conclude(arguments, &problem, &settings, &found, templates, &|_| None, &watch)
        }
        (None, Err(error)) => Err(CommandError::of_search(path, &problem, error)),
    }
}

/// What is found within the first of some limits on the number of columns that suffices; `options` hold it afterwards.
fn first_found(
    problem: &Problem,
    algebra: &SolutionCount,
    options: &mut SearchOptions,
    limits: &[usize],
    monitor: &dyn Monitor,
) -> Result<Found, SearchError> {
    options.max_columns = limits.first().copied().unwrap_or(options.max_columns);
    let found = candidates(problem, algebra, options, monitor);
    match (&found, limits) {
        (Err(SearchError::NotFound { max_columns, is_over: false, .. }), [_, wider @ ..]) if !wider.is_empty() => {
            monitor.say(&format!("nothing within {max_columns} columns; trying {}", wider[0]));
            first_found(problem, algebra, options, wider, monitor)
        }
        _ => found,
    }
}

/// Measures, chooses and writes.
fn conclude(
    arguments: &Arguments,
    problem: &Problem,
    settings: &Settings,
    found: &Found,
    templates: usize,
    known: &dyn Fn(&Candidate) -> Option<Stability>,
    watch: &Watch,
) -> Result<Output, CommandError> {
    let path = &arguments.file;
    let nothing = || SearchError::NotFound {
        max_columns: settings.options.max_columns,
        attempts: Vec::new(),
        untried: found.untried,
        is_over: watch.end().is_some(),
    };
    let choice = choose(&found.candidates, settings.options.prefer, settings.measuring, known, watch)
        .ok_or_else(|| CommandError::of_search(path, problem, nothing()))?;
    let file = to_file(&choice.measured[choice.chosen], problem, &settings.options);
    // Nothing is written that would not be accepted.
    plan(problem, &file).map_err(|error| CommandError::Generate { problem: path.clone(), error: error.into() })?;
    let out = arguments.out.clone().unwrap_or_else(|| template_path(path));
    write(&out, &file.to_text(&problem.unknowns))?;
    watch.finish();
    let end = watch.end().or(found.is_cut.then_some(End::Shards));
    let end = end.filter(|_| found.untried + found.unplanned > 0 || choice.is_cut || found.is_cut);
    let cut = end.map(|end| Cut::new(end, found, &choice));
    let (prefer, seconds) = (settings.options.prefer, watch.seconds());
    Ok(Output::of(&Report::new(problem, prefer, templates, &choice, cut, out.display().to_string(), seconds)))
}

/// Screens what a shard found and writes it for the merge. A shard that finds nothing says so in its file.
fn hand_over(
    arguments: &Arguments,
    problem: &Problem,
    settings: &Settings,
    share: Share,
    found: Result<Found, SearchError>,
    watch: &Watch,
) -> Result<Output, CommandError> {
    let (found, attempts) = match found {
        Ok(found) => (found, Vec::new()),
        Err(SearchError::NotFound { attempts, untried, .. }) => {
            let ways = attempts.len() + untried;
            (Found { candidates: Vec::new(), ways, untried, unplanned: 0, is_cut: untried > 0 }, attempts)
        }
        Err(error) => return Err(CommandError::of_search(&arguments.file, problem, error)),
    };
    let screened = screen(&found.candidates, settings.options.prefer, settings.measuring, watch);
    let candidate = |(candidate, stability)| ShardCandidate::new(candidate, stability, problem, settings);
    let shard = ShardFile {
        shard: share.to_string(),
        common: Common::new(problem, settings),
        ways: found.ways,
        untried: found.untried,
        unplanned: found.unplanned,
        is_cut: found.is_cut,
        found: found.candidates.len(),
        attempts,
        candidates: screened.into_iter().map(candidate).collect(),
    };
    let name = format!("{}.shard-{}-of-{}.json", problem.name, share.number(), share.of());
    let out = arguments.out.clone().unwrap_or_else(|| arguments.file.with_file_name(name));
    write(&out, &shard.to_text())?;
    watch.finish();
    Ok(Output::of(&ShardReport::new(&shard, out.display().to_string(), watch.seconds())))
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::search::monitor::Unmonitored;

    #[test]
    fn a_larger_limit_is_tried_where_a_smaller_one_does_not_do() {
        let text = "fn conics(a: [f64; 6], b: [f64; 6]) -> (x, y) {
            for c in [a, b] { dot(c, [x * x, x * y, y * y, x, y, 1]) == 0; }
        }";
        let problem = Problem::parse("conics.rs", text).unwrap();
        let algebra = check(&problem).unwrap();
        let within = |limits: &[usize]| {
            let mut options = SearchOptions::default();
            let found = first_found(&problem, &algebra, &mut options, limits, &Unmonitored);
            (found.map(|found| found.candidates[0].template.rows()).map_err(|error| error.to_string()), options)
        };
        let (found, options) = within(&[7, 20, 30]);
        assert_eq!((found.as_ref().copied(), options.max_columns), (Ok(6), 20));
        assert_eq!((found, options), within(&[20]));
        assert!(within(&[6, 7]).0.unwrap_err().contains("within 7 columns"));
    }
}
