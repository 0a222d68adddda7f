//! Coefficient expressions: a directed acyclic graph of arithmetic on the data, shared by value.
//!
//! Every node carries its value at two fixed random points of the data's variety, one over each of two primes near 2^31.
//! Two nodes with equal values are the same node, whatever way they were written: `a * b + c` and `c + b * a` share,
//! `a * b - b * a` is 0, and with `#[symmetric]` data `g[0][1]` and `g[1][0]` share. A false merge among 10^5 nodes has a
//! probability below 10^-6, and every template is checked at further primes anyway.

pub mod arithmetic;
mod graph;
mod polynomial;
pub mod product_sum;
pub mod rational;

pub(crate) use graph::FINGERPRINT_FIELDS;
pub use graph::{Expression, ExpressionGraph, ExpressionId};
pub use polynomial::{SignedProduct, SymbolicPolynomial};
