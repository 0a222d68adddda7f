//! Turns a polynomial problem, written as a short Rust-syntax function, into a specialised Rust solver.
//!
//! The modules are the pipeline, in order; after each stands what holds when it is done.

/// Algebra over Z_p, Gröbner bases included, on which everything stands.
pub mod algebra;
pub mod arithmetic;
pub mod rational;

/// Text to problem: names resolved, shapes checked, spans kept.
pub mod problem;

pub mod diagnostic;
pub mod expression;
pub mod product_sum;

/// Problem to instance over Z_p: same support, data on their variety.
pub mod instance;

/// Instance to number of solutions: finite, equal at two primes.
pub mod check;

/// Problem to problem with fewer unknowns, and how to recover the others.
pub mod presolve;
pub mod symmetry;

pub mod attempt;
/// How a search tells what it does and is told to end, what it looks for first, which share of the work is its own, and what it tried in vain.
pub mod monitor;
pub mod pareto;
pub mod preference;
pub mod share;

#[cfg(feature = "search")]
pub mod choose;
mod explore;
pub mod search;
mod starts;
/// Instance to elimination template: it holds at a prime and seed not used to find it, and no row can be dropped.
pub mod template;

mod block_triangular;
/// Template to plan: no algebra left, every value written before it is read.
pub mod code;
mod constant_rows;
pub mod plan;
pub mod schedule;
mod straight_line;

/// Plan to action matrix in any field: exact over Z_p, and the emitted arithmetic in `f64`.
pub mod interpret;
#[cfg(feature = "search")]
pub mod stability;

/// Plan to Rust source: it parses, and the same plan gives the same bytes.
pub mod emit;

pub mod builder;
/// All of it for one problem, and for the folder of a build script.
pub mod generate;

pub use builder::{BuildError, Generator};

/// The `eliminant` command.
#[cfg(feature = "command")]
pub mod command;
