//! Published elimination templates of the problems in `templates/`, to stand beside ours.
//!
//! `published.csv` holds, by published name, sizes as rows x columns:
//! - `larsson_2017`: Larsson, Åström, Oskarsson, "Efficient solvers for minimal problems by syzygy-based reduction", CVPR 2017;
//! - `greedy_2022`: Martyushev, Vráblíková, Pajdla, "Optimizing elimination templates by greedy parameter search", CVPR 2022, the smaller of
//!   the standard and the non-standard one;
//! - `redundant_2023`: Martyushev, Bhayani, Pajdla, "Automatic solver generator for systems of Laurent polynomial equations", 2023, as shipped
//!   with that generator, and of that solver the number of basis monomials, and on random instances the median and the 99 % quantile of its
//!   log10 residual and the rate of failures.

use crate::Case;

/// What is published on one problem; empty fields are unknown.
#[derive(Clone, Debug, Default, PartialEq, Eq, serde::Deserialize)]
pub struct Published {
    /// The name under which it is published.
    pub name: String,
    /// Rows x columns.
    pub larsson_2017: String,
    /// Rows x columns.
    pub greedy_2022: String,
    /// Rows x columns.
    pub redundant_2023: String,
    /// Size of the eigenvalue problem of `redundant_2023`.
    pub basis: String,
    /// Of the log10 residual of `redundant_2023`.
    pub median: String,
    /// Of the log10 residual of `redundant_2023`.
    pub p99: String,
    /// Failures of `redundant_2023` per instance.
    pub failure_rate: String,
}

/// All that `published.csv` holds.
///
/// # Errors
/// If the table is malformed.
pub fn published() -> Result<Vec<Published>, csv::Error> {
    csv::Reader::from_reader(include_str!("published.csv").as_bytes()).deserialize().collect()
}

/// The name under which the problem of `case` is published: its documentation says "Published as `name`".
pub fn published_name(case: &Case) -> Option<String> {
    let docs = case.problem().docs.join(" ");
    let words = docs.split_whitespace().collect::<Vec<_>>().join(" ");
    let (_, rest) = words.split_once("Published as `")?;
    rest.split_once('`').map(|(name, _)| name.to_owned())
}
