//! Unknowns from an eigenvector.

use crate::number::{Arithmetic, Scalar};
use crate::size::{Size, Vector};
use crate::solver_instance::{BasisVector, Point, SolverInstance};

/// Reads the unknowns off an eigenpair; `None` if they cannot be read.
#[inline]
pub(crate) fn unknowns<S: Scalar, I: SolverInstance>(
    solver: &I,
    value: S,
    vector: &BasisVector<I, S>,
) -> Option<Point<I, S>> {
    let values = solver.monomial_values(value, vector);
    let mut x = solver.sizes().unknowns.filled(S::ZERO);
    for (at, unknown) in x.as_mut().iter_mut().enumerate() {
        let pairs = solver.ratios(at);
        if !pairs.is_empty() {
            *unknown = ratio(values.as_ref(), pairs)?;
        }
    }
    if let Some(symmetries) = solver.symmetries() {
        symmetries.resolve(x.as_mut());
        if !x.as_ref().iter().all(|x| x.is_finite()) {
            return None;
        }
    }
    solver.recover(&mut x);
    Some(x)
}

/// The least-squares ratio x of monomial values:
///
/// x = sum over k of conj(v\[m_k\]) v\[x m_k\] / sum over k of |v\[m_k\]|^2
///
/// `values` are the values of monomials at a solution, up to a common factor. `pairs` lists the
/// positions (m_k, x m_k) of monomials that differ by the factor x. All pairs are used, weighted by
/// their size.
///
/// `None` if all |v\[m_k\]| vanish, the result is not finite, or a position is out of range.
/// Whether the v\[m_k\] exceed the rounding errors of v does not show in their size, which depends
/// on the units of the unknowns. It shows in the residual.
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
    quotient.is_finite().then_some(quotient)
}

/// A product of powers of the unknowns, of which there is one at least. Powers of zero with
/// negative exponents are not finite.
#[inline(always)]
#[must_use]
pub fn monomial_value<T: Arithmetic>(unknowns: &[T], exponents: &[i8]) -> T {
    let one = unknowns[0].constant(1.0);
    let mut value = one;
    for (&unknown, &exponent) in unknowns.iter().zip(exponents) {
        for _ in 0..exponent {
            value = value * unknown;
        }
        if exponent < 0 {
            let inverse = one / unknown;
            for _ in exponent..0 {
                value = value * inverse;
            }
        }
    }
    value
}

/// The first `count` of these values of monomials, from an eigenpair (a, v):
///
/// ```text
///   [ v | a v (if `has_image`) | R v ]      R: the rows of `read`
/// ```
#[inline]
pub fn monomial_values<S: Scalar, K: Size>(
    count: K,
    (value, vector): (S, &[S]),
    has_image: bool,
    read: &[impl Vector<f64>],
) -> K::Vector<S> {
    let mut values = count.filled(S::ZERO);
    let (basis, mut rest) = values.as_mut().split_at_mut(vector.len());
    basis.copy_from_slice(vector);
    if has_image {
        let (image, behind) = rest.split_at_mut(vector.len());
        for (product, &entry) in image.iter_mut().zip(vector) {
            *product = value * entry;
        }
        rest = behind;
    }
    for (sum, row) in rest.iter_mut().zip(read) {
        for (&entry, &factor) in vector.iter().zip(row.as_ref()) {
            *sum += entry.scale(factor);
        }
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::size::Fixed;
    use num_complex::Complex;

    #[test]
    fn ratios_of_monomial_values() {
        // v = (1, x, y, x y, x^2) times a common factor.
        let (x, y) = (Complex::new(2.0, -1.0), Complex::new(0.5, 3.0));
        let common = Complex::new(-0.3, 0.1);
        let v = [Complex::ONE, x, y, x * y, x * x].map(|value| value * common);
        let found = ratio(&v, &[(0, 1), (2, 3), (1, 4)]).unwrap();
        assert!((found - x).modulus() < 1e-15);
        assert_eq!(ratio(&[1.0, 3.0, 2.0, 6.0], &[(0, 1), (2, 3)]), Some(3.0));
        assert!((ratio(&[1e-60, 1.0], &[(0, 1)]).unwrap() - 1e60).abs() < 1e46, "whatever the units");
        assert_eq!(ratio(&[0.0, 0.0], &[(0, 1)]), None);
        assert_eq!(ratio(&[f64::NAN, 1.0], &[(0, 1)]), None);
        assert_eq!(ratio(&[1.0, f64::INFINITY], &[(0, 1)]), None);
        assert_eq!(ratio::<f64>(&[], &[]), None);
        assert_eq!(ratio(&[1.0], &[(0, 7)]), None);
    }

    #[test]
    fn monomials_are_those_of_the_basis_of_its_image_and_the_read_rows() {
        let (value, vector) = (Complex::new(0.0, 2.0), [Complex::ONE, Complex::new(3.0, -1.0)]);
        let image = [value, Complex::new(2.0, 6.0)];
        let read = [[1.0, 2.0], [-1.0, 0.5]];
        let known = [Complex::new(7.0, -2.0), Complex::new(0.5, -0.5)];
        let found: [_; 6] = monomial_values(Fixed, (value, &vector), true, &read);
        assert_eq!(found, [vector, image, known].concat()[..]);
        let found: [_; 4] = monomial_values(Fixed, (value, &vector), false, &read);
        assert_eq!(found, [vector, known].concat()[..]);
        let found: [_; 2] = monomial_values(Fixed, (value, &vector), false, &[[0.0; 2]; 0]);
        assert_eq!(found, vector);
    }
}
