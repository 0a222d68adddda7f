//! Evaluates equations that share most of their monomials: a matrix times the vector of monomials.

use crate::number::double_double::{DoubleComplex, DoubleDouble};
use crate::number::{Over, Scalar};
use crate::size::{Matrix, Size};
use crate::solution::system::{Monomials, PreciseSystem, System, Values, precise_coefficient};

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
pub struct DenseSystem<'a, N: Size, E: Size, K: Size, Q> {
    /// N, E and K.
    pub sizes: (N, E, K),
    /// How the monomials are computed.
    pub monomials: Q,
    /// The coefficients.
    pub rows: &'a Matrix<K, E, f64>,
}

/// The coefficients of E equations at the front of a list of C, one row for each of K monomials.
#[inline(always)]
#[must_use]
pub fn rows<const E: usize, const K: usize, const C: usize, T>(coefficients: &[T; C]) -> &[[T; E]; K] {
    const { assert!(E * K <= C, "the list holds the matrix") };
    loop {
        // Always: the list is long enough.
        if let Some(matrix) = coefficients.as_chunks().0.first_chunk() {
            return matrix;
        }
    }
}

/// Like [`rows`], of a list whose length the compiler does not know; `None` if it is too short.
#[inline]
#[must_use]
pub fn rows_of<const E: usize, const K: usize>(coefficients: &[f64]) -> Option<&[[f64; E]; K]> {
    coefficients.as_chunks().0.first_chunk()
}

impl<S: Scalar, N: Size, E: Size, K: Size, Q: Monomials<N, K>> System<S, N, E> for DenseSystem<'_, N, E, K, Q> {
    type Monomials = K::Vector<S>;

    #[inline]
    fn monomials(&self, x: &N::Vector<S>) -> K::Vector<S> {
        self.monomials.products(x)
    }

    #[inline]
    fn residual(&self, monomials: &K::Vector<S>, at: &mut Values<S, E>) {
        let (_, equations, count) = self.sizes;
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
        let (_, equations, count) = self.sizes;
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
        let (unknowns, equations, _) = self.sizes;
        for j in 0..unknowns.get() {
            columns[j] = equations.filled(S::ZERO);
        }
        self.monomials.for_each_gradient(x, monomials, |j, terms| {
            let mut column = columns[j].clone();
            for &(k, factor) in terms {
                let row = &self.rows[usize::from(k)];
                for e in 0..equations.get() {
                    column[e] += factor.scale(row[e]);
                }
            }
            columns[j] = column;
        });
    }
}

impl<N: Size, E: Size, K: Size, Q: Monomials<N, K>> PreciseSystem<N, E> for DenseSystem<'_, N, E, K, Q> {
    fn precise_values(&self, x: &N::Vector<DoubleComplex>, coefficients: &[DoubleDouble]) -> E::Vector<DoubleComplex> {
        let (_, equations, count) = self.sizes;
        let monomials = self.monomials.products(x);
        let mut values = equations.filled(DoubleComplex::ZERO);
        for k in 0..count.get() {
            for e in 0..equations.get() {
                let coefficient = precise_coefficient(coefficients, k * equations.get() + e);
                values[e] += monomials[k].times(coefficient);
            }
        }
        values
    }
}
