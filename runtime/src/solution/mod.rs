//! From an eigenpair to a solution.
//!
//! 1. [`extract`] reads unknowns off an eigenvector; [`symmetries`] resolves unknowns that are
//!    known up to sign.
//! 2. [`mod@polish`] improves a solution on the original equations, which [`system`] evaluates from
//!    tables, or [`dense_system`] from a matrix; [`refine`] does so at twice the precision where a
//!    solution is ill-conditioned.
//! 3. [`distinct`] removes solutions that were found more than once.
//! 4. `shared_value` tells apart the solutions that share an eigenvalue.
//! 5. `candidates` collects all solutions, `real_solutions` the real ones.
//! 6. [`inequality`] tells which of them are wanted.
//! 7. [`chart`] gives vectors up to scale from the coordinates that were solved for.

pub(crate) mod candidates;
pub(crate) mod chart;
pub(crate) mod dense_system;
pub(crate) mod distinct;
pub(crate) mod extract;
pub(crate) mod inequality;
pub(crate) mod least_squares;
pub(crate) mod polish;
pub(crate) mod real_solutions;
pub(crate) mod refine;
pub(crate) mod shared_value;
pub(crate) mod symmetries;
pub(crate) mod system;
