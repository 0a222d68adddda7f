//! Turns a polynomial problem, written as a short Rust-syntax function, into a specialised Rust solver.

pub mod algebra;
pub mod arithmetic;
pub mod block_triangular;
pub mod diagnostic;
pub mod emit;
pub mod expression;
pub mod instance;
pub mod interpret;
pub mod plan;
pub mod presolve;
pub mod problem;
pub mod rational;
pub mod schedule;
pub mod template;
