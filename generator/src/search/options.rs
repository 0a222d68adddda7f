//! What a search is asked for.

use super::preference::Preference;
use super::shard::Shard;

/// The largest limit on the number of columns that can be set.
pub const MOST_COLUMNS: usize = 20_000;

/// The limit on the number of columns of a second try.
pub const MORE_COLUMNS: usize = 1500;

/// Limits and seeds of a search.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SearchOptions {
    /// Seed of the instances and of the shuffled deletion orders.
    pub seed: u64,
    /// Most columns of a template before it is reduced.
    pub max_columns: usize,
    /// Largest |B|, unless the solutions need more.
    pub max_basis: Option<usize>,
    /// How often each of the smallest templates is enlarged and reduced anew in a shuffled order.
    pub shuffles: u64,
    /// What is looked for first.
    pub prefer: Preference,
    /// Which of the strategies are tried.
    pub shard: Shard,
}

impl SearchOptions {
    /// The bounds of the search that a build script makes if a problem has no template file.
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
            shard: Shard::ALL,
        }
    }
}
