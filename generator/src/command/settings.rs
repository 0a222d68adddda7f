//! The options of a search, and how its candidates are measured.

use crate::search::SearchOptions;
use crate::search::choose::Measuring;

/// What a search is asked for.
#[derive(Clone, Debug)]
pub(super) struct Settings {
    pub(super) options: SearchOptions,
    pub(super) measuring: Measuring,
}

impl Settings {
    pub(super) fn new(options: SearchOptions, trials: usize, confirm: usize) -> Self {
        let seed = options.seed;
        Self { options, measuring: Measuring { trials, confirm, seed } }
    }
}
