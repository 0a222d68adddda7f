//! Turns a polynomial problem, written as a short function in Rust syntax, into a specialised Rust
//! solver.
//!
//! The modules are the pipeline in order: none depends on a later one. The line of each says what
//! holds when it is done. Modules that only the search needs are compiled with the feature
//! `search`; a build script that has a template for every problem compiles the others.

/// Algebra over Z_p, on which everything stands; Gröbner bases with the feature `search`.
pub mod algebra;

/// Coefficients as expressions in the data: equal ones are one node, evaluated in any field.
pub mod expression;

/// Text to problem: names resolved, shapes checked, spans kept; random instances on the data's
/// variety.
pub mod problem;

/// Problem to number of solutions: finite, and equal at two primes.
#[cfg(feature = "search")]
pub mod check;

/// Problem to problem with fewer unknowns, and how to recover the others.
pub mod presolve;

/// Shifts to elimination template: written, read, and proved over Z_p.
pub mod template;

/// Template to plan: no algebra left, every value written before it is read.
pub mod plan;

/// Plan to Rust source: it parses, and the same plan gives the same bytes.
pub mod emit;

/// Problem and template to source: the template belongs to the problem and gives the number of
/// solutions that its file says, and the plan is exact over Z_p.
pub mod generate;

/// Problem to templates: each holds at a prime and seed not used to find it, and every row is
/// needed.
#[cfg(feature = "search")]
pub mod search;

/// Instance to its true solutions: simple ones, to 30 digits and more, and whether they are all.
#[cfg(feature = "oracle")]
pub mod oracle;

/// A folder of problems to solvers in `OUT_DIR`: the API of build scripts.
pub mod build;

/// The `eliminant` command: the same for a person, with files, reports and drawings.
#[cfg(feature = "command")]
pub mod command;

pub use build::{BuildError, Generator};
