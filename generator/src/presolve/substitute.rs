//! Puts a polynomial in the place of an unknown.

use super::reduced::MAX_TERMS;
use crate::algebra::{MAX_UNKNOWNS, Monomial};
use crate::expression::{ExpressionGraph, SymbolicPolynomial};

/// p, which has no negative exponents, with x replaced by `value`; `None` if it grows too long or
/// an exponent overflows.
pub(super) fn substitute(
    graph: &mut ExpressionGraph,
    p: &SymbolicPolynomial,
    unknown: usize,
    value: &SymbolicPolynomial,
) -> Option<SymbolicPolynomial> {
    let highest = p.monomials().map(|m| m.exponent(unknown)).max().unwrap_or(0);
    // With p = p_n x^n + .. + p_0, p_k free of x, by Horner: (..(p_n value + p_(n-1)) value + ..) +
    // p_0.
    let mut result = SymbolicPolynomial::ZERO;
    for power in (0..=highest).rev() {
        result = graph.polynomial_mul(&result, value)?;
        if result.terms().len() > MAX_TERMS {
            return None;
        }
        result = graph.polynomial_add(&result, &coefficient(p, unknown, power));
    }
    Some(result)
}

/// The coefficient of a power of the unknown: a polynomial that is free of it.
pub(super) fn coefficient(p: &SymbolicPolynomial, unknown: usize, power: i8) -> SymbolicPolynomial {
    let mut x_power = [0; MAX_UNKNOWNS];
    x_power[unknown] = power;
    let x_power = Monomial::from_exponents(&x_power);
    let terms = p.terms().iter().filter(|(m, _)| m.exponent(unknown) == power);
    SymbolicPolynomial::from_terms(terms.map(|&(m, c)| (m.over(&x_power), c)).collect())
}
