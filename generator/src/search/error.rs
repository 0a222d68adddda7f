//! Why a search finds nothing.

use super::failed_strategy::{FailedStrategies, FailedStrategy};
use super::options::SearchOptions;

/// Why a search found nothing.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SearchError {
    /// Random data over Z_p could not be drawn with the support of the problem.
    #[error("no random instance has the support of the problem: a coefficient vanishes for most data")]
    NoInstance,
    /// Every template has more columns than the limit.
    #[error(
        "every elimination template has at least {least} columns, one for each solution up to sign and one more; \
         the limit is {max_columns}"
    )]
    TooFewColumns {
        /// The limit on the number of columns.
        max_columns: usize,
        /// [`crate::check::SolutionCount::least_columns`].
        least: usize,
    },
    /// No set of shifts within the limits solves.
    #[error(
        "no elimination template within {max_columns} columns{}: {}",
        ended(*.untried, *.is_over),
        FailedStrategies(failed)
    )]
    NotFound {
        /// The limit on the number of columns.
        max_columns: usize,
        /// The strategies that were tried.
        failed: Vec<FailedStrategy>,
        /// Number of strategies that were not tried.
        untried: usize,
        /// Whether the monitor ended the search.
        is_over: bool,
    },
}

impl SearchError {
    /// A search that was interrupted before a strategy began.
    pub(super) fn interrupted(options: &SearchOptions) -> Self {
        Self::NotFound { max_columns: options.max_columns, failed: Vec::new(), untried: 0, is_over: true }
    }
}

fn ended(untried: usize, is_over: bool) -> String {
    match (is_over, untried) {
        (true, 0) => ", and the search ended early: the last strategies were cut short".to_owned(),
        (true, _) => format!(", and the search ended early, with {untried} strategies not tried"),
        (false, _) => String::new(),
    }
}
