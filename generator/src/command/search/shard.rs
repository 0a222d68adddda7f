//! The files by which the shards of a search hand over what they found, and their merge.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::outcome::{Candidates, Task};
use super::settings::Settings;
use crate::command::error::CommandError;
use crate::command::files::read_text;
use crate::command::report::to_json;
use crate::generate::plan;
use crate::problem::Problem;
use crate::search::choose::screen;
use crate::search::failed_strategy::FailedStrategy;
use crate::search::measuring::Stability;
use crate::search::preference::Preference;
use crate::search::shard::Shard;
use crate::search::{Found, SearchError, SearchOptions, TemplateCandidate, in_order};
use crate::template::file::TemplateFile;

/// What one shard found; a JSON object.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ShardFile {
    /// Which of how many shards, such as `2/4`.
    pub(super) shard: String,
    /// What all shards of a search must have in common.
    pub(super) common: Common,
    /// Number of strategies of this shard, and number of these that were not tried because the time
    /// was up.
    pub(super) strategies: usize,
    pub(super) untried: usize,
    /// Number of templates that were not planned because the time was up.
    pub(super) unplanned: usize,
    /// Whether the search of this shard ended early.
    pub(super) is_cut: bool,
    /// Number of different templates found.
    pub(super) found: usize,
    /// The strategies that were tried, if nothing was found.
    pub(super) failed: Vec<FailedStrategy>,
    /// The first candidates in the order of the preference.
    pub(super) candidates: Vec<ShardCandidate>,
}

impl ShardFile {
    /// Screens what a shard found. A shard that finds nothing says what it tried.
    pub(super) fn new(
        task: Task<'_>,
        settings: &Settings,
        found: Result<Found, SearchError>,
    ) -> Result<Self, CommandError> {
        let Task { path, problem, watch } = task;
        let (found, failed) = match found {
            Ok(found) => (found, Vec::new()),
            Err(SearchError::NotFound { failed, untried, is_over, .. }) => {
                let strategies = failed.len() + untried;
                (Found { candidates: Vec::new(), strategies, untried, unplanned: 0, is_cut: is_over }, failed)
            }
            Err(error) => return Err(CommandError::of_search(path, problem, error)),
        };
        let screened = screen(&found.candidates, settings.options.prefer, settings.measuring, watch);
        let candidate = |(candidate, stability)| ShardCandidate::new(candidate, stability, problem, settings);
        Ok(Self {
            shard: settings.options.shard.to_string(),
            common: Common::new(problem, settings),
            strategies: found.strategies,
            untried: found.untried,
            unplanned: found.unplanned,
            is_cut: found.is_cut,
            found: found.candidates.len(),
            failed,
            candidates: screened.into_iter().map(candidate).collect(),
        })
    }

    pub(super) fn to_text(&self) -> String {
        to_json(self)
    }
}

/// What all shards of a search must have in common.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Common {
    generator: String,
    problem: String,
    fingerprint: String,
    prefer: Preference,
    seed: u64,
    max_columns: usize,
    max_basis: Option<usize>,
    shuffles: u64,
    trials: usize,
    confirm: usize,
}

impl Common {
    pub(super) fn new(problem: &Problem, settings: &Settings) -> Self {
        let Settings { options, measuring, .. } = settings;
        Self {
            generator: env!("CARGO_PKG_VERSION").to_owned(),
            problem: problem.name.clone(),
            fingerprint: format!("{:016x}", problem.fingerprint()),
            prefer: options.prefer,
            seed: options.seed,
            max_columns: options.max_columns,
            max_basis: options.max_basis,
            shuffles: options.shuffles,
            trials: measuring.trials,
            confirm: measuring.confirm,
        }
    }

    fn settings(&self) -> Settings {
        let options = SearchOptions {
            seed: self.seed,
            max_columns: self.max_columns,
            max_basis: self.max_basis,
            shuffles: self.shuffles,
            prefer: self.prefer,
            shard: Shard::ALL,
        };
        Settings::new(options, self.trials, self.confirm)
    }
}

/// A template with its measurement.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ShardCandidate {
    strategy: usize,
    growth: String,
    /// The text of a template file.
    template: String,
    measured: Option<Stability>,
}

impl ShardCandidate {
    pub(super) fn new(
        candidate: &TemplateCandidate,
        measured: Option<Stability>,
        problem: &Problem,
        settings: &Settings,
    ) -> Self {
        Self {
            strategy: candidate.strategy,
            growth: candidate.growth.clone(),
            template: candidate.to_file(problem, &settings.options).to_text(&problem.unknowns),
            measured,
        }
    }

    fn read(self, problem: &Problem) -> Result<(TemplateCandidate, Option<Stability>), String> {
        let file = TemplateFile::parse(&self.template, &problem.unknowns).map_err(|error| error.to_string())?;
        let plan = plan(problem, &file).map_err(|error| error.to_string())?.plan;
        let (strategy, growth) = (self.strategy, self.growth);
        let TemplateFile { presolve, template, zero_sets, .. } = file;
        Ok((TemplateCandidate { presolve, strategy, growth, template, plan, zero_sets }, self.measured))
    }
}

/// Joins the files of all shards of one search; their order does not matter.
pub(super) fn merge(path: &Path, problem: &Problem, files: &[PathBuf]) -> Result<(Settings, Candidates), CommandError> {
    let shards = read_all(path, problem, files)?;
    let Some((_, _, first)) = shards.first() else {
        return Err(CommandError::Shards { problem: path.to_owned(), reason: "no shard is given".to_owned() });
    };
    let settings = first.common.settings();
    let total = |count: fn(&ShardFile) -> usize| shards.iter().map(|(_, _, shard)| count(shard)).sum();
    let (strategies, untried) = (total(|shard| shard.strategies), total(|shard| shard.untried));
    let (unplanned, templates) = (total(|shard| shard.unplanned), total(|shard| shard.found));
    let is_cut = shards.iter().any(|(_, _, shard)| shard.is_cut);
    let mut failed = Vec::new();
    let (mut candidates, mut known) = (Vec::new(), Vec::new());
    for (file, _, shard) in shards {
        failed.extend(shard.failed);
        for candidate in shard.candidates {
            let fail = |reason| CommandError::Shard { path: file.clone(), reason };
            let (candidate, stability) = candidate.read(problem).map_err(fail)?;
            known.extend(stability.map(|stability| (candidate.clone(), stability)));
            candidates.push(candidate);
        }
    }
    let candidates = in_order(candidates, settings.options.prefer);
    if candidates.is_empty() {
        let max_columns = settings.options.max_columns;
        let error = SearchError::NotFound { max_columns, failed, untried, is_over: is_cut };
        return Err(CommandError::of_search(path, problem, error));
    }
    let found = Found { candidates, strategies, untried, unplanned, is_cut };
    Ok((settings, Candidates { found, templates, known }))
}

/// All shards in order, after checks that they belong to the problem and to each other.
fn read_all(
    path: &Path,
    problem: &Problem,
    files: &[PathBuf],
) -> Result<Vec<(PathBuf, Shard, ShardFile)>, CommandError> {
    let mut shards: Vec<(PathBuf, Shard, ShardFile)> = Vec::new();
    for file in files {
        let fail = |reason: String| CommandError::Shard { path: file.clone(), reason };
        let text = read_text(file)?;
        let shard: ShardFile =
            serde_json::from_str(&text).map_err(|error| fail(format!("not a file of a shard: {error}")))?;
        let share: Shard = shard.shard.parse().map_err(|error| fail(format!("`{}`: {error}", shard.shard)))?;
        let common = &shard.common;
        if common.problem != problem.name || common.fingerprint != format!("{:016x}", problem.fingerprint()) {
            return Err(fail(format!("found for another problem than `{}` as it is now", problem.name)));
        }
        if let Some((other, of, first)) = shards.first()
            && (first.common != shard.common || of.of() != share.of())
        {
            return Err(fail(format!("not of the same search as `{}`: other options", other.display())));
        }
        if let Some((other, ..)) = shards.iter().find(|(_, known, _)| *known == share) {
            return Err(fail(format!("shard {share} again, which `{}` is already", other.display())));
        }
        shards.push((file.clone(), share, shard));
    }
    shards.sort_by_key(|(_, share, _)| share.number());
    let of = shards.first().map_or(0, |(_, share, _)| share.of());
    let has = |number: &usize| shards.iter().any(|(_, share, _)| share.number() == *number);
    let missing: Vec<String> = (1..=of).filter(|number| !has(number)).map(|number| format!("{number}/{of}")).collect();
    match missing.is_empty() {
        true => Ok(shards),
        false => Err(CommandError::Shards {
            problem: path.to_owned(),
            reason: format!("the shards {} are missing", missing.join(", ")),
        }),
    }
}
