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

impl<S: Scalar, N: Size, E: Size, K: Size> System<S, N, E> for DenseSystem<'_, N, E, K> {
    type Monomials = K::Vector<S>;

    #[inline]
    fn monomials(&self, x: &N::Vector<S>) -> K::Vector<S> {
        self.tables.products(x)
    }

    #[inline]
    fn residual(&self, monomials: &K::Vector<S>, at: &mut Values<S, E>) {
        let (_, equations, count) = self.tables.sizes;
        // Local vectors of sums, which stay in registers.
        let (mut values, mut scales) = (equations.filled(S::ZERO), equations.filled(0.0));
        // From high degrees down: large terms cancel before small ones are added.
        for k in (0..count.get()).rev() {
            let (row, factor) = (&self.rows[k], monomials[k]);
            for e in 0..equations.get() {
                let term = factor.scale(row[e]);
                values[e] += term;
                scales[e] += term.modulus();
            }
        }
        (at.residual, at.scale) = (values, scales);
    }

    #[inline]
    fn values(&self, monomials: &K::Vector<S>, residual: &mut E::Vector<S>) {
        let (_, equations, count) = self.tables.sizes;
        let mut values = equations.filled(S::ZERO);
        for k in (0..count.get()).rev() {
            let (row, factor) = (&self.rows[k], monomials[k]);
            for e in 0..equations.get() {
                values[e] += factor.scale(row[e]);
            }
        }
        *residual = values;
    }

    #[inline]
    fn derivatives(&self, x: &N::Vector<S>, monomials: &K::Vector<S>, columns: &mut Matrix<N, E, S>) {
        let (unknowns, equations, count) = self.tables.sizes;
        let gradients = self.tables.gradients(x, monomials);
        for j in 0..unknowns.get() {
            let mut column = equations.filled(S::ZERO);
            for k in (0..count.get()).rev() {
                let (row, factor) = (&self.rows[k], gradients[k][j]);
                // Monomials without the unknown are passed over.
                if factor != S::ZERO {
                    for e in 0..equations.get() {
                        column[e] += factor.scale(row[e]);
                    }
                }
            }
            columns[j] = column;
        }
    }
}
