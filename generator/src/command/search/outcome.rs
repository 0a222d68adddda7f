//! One search from a problem to the template that is chosen, without writing anything.

use std::path::Path;

use super::provenance;
use super::settings::{Settings, Tracing};
use crate::check::check_until;
use crate::command::error::CommandError;
use crate::command::watch::{End, OfTrace, Watch};
use crate::generate::plan;
use crate::problem::Problem;
use crate::search::choose::{Choice, choose};
use crate::search::fallback::{Chosen, Fallback};
use crate::search::measuring::Stability;
use crate::search::monitor::Monitor;
use crate::search::{Found, SearchError, TemplateCandidate, candidates, traced_candidates};
use crate::template::file::TemplateFile;

/// A problem whose template is searched.
#[derive(Clone, Copy)]
pub(super) struct Task<'a> {
    pub(super) path: &'a Path,
    pub(super) problem: &'a Problem,
    pub(super) watch: &'a Watch,
}

/// Candidates to choose from.
pub(super) struct Candidates {
    pub(super) found: Found,
    /// Different templates that were found. Those that several shards found count for each.
    pub(super) templates: usize,
    /// Measurements that were made before, by the shards of a search.
    pub(super) known: Vec<(TemplateCandidate, Stability)>,
}

impl Candidates {
    /// The candidates of a whole search.
    pub(super) fn of(found: Found) -> Self {
        Self { templates: found.candidates.len(), found, known: Vec::new() }
    }

    /// An earlier measurement of a candidate.
    fn known(&self, candidate: &TemplateCandidate) -> Option<Stability> {
        let is_same = |known: &&(TemplateCandidate, Stability)| {
            known.0.template == candidate.template && known.0.presolve == candidate.presolve
        };
        self.known.iter().find(is_same).map(|(_, stability)| stability.clone())
    }
}

/// What a search came to.
pub(super) struct Outcome {
    /// The settings, with the limit on columns within which something was found.
    pub(super) settings: Settings,
    pub(super) candidates: Candidates,
    pub(super) choice: Choice,
    /// What ended the search early, if that left anything out.
    pub(super) end: Option<End>,
    /// The file of the chosen template. It holds for the problem.
    pub(super) file: TemplateFile,
}

/// Searches, measures and chooses, with what follows where nothing that solves well is found
/// ([`Fallback::after`]).
pub(super) fn search(task: Task<'_>, settings: Settings) -> Result<Outcome, CommandError> {
    let Task { path, problem, watch } = task;
    watch.say("counting solutions");
    let count = check_until(problem, watch.ctrl_c())?;
    let within = |settings: Settings| match candidates(problem, &count, &settings.options, watch) {
        Ok(found) => conclude(task, settings, Candidates::of(found)).map(Ok),
        Err(error) => Ok(Err(error)),
    };
    let traced = |settings: Settings| match traced_candidates(problem, &count, &settings.options, &OfTrace(watch)) {
        Ok(found) => conclude(task, settings, Candidates::of(found)),
        Err(error) => Err(CommandError::of_search(path, problem, error)),
    };
    if settings.tracing == Tracing::AtOnce {
        return traced(settings);
    }
    let (widened, limit) = (settings.widened(), settings.options.max_columns);
    let wider = widened.map(|widened| {
        move || {
            watch.say(&format!("nothing good within {limit} columns; trying {}", widened.options.max_columns));
            within(widened.clone())
        }
    });
    let or_traced = || traced(settings.clone());
    let fallback = Fallback {
        wider: wider.as_ref().map(|wider| wider as _),
        traced: (settings.tracing == Tracing::WhereNothingIsFound).then_some(&or_traced as _),
        keep: &|outcome: &mut Outcome| {
            if let Some(end) = watch.end() {
                outcome.end = Some(end);
                provenance::add_end(&mut outcome.file.provenance, end);
            }
        },
        is_over: &|| watch.end().is_some(),
    };
    let attempt = fallback.after(within(settings.clone())?)?;
    attempt.map_err(|error| CommandError::of_search(path, problem, error))
}

impl Chosen for Outcome {
    fn solves_well(&self) -> bool {
        self.choice.solves_well()
    }

    fn is_cut(&self) -> bool {
        self.end.is_some()
    }
}

/// Measures and chooses.
pub(super) fn conclude(task: Task<'_>, settings: Settings, candidates: Candidates) -> Result<Outcome, CommandError> {
    let Task { path, problem, watch } = task;
    let found = &candidates.found;
    let nothing = || SearchError::NotFound {
        max_columns: settings.options.max_columns,
        failed: Vec::new(),
        untried: found.untried,
        is_over: watch.end().is_some(),
    };
    let known = |candidate: &TemplateCandidate| candidates.known(candidate);
    let choice = choose(&found.candidates, settings.options.prefer, settings.measuring, &known, watch)
        .ok_or_else(|| CommandError::of_search(path, problem, nothing()))?;
    let end = watch.end().or(found.is_cut.then_some(End::Shards));
    let end = end.filter(|_| found.untried + found.unplanned > 0 || choice.is_cut || found.is_cut);
    let chosen = &choice.measured[choice.chosen];
    let mut file = chosen.candidate.to_file(problem, &settings.options);
    provenance::complete(&mut file.provenance, chosen, &settings, end);
    // Nothing is handed on that a build would refuse.
    plan(problem, &file).map_err(|error| CommandError::Generate { problem: path.to_owned(), error: error.into() })?;
    Ok(Outcome { settings, candidates, choice, end, file })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::search::SearchOptions;

    #[test]
    fn a_wider_limit_is_tried_only_where_the_first_does_not_do() {
        let text = "fn conics(a: [f64; 6], b: [f64; 6]) -> (x, y) {
            for c in [a, b] { dot(c, [x * x, x * y, y * y, x, y, 1]) == 0; }
        }";
        let problem = Problem::parse("conics.rs", text).unwrap();
        let watch = Watch::new(None);
        let task = Task { path: Path::new("conics.rs"), problem: &problem, watch: &watch };
        let within = |max_columns: usize, wider: Option<usize>| {
            let options = SearchOptions { max_columns, ..SearchOptions::default() };
            let outcome = search(task, Settings { wider, ..Settings::new(options, 1, 1) });
            let outcome = outcome.map_err(|error| error.to_string())?;
            let rows = outcome.file.template.rows();
            Ok((rows, outcome.settings.options.max_columns, outcome.settings.nothing_within))
        };
        assert_eq!(within(7, Some(20)), Ok((6, 20, Some(7))));
        assert_eq!(within(20, None), Ok((6, 20, None)));
        assert_eq!(within(20, Some(30)), Ok((6, 20, None)));
        let nothing: Result<_, String> = within(6, Some(7));
        assert!(nothing.unwrap_err().contains("within 7 columns"));
        // The record says what to repeat.
        let options = SearchOptions { max_columns: 7, ..SearchOptions::default() };
        let settings = Settings { wider: Some(20), ..Settings::new(options, 20, 30) };
        let file = search(task, settings.clone()).unwrap().file;
        assert_eq!(provenance::recorded_settings(&file.provenance), Ok(settings));
        assert!(file.provenance.iter().map(|(key, _)| key.as_str()).is_sorted_by_key(provenance::position));
    }
}
