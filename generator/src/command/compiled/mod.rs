//! Emitted solvers, compiled in a crate of their own and run.

pub(super) mod parameters;
pub(super) mod workspace;
