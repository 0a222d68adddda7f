//! Turns a polynomial problem, written as a short Rust-syntax function, into a specialised Rust solver.

pub mod algebra;
pub mod arithmetic;
pub mod diagnostic;
pub mod expression;
pub mod instance;
pub mod presolve;
pub mod problem;
pub mod rational;
pub mod template;
