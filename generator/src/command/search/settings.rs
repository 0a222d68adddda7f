//! The options of a search, and how its candidates are measured.

use crate::search::SearchOptions;
use crate::search::choose::Measuring;

/// What a search is asked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Settings {
    /// Seed, preference and bounds. `max_columns` is the limit that is tried first.
    pub(super) options: SearchOptions,
    pub(super) measuring: Measuring,
    /// The limit on columns that is tried if nothing that solves well is found within the first
    /// one.
    pub(super) wider: Option<usize>,
    /// A limit that was tried before, and within which nothing that solves well was found.
    pub(super) nothing_within: Option<usize>,
}

impl Settings {
    /// Settings with one limit on columns.
    pub(super) fn new(options: SearchOptions, trials: usize, confirm: usize) -> Self {
        let seed = options.seed;
        Self { options, measuring: Measuring { trials, confirm, seed }, wider: None, nothing_within: None }
    }

    /// The settings of the second try, if there is one.
    pub(super) fn widened(&self) -> Option<Self> {
        let max_columns = self.wider?;
        let options = SearchOptions { max_columns, ..self.options.clone() };
        let nothing_within = Some(self.options.max_columns);
        Some(Self { options, measuring: self.measuring, wider: None, nothing_within })
    }
}
