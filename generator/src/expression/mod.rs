//! Coefficient expressions: a directed acyclic graph of arithmetic on the data, shared by value.
//!
//! Every node carries its value at two fixed random points of the data's variety, one over each of
//! two primes near 2^31. Two nodes with equal values are the same node, however they were written:
//! `a * b + c` and `c + b * a` are one node, `a * b - b * a` is 0, and with `#[symmetric]` data
//! `g[0][1]` and `g[1][0]` are one.
//!
//! Two different expressions of low degree have equal values at both points with a probability of
//! about 2^-62. Among 10^5 nodes there are 5 10^9 pairs, so a false merge has a probability below
//! 10^-6. Every template is checked at further primes besides.

pub mod arithmetic;
mod dependence;
pub mod derivation;
mod graph;
mod of_solution;
mod polynomial;
pub mod product_sum;
pub mod rational;

pub use graph::{Expression, ExpressionGraph, ExpressionId};
pub(crate) use graph::{FINGERPRINT_FIELDS, NoValue};
pub use polynomial::{SignedProduct, SymbolicPolynomial};
