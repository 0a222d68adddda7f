//! Unknowns from an eigenvector.

use num_complex::Complex;

use crate::driver::ActionMethod;
use crate::scalar::Scalar;

/// Where eigenvectors of the action matrix come from: for what is listed under `value` the value of the action monomial, and an eigenvector.
pub(crate) trait Eigenpairs<const B: usize> {
    /// That of a real value.
    fn real(&self, value: f64) -> (f64, [f64; B]);
    /// That of any value.
    fn complex(&self, value: Complex<f64>) -> (Complex<f64>, [Complex<f64>; B]);
}

/// The unknowns from an eigenpair; None where they cannot be read.
#[inline]
pub(crate) fn unknowns<S: Scalar, const B: usize, const N: usize, const K: usize, M: ActionMethod<B, N, K>>(
    method: &M,
    value: S,
    vector: &[S; B],
) -> Option<[S; N]> {
    let known = method.known(value, vector);
    let mut x = [S::ZERO; N];
    for (unknown, pairs) in x.iter_mut().zip(M::PAIRS) {
        if !pairs.is_empty() {
            *unknown = ratio(&known, pairs)?;
        }
    }
    if let Some(symmetry) = M::SYMMETRY {
        symmetry.resolve(&mut x);
        if !x.iter().all(|x| x.is_finite()) {
            return None;
        }
    }
    method.recover(&mut x);
    Some(x)
}

/// The least-squares ratio x of known monomial values:
///
/// x = sum over k of conj(v\[m_k\]) v\[x m_k\] / sum over k of |v\[m_k\]|^2
///
/// `values` is an eigenvector v of the action matrix: the values of the basis monomials at a solution, up to a common
/// factor. `pairs` lists the positions (m_k, x m_k) of monomials that differ by the factor x; all of them are used,
/// weighted by their size.
///
/// None when all |v\[m_k\]| vanish, the result is not finite, or a position is out of range. That the v\[m_k\] are no more
/// than rounding errors of v does not show in their size, which depends on the units of the unknowns; it shows in the
/// residual.
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
    let quotient = numerator.scale(1.0 / denominator);
    (denominator > 0.0 && quotient.is_finite()).then_some(quotient)
}
