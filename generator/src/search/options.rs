//! What a search is asked for.

use super::preference::Preference;
use super::share::Share;

/// The largest limit on the number of columns that can be asked for.
pub const MOST_COLUMNS: usize = 20_000;

/// Limits and seeds of a search.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SearchOptions {
    /// Seed of the instances and of the shuffled deletion orders.
    pub seed: u64,
    /// No template has more columns before it is reduced.
    pub max_columns: usize,
    /// No template has a larger basis, where a smaller one can hold all solutions.
    pub max_basis: Option<usize>,
    /// How often each of the smallest templates is enlarged and reduced anew in a shuffled order.
    pub shuffles: u64,
    /// What is looked for first.
    pub prefer: Preference,
    /// Which of the ways to grow are tried.
    pub share: Share,
}

impl SearchOptions {
    /// The bounds of the search that a build script makes for a problem without a template file.
    pub fn for_a_build() -> Self {
        Self { max_columns: 150, shuffles: 0, ..Self::default() }
    }
}

impl Default for SearchOptions {
    fn default() -> Self {
        Self {
            seed: 1,
            max_columns: 600,
            max_basis: None,
            shuffles: 12,
            prefer: Preference::default(),
            share: Share::ALL,
        }
    }
}
