//! From the data to the action matrix.
//!
//! 1. [`program`] computes the coefficients of large problems; small problems emit statements.
//!    [`quotients`] tell where presolve divided by a number close to zero.
//! 2. [`template`] fills the elimination template, and [`lu`] eliminates its diagonal blocks.

pub(crate) mod lu;
pub(crate) mod program;
pub(crate) mod quotients;
pub(crate) mod template;
