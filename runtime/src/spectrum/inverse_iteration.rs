//! Eigenvectors for given eigenvalues, by inverse iteration on the Hessenberg form.

use crate::number::sums::sum_of;
use crate::number::{Over, Real, Scalar, float};
use crate::size::{Element, Size, Square, filled_matrix};
use crate::spectrum::hessenberg::Hessenberg;

/// Solves with each factorisation: the first solve finds the direction, the second improves it.
/// More solves are needed only if the start was nearly orthogonal to the left eigenvector.
const LEAST_SOLVES: usize = 2;
const MOST_SOLVES: usize = 5;
/// Larger entries are scaled down during back substitution, so that repeated tiny pivots do not
/// overflow.
const LARGE: f64 = 1e120;

/// P (H - value I) = L U with interchanges of neighbouring rows.
///
/// ```text
///       [ u u u u ]     multiplier[i]: the factor of row i when it cleared the entry below it
///   U = [   u u u ]     swapped[i]: rows i and i+1 changed places first
///       [     u u ]     inverse_pivot[i] = 1 / U[i][i]; pivots below rounding are replaced by it
///       [       u ]
/// ```
pub(crate) struct ShiftedLu<S: Element, Z: Size> {
    size: Z,
    upper: Square<Z, S>,
    inverse_pivot: Z::Vector<S>,
    multiplier: Z::Vector<S>,
    swapped: Z::Vector<bool>,
    /// The replacement for smaller pivots.
    smallest: f64,
}

impl<S: Scalar, Z: Size> ShiftedLu<S, Z> {
    /// Memory for a factorisation. A large one takes its place on the stack once.
    #[inline]
    pub(crate) fn new(size: Z) -> Self {
        ShiftedLu {
            size,
            upper: filled_matrix(size, size, S::ZERO),
            inverse_pivot: size.filled(S::ONE),
            multiplier: size.filled(S::ZERO),
            swapped: size.filled(false),
            smallest: 0.0,
        }
    }

    /// Factors H - value I. H has the order for which this memory was made.
    #[inline]
    pub(crate) fn factor<R: Real>(&mut self, form: &Hessenberg<Z, R>, value: S)
    where
        S: Scalar + Over<R>,
    {
        self.smallest = form.smallest_pivot();
        let (h, n, smallest) = (&form.matrix, self.size.get(), self.smallest);
        for i in 0..n {
            for j in i.saturating_sub(1)..n {
                self.upper[i][j] = S::from_real(h[i][j]);
            }
            self.upper[i][i] -= value;
            self.swapped[i] = false;
        }
        for i in 0..n {
            if i + 1 < n {
                let (above, below) = self.upper.as_mut().split_at_mut(i + 1);
                let (row, next) = (&mut above[i], &mut below[0]);
                if next[i].magnitude() > row[i].magnitude() {
                    core::mem::swap(row, next);
                    self.swapped[i] = true;
                }
                self.inverse_pivot[i] = guarded_reciprocal(row[i], smallest);
                let multiplier = next[i] * self.inverse_pivot[i];
                self.multiplier[i] = multiplier;
                for j in i + 1..n {
                    let entry = row[j];
                    next[j] -= multiplier * entry;
                }
            } else {
                self.inverse_pivot[i] = guarded_reciprocal(self.upper[i][i], smallest);
            }
        }
    }

    /// x := L^-1 P x.
    #[inline]
    pub(crate) fn forward(&self, x: &mut Z::Vector<S>) {
        for i in 0..self.size.get().saturating_sub(1) {
            if self.swapped[i] {
                x.as_mut().swap(i, i + 1);
            }
            let known = x[i];
            x[i + 1] -= self.multiplier[i] * known;
        }
    }

    /// x := U^-1 x, scaled to length 1. Returns the factor by which the length had grown.
    #[inline]
    pub(crate) fn backward(&self, x: &mut Z::Vector<S>) -> f64 {
        let n = self.size.get();
        let mut factor = 1.0;
        for i in (0..n).rev() {
            let (row, first) = (&self.upper[i], i + 1);
            let known = sum_of(n - first, S::ZERO, |j| row[first + j] * x[first + j]);
            x[i] = (x[i] - known) * self.inverse_pivot[i];
            let size = x[i].magnitude();
            if size > LARGE {
                let inverse = 1.0 / size;
                factor *= inverse;
                for entry in x.as_mut() {
                    *entry = entry.scale(inverse);
                }
            }
        }
        normalize(x.as_mut()) / factor
    }
}

/// 1/x, or 1/`smallest` if |x| is below that.
#[inline]
fn guarded_reciprocal<S: Scalar>(x: S, smallest: f64) -> S {
    if x.magnitude() > smallest { x.reciprocal() } else { S::from_f64(1.0 / smallest) }
}

/// Scales x to length 1. Returns the length before.
#[inline]
pub(crate) fn normalize<S: Scalar>(x: &mut [S]) -> f64 {
    let largest = x.iter().map(|entry| entry.magnitude()).fold(0.0, f64::max);
    if !(largest > 0.0) {
        return 0.0;
    }
    let inverse = 1.0 / largest;
    let sum: f64 = x.iter().map(|entry| entry.scale(inverse).modulus_squared()).sum();
    let length = float::sqrt(sum);
    let inverse_length = inverse / length;
    for entry in x.iter_mut() {
        *entry = entry.scale(inverse_length);
    }
    length * largest
}

impl<Z: Size, R: Real> Hessenberg<Z, R> {
    /// The replacement for smaller pivots of H - value I: the rounding level of H.
    #[inline]
    fn smallest_pivot(&self) -> f64 {
        let norm = self.norm;
        if norm > 0.0 { R::EPSILON * norm } else { R::EPSILON }
    }

    /// A unit vector v with A v = value * v up to rounding, for an eigenvalue of A. It is real for
    /// a real eigenvalue.
    ///
    /// Wilkinson's inverse iteration, O(N^2) per solve. The residual on the balanced H is at most a
    /// small multiple of N epsilon |H|. Vectors of equal or nearly equal eigenvalues may be nearly
    /// parallel. The result is not finite only if `value` is not.
    #[must_use]
    pub fn eigenvector<S: Scalar + Over<R>>(&self, value: S) -> Z::Vector<S> {
        self.eigenvector_in(&mut ShiftedLu::new(self.size), value)
    }

    /// Like [`Hessenberg::eigenvector`], in memory that serves vector after vector.
    pub(crate) fn eigenvector_in<S: Scalar + Over<R>>(&self, lu: &mut ShiftedLu<S, Z>, value: S) -> Z::Vector<S> {
        let n = self.size.get();
        lu.factor(self, value.scale(1.0 / self.unit));
        // A solve that multiplies the length by this leaves a residual of 10 N epsilon |H|.
        let enough = 1.0 / (10.0 * n as f64 * lu.smallest);

        let mut x = self.size.filled(S::ZERO);
        x.as_mut()[..n].fill(S::ONE);
        // The first right-hand side is L times a vector of ones, so that its forward half is not
        // needed.
        normalize(x.as_mut());
        let mut best = (x.clone(), 0.0);
        for solve in 1..=MOST_SOLVES {
            if solve > 1 {
                lu.forward(&mut x);
            }
            let growth = lu.backward(&mut x);
            // Near a defective eigenvalue a second solve undoes the first, because the left and
            // right eigenvectors are orthogonal (Ipsen 1997, section 5). So a good vector is
            // replaced only by a good one.
            if growth > best.1 || growth >= enough {
                best = (x.clone(), growth);
            }
            if solve >= LEAST_SOLVES {
                if best.1 >= enough {
                    break;
                }
                // The start was nearly orthogonal to the left eigenvector. A step along an axis
                // leaves it.
                x[(n - 1 + solve) % n.max(1)] += S::ONE;
            }
        }
        let (mut x, _) = best;
        self.transform_back(&mut x);
        normalize(x.as_mut());
        x
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::size::Fixed;
    use num_complex::Complex;

    #[test]
    fn lengths_neither_overflow_nor_vanish() {
        for unit in [1.0, 1e200, 1e-200, 5e300] {
            let mut x = [3.0 * unit, 0.0, -4.0 * unit];
            assert!((normalize(&mut x) / unit - 5.0).abs() < 1e-14);
            assert!((x[0] - 0.6).abs() < 1e-15 && x[1] == 0.0 && (x[2] + 0.8).abs() < 1e-15, "{x:?}");
        }
        let mut z = [Complex { re: 0.0, im: 3.0 }, Complex { re: 4.0, im: 0.0 }];
        assert!((normalize(&mut z) - 5.0).abs() < 1e-14 && (z[0].im - 0.6).abs() < 1e-15, "{z:?}");
        let mut zero = [0.0; 3];
        assert_eq!((normalize(&mut zero), zero), (0.0, [0.0; 3]));
    }

    /// A solve of (H - value I) x = b, in two halves: the direction, and how much longer x is than
    /// b.
    #[test]
    fn solves_give_direction_and_growth() {
        let h = [[2.0, -1.0, 0.5, 3.0], [1.5, 0.25, 1.0, -2.0], [0.0, -3.0, 1.0, 0.5], [0.0, 0.0, 4.0, -1.0]];
        let mut form = Hessenberg::<Fixed<4>>::zero(Fixed);
        (form.matrix, form.norm) = (h, 7.5);
        for value in [Complex { re: 0.3, im: 1.7 }, Complex { re: 2.0, im: 0.0 }] {
            let mut lu = ShiftedLu::<Complex<f64>, _>::new(Fixed::<4>);
            lu.factor(&form, value);
            let b = [1.0, -2.0, 0.5, 3.0].map(|re| Complex { re, im: 1.0 - re });
            let mut x = b;
            lu.forward(&mut x);
            let growth = lu.backward(&mut x);
            for i in 0..4 {
                let sum = (0..4).fold(-value * x[i], |sum, j| sum + x[j] * h[i][j]);
                assert!((sum * growth - b[i]).norm() < 1e-13, "row {i}: {} is not {}", sum * growth, b[i]);
            }
        }
    }

    /// With N pivots at rounding level a solve grows by that level to the power -N. Up to the range
    /// of `f64` it is told, beyond it is infinite; the direction is right in any case.
    #[test]
    fn repeated_tiny_pivots_do_not_overflow() {
        fn growth<const N: usize>() -> f64 {
            let mut form = Hessenberg::<Fixed<N>>::zero(Fixed);
            (1..N).for_each(|i| form.matrix[i - 1][i] = 1.0);
            form.norm = 1.0;
            let mut lu = ShiftedLu::new(Fixed::<N>);
            lu.factor(&form, 0.0);
            let mut x = [0.0; N];
            x[N - 1] = 1.0;
            let growth = lu.backward(&mut x);
            assert!((x[0].abs() - 1.0).abs() < 1e-15 && x[1..].iter().all(|x| x.abs() < 1e-15), "{x:?}");
            growth
        }
        let per_pivot = 1.0 / f64::EPSILON;
        assert_eq!([growth::<4>(), growth::<9>(), growth::<17>()], [4, 9, 17].map(|n| per_pivot.powi(n)));
        assert_eq!(growth::<24>(), f64::INFINITY);
    }

    /// The level of rounding is that of the norm, whatever the units.
    #[test]
    fn eigenvectors_do_not_depend_on_units() {
        let h = [[2.0, -1.0, 0.5], [1.5, 0.25, 1.0], [1.0, -3.0, 1.0]];
        let expected = Hessenberg::reduce(&h).unwrap();
        let values = expected.eigenvalues().unwrap();
        for exponent in [-150, -100, 100, 150] {
            let unit = 2.0_f64.powi(exponent);
            let form = Hessenberg::reduce(&h.map(|row| row.map(|x| x * unit))).unwrap();
            assert_eq!(form.unit, 1.0);
            for value in values {
                assert_eq!(form.eigenvector(value * unit), expected.eigenvector(value));
            }
        }
        let of_zero = Hessenberg::reduce(&[[0.0; 2]; 2]).unwrap().eigenvector(0.0);
        assert!((of_zero[0].hypot(of_zero[1]) - 1.0).abs() < 1e-15, "{of_zero:?}");
    }

    /// 1 + d solves (x - 1)^2 = 0 up to the rounding d^2 = 1e-16. The second solve leaves a
    /// residual of d / 2, so the vector of the first one stays.
    #[test]
    fn of_a_defective_eigenvalue_the_good_vector_stays() {
        for d in [1e-8, -1e-8] {
            let [x, y] = Hessenberg::reduce(&[[1.0, 1.0], [0.0, 1.0]]).unwrap().eigenvector(1.0 + d);
            assert!((y - d * x).hypot(d * y) < 1e-14, "{x} {y}");
        }
    }

    /// A value that is off by e multiplies the other directions by about e.
    #[test]
    fn inaccurate_values_lead_to_the_nearest_eigenvector() {
        let form = Hessenberg::reduce(&[[2.0, 1.0, 0.5], [1.0, -1.0, 0.25], [0.5, 3.0, 7.0]]).unwrap();
        for value in form.eigenvalues().unwrap().map(|value| value.re) {
            let expected = form.eigenvector(value);
            for e in [1e-6, -1e-6] {
                let found = form.eigenvector(value + e);
                let dot: f64 = found.iter().zip(expected).map(|(x, y)| x * y).sum();
                assert!(dot.abs() > 1.0 - 1e-9, "{value}: {found:?} is not {expected:?}");
            }
        }
    }
}
