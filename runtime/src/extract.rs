//! Unknowns from an eigenvector.

use crate::scalar::Scalar;

/// The least-squares ratio x of known monomial values:
///
/// x = sum over k of conj(v\[m_k\]) v\[x m_k\] / sum over k of |v\[m_k\]|^2
///
/// `values` is an eigenvector v of the action matrix: the values of the basis monomials at a solution, up to a common
/// factor. `pairs` lists the positions (m_k, x m_k) of monomials that differ by the factor x; all of them are used,
/// weighted by their size.
///
/// None when all |v\[m_k\]| are at the rounding level of v, when a result is not finite, or a position is out of range.
#[inline]
#[must_use]
pub fn ratio<S: Scalar>(values: &[S], pairs: &[(u16, u16)]) -> Option<S> {
    let mut numerator = S::ZERO;
    let mut denominator = 0.0;
    for &(from, to) in pairs {
        let (from, to) = (*values.get(usize::from(from))?, *values.get(usize::from(to))?);
        numerator += from.conj() * to;
        denominator += from.modulus_squared();
    }
    let total: f64 = values.iter().map(|value| value.modulus_squared()).sum();
    let rounding = values.len() as f64 * f64::EPSILON;
    let quotient = numerator.scale(1.0 / denominator);
    (denominator > rounding * rounding * total && quotient.is_finite()).then_some(quotient)
}
