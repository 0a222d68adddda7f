//! The options of a search, and how its candidates are measured.

use crate::search::SearchOptions;
use crate::search::choose::Measuring;

/// When a template is made by the trace of a Gröbner basis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Tracing {
    Never,
    /// If growing finds nothing within all limits on columns, or until the time is over.
    WhereNothingIsFound,
    /// Nothing is grown.
    AtOnce,
}

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
    pub(super) tracing: Tracing,
}

impl Settings {
    /// Settings with one limit on columns.
    pub(super) fn new(options: SearchOptions, trials: usize, confirm: usize) -> Self {
        let seed = options.seed;
        let measuring = Measuring { trials, confirm, seed };
        Self { options, measuring, wider: None, nothing_within: None, tracing: Tracing::Never }
    }

    /// The settings of the second try, if there is one.
    pub(super) fn widened(&self) -> Option<Self> {
        let max_columns = self.wider?;
        let options = SearchOptions { max_columns, ..self.options.clone() };
        let nothing_within = Some(self.options.max_columns);
        Some(Self { options, wider: None, nothing_within, ..*self })
    }
}
