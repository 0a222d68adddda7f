//! Eigenvectors for given eigenvalues, by inverse iteration on the Hessenberg form.

use crate::number::{Over, Real, Scalar, float};
use crate::size::{Size, Square, filled_matrix};
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
pub(crate) struct ShiftedLu<S: Clone, Z: Size> {
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
        S: Over<R>,
    {
        self.smallest = form.smallest_pivot();
        let (h, n, smallest) = (&form.matrix, self.size.get(), self.smallest);
        for i in 0..n {
            for j in i.saturating_sub(1)..n {
                self.upper[i][j] = S::from_real(h[i][j]);
            }
            self.upper[i][i] -= value;
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
            let mut sum = x[i];
            for j in i + 1..n {
                sum -= self.upper[i][j] * x[j];
            }
            x[i] = sum * self.inverse_pivot[i];
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
    pub fn eigenvector<S: Over<R>>(&self, value: S) -> Z::Vector<S> {
        let n = self.size.get();
        let mut lu = ShiftedLu::new(self.size);
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
