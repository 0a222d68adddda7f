//! What an experiment is run with.

use std::path::PathBuf;

/// What an experiment is run with.
#[derive(Clone, Debug)]
pub struct Options {
    /// Number of instances; `None` for the default of the experiment.
    pub runs: Option<usize>,
    /// Seed of all instances.
    pub seed: u64,
    /// Scene file of the experiment `real`.
    pub scene: Option<PathBuf>,
}

impl Options {
    /// The number of instances, by default that of the experiment.
    pub(super) fn runs_or(&self, default: usize) -> usize {
        self.runs.unwrap_or(default)
    }
}
