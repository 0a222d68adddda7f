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
    /// The sum over k of `term`(row k times factor k), for each equation. Factors of zero are
    /// passed over: among derivatives by one unknown, they are those of monomials without it.
    #[inline]
    fn sum<S: Scalar, T: Scalar>(&self, factor: impl Fn(usize) -> S, term: impl Fn(S) -> T) -> E::Vector<T> {
        let (_, equations, count) = self.tables.sizes;
        // One local vector of sums, which stays in registers.
        let mut sums = equations.filled(T::ZERO);
        // From high degrees down: large terms cancel before small ones are added.
        for k in (0..count.get()).rev() {
            let (row, factor) = (&self.rows[k], factor(k));
            if factor != S::ZERO {
                for e in 0..equations.get() {
                    sums[e] += term(factor.scale(row[e]));
                }
            }
        }
        sums
    }

    #[inline]
    fn values<S: Scalar>(&self, monomials: &K::Vector<S>) -> Values<S, E> {
        Values {
            residual: self.sum(|k| monomials[k], |term| term),
            scale: self.sum(|k| monomials[k], |term| term.modulus()),
        }
    }
}

impl<S: Scalar, N: Size, E: Size, K: Size> System<S, N, E> for DenseSystem<'_, N, E, K> {
    #[inline]
    fn evaluate(&self, x: &N::Vector<S>, at: &mut Values<S, E>, derivatives: &mut Matrix<N, E, S>) {
        let (unknowns, _, _) = self.tables.sizes;
        let monomials = self.tables.monomials(x);
        *at = self.values(&monomials);
        let gradients = self.tables.gradients(x, &monomials);
        for j in 0..unknowns.get() {
            derivatives[j] = self.sum(|k| gradients[k][j], |term| term);
        }
    }

    #[inline]
    fn residual(&self, x: &N::Vector<S>, at: &mut Values<S, E>) {
        *at = self.values(&self.tables.monomials(x));
    }
}
