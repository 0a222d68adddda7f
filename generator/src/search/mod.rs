//! Searches elimination templates: many strategies are grown and reduced, judged by the planned
//! work and, if measured, by stability.
//!
//! The result depends on the problem and the options only, not on the number of threads, and not on
//! time unless the monitor ends the search early. If interrupted, only the last items are skipped,
//! because items begin in an order that depends on the problem and the options only.
//!
//! The modules stand in the order of use:
//!
//! ```text
//! formulation ─ strategy ─ grow ─ seed_sets ─ reduce ─ improve ─ candidates ─ measuring ─ choose
//!                          best_shift   solving_set, tableau
//! ```

// Limits, seeds and preference of a search; what is heard of it; a part of it.
mod options;

pub mod monitor;
pub mod pareto;
pub mod preference;
pub mod shard;

// Problem to formulations: presolved, on random instances, with or without the use of sign
// changes.
mod formulation;

// Formulations to strategies: in which order multiples of the equations are stacked.
mod strategy;

// Sets of shifts, each a superset of the one before.
pub mod grow;

mod best_shift;

// A set of shifts to a basis B on which multiplication by the action monomial is known.
pub mod solving_set;

mod index_set;

pub mod tableau;

// A Gröbner basis to sets of shifts that solve.
mod traced_shifts;

// A strategy to the sets of shifts that solve.
mod seed_sets;

// A set of shifts that solves to a template none of whose rows can be deleted.
pub mod reduce;

// A template to one with fewer rows, by a new start in its surroundings.
pub mod improve;

mod cache;

mod reduce_strategy;

// All strategies to candidates: different, planned, and in the order of the preference.
mod candidate;

mod candidates;

mod error;

pub mod failed_strategy;

// A plan to what it does on random real instances, by the kernels that ship.
pub mod measuring;

// Candidates to one choice.
pub mod choose;

// What is tried where nothing that solves well was found.
pub mod fallback;

pub use candidate::TemplateCandidate;
pub use candidates::{Found, candidates, in_order, traced_candidates};
pub use error::SearchError;
pub use options::{MORE_COLUMNS, MOST_COLUMNS, SearchOptions};
