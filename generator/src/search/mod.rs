//! Searches elimination templates: many ways to grow, act and reduce, judged by the planned work and, where it is measured, by stability.
//!
//! The result depends on the problem and the options only: not on the number of threads, and not on time unless the monitor ends the search early. Work is done in an
//! order that depends on the problem and the options only, so that what is left out then is the end of it.

pub mod attempt;
mod best_shift;
mod candidate;
mod candidates;
pub mod choose;
mod error;
mod explore;
pub mod grow;
pub mod improve;
mod index_set;
pub mod measuring;
pub mod monitor;
mod options;
pub mod pareto;
pub mod preference;
pub mod reduce;
pub mod share;
pub mod solving_set;
mod starts;
pub mod tableau;

pub use candidate::Candidate;
pub use candidates::{Found, candidates, in_order};
pub use error::SearchError;
pub use options::{MOST_COLUMNS, SearchOptions};
