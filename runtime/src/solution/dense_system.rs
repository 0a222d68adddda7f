//! Evaluates equations that share most of their monomials: a matrix times the vector of monomials.

use crate::number::Scalar;
use crate::size::{Matrix, Size, filled_matrix};
use crate::solution::system::{System, Tables, Values};

/// A system with its coefficients as a matrix, one row for each of K monomials, one column for each
/// of E equations:
///
/// ```text
///                 f_0  f_1  ..  f_E-1
///   monomial 0  [  .    .          .  ]     f  = sum over k of row k times monomial k
///   ..          [                     ]     df = sum over k of row k times d monomial k
///   monomial K-1[  .    .          .  ]
/// ```
///
/// All equations take the same steps, so that a compiler computes several at a time, and no sum
/// waits for the one before it. A term that an equation does not have is zero.
pub struct DenseSystem<'a, N: Size, E: Size, K: Size> {
    tables: Tables<'a, N, E, K>,
    rows: &'a Matrix<K, E, f64>,
}

impl<'a, N: Size, E: Size, K: Size> Tables<'a, N, E, K> {
    /// The coefficients of all equations, one row for each monomial.
    #[inline]
    #[must_use]
    pub fn rows(&self, coefficients: &[f64]) -> Matrix<K, E, f64> {
        let (_, equations, monomials) = self.sizes;
        let mut rows = filled_matrix(monomials, equations, 0.0);
        for (equation, terms) in self.equations().enumerate() {
            for term in terms {
                rows[usize::from(term.monomial)][equation] += coefficients[usize::from(term.coefficient)];
            }
        }
        rows
    }

    /// The system with these coefficients, which [`Tables::rows`] has arranged.
    #[inline]
    #[must_use]
    pub const fn with_rows(&self, rows: &'a Matrix<K, E, f64>) -> DenseSystem<'a, N, E, K> {
        DenseSystem { tables: *self, rows }
    }
}

impl<N: Size, E: Size, K: Size> DenseSystem<'_, N, E, K> {
    #[inline]
    fn evaluate_at<S: Scalar>(&self, monomials: &K::Vector<S>, at: &mut Values<S, E>) {
        let (_, equations, count) = self.tables.sizes;
        // Sums in locals, which stay in registers.
        let (mut value, mut size) = (equations.filled(S::ZERO), equations.filled(0.0));
        for k in 0..count.get() {
            let (row, monomial) = (&self.rows[k], monomials[k]);
            for e in 0..equations.get() {
                let term = monomial.scale(row[e]);
                value[e] += term;
                size[e] += term.modulus();
            }
        }
        (at.residual, at.scale) = (value, size);
    }
}

impl<S: Scalar, N: Size, E: Size, K: Size> System<S, N, E> for DenseSystem<'_, N, E, K> {
    #[inline]
    fn evaluate(&self, x: &N::Vector<S>, at: &mut Values<S, E>, derivatives: &mut Matrix<N, E, S>) {
        let (unknowns, equations, count) = self.tables.sizes;
        let values = self.tables.monomials(x);
        self.evaluate_at(&values, at);
        let gradients = self.tables.gradients(x, &values);
        for j in 0..unknowns.get() {
            let mut sum = equations.filled(S::ZERO);
            for k in 1..count.get() {
                let (row, derivative) = (&self.rows[k], gradients[k][j]);
                // Half of the monomials, more or less, do not hold the unknown.
                if derivative != S::ZERO {
                    for e in 0..equations.get() {
                        sum[e] += derivative.scale(row[e]);
                    }
                }
            }
            derivatives[j] = sum;
        }
    }

    #[inline]
    fn residual(&self, x: &N::Vector<S>, at: &mut Values<S, E>) {
        self.evaluate_at(&self.tables.monomials(x), at);
    }
}
