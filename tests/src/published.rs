//! Published elimination templates of the problems in `templates/`, to stand beside ours.
//!
//! `published.csv` holds, by published name, sizes as rows x columns:
//! - `larsson_2017`: Larsson, Åström, Oskarsson, "Efficient solvers for minimal problems by
//!   syzygy-based reduction", CVPR 2017;
//! - `greedy_2022`: Martyushev, Vráblíková, Pajdla, "Optimizing elimination templates by greedy
//!   parameter search", CVPR 2022, the smaller of the standard and the non-standard one;
//! - `smallest_2023`: Martyushev, Bhayani, Pajdla, "Automatic solver generator for systems of
//!   Laurent polynomial equations", arXiv 2307.00320, 2023: the smallest template that is saved in
//!   the repository of that generator (github.com/martyushev/eliminationTemplates). For some
//!   problems it is smaller than that of the solver which is shipped there. In brackets stands the
//!   name of another published form of the same problem if its template is smaller;
//! - `shipped_2023`: the template of the shipped solver, whose number of basis monomials, and on
//!   random instances of its own the number of instances, median and 99 % quantile of the log10
//!   error and rate of failures follow. The error is that of [`crate::measure::Unpolished`].

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
    /// Rows x columns, and in brackets the name of another form of the problem.
    pub smallest_2023: String,
    /// Rows x columns.
    pub shipped_2023: String,
    /// Size of the eigenvalue problem of `shipped_2023`.
    pub basis: String,
    /// Instances on which `shipped_2023` was measured.
    pub instances: String,
    /// Of the log10 error of `shipped_2023`.
    pub median: String,
    /// Of the log10 error of `shipped_2023`.
    pub p99: String,
    /// Failures of `shipped_2023` per instance.
    pub failure_rate: String,
}

/// All that `published.csv` holds.
///
/// # Errors
/// If the table is malformed.
pub fn published() -> Result<Vec<Published>, csv::Error> {
    csv::Reader::from_reader(include_str!("published.csv").as_bytes()).deserialize().collect()
}

/// The name under which the problem of `case` is published: its documentation says "Published as
/// `name`".
pub fn published_name(case: &Case) -> Option<String> {
    let docs = case.problem().docs.join(" ");
    let words = docs.split_whitespace().collect::<Vec<_>>().join(" ");
    let (_, rest) = words.split_once("Published as `")?;
    rest.split_once('`').map(|(name, _)| name.to_owned())
}

/// The template with the fewest rows that `eliminant search --prefer size` found for a problem when
/// it looked at no template of more than 2.5 times the operations of the cheapest, rows x columns,
/// from `fewest_rows.csv`; `None` where it was not searched.
///
/// # Errors
/// If the table is malformed.
pub fn fewest_rows(name: &str) -> Result<Option<String>, csv::Error> {
    let mut reader = csv::Reader::from_reader(include_str!("fewest_rows.csv").as_bytes());
    let rows: Vec<(String, String)> = reader.deserialize().collect::<Result<_, _>>()?;
    Ok(rows.into_iter().find(|(problem, _)| problem == name).map(|(_, template)| template))
}
