//! Which columns vanish at solutions where unknowns are 0.

use crate::algebra::Monomial;
use crate::template::shift_matrix::ShiftMatrix;

/// The columns of a matrix at the solutions where some unknowns are 0.
///
/// A template is determined up to a common monomial, so what a monomial has beyond all others of
/// the matrix decides.
pub(super) struct Vanishing<'a> {
    matrix: &'a ShiftMatrix,
    /// The greatest common divisor of all columns.
    least: Monomial,
    zero_sets: &'a [Vec<usize>],
}

impl<'a> Vanishing<'a> {
    /// `zero_sets` are the sets of unknowns that are 0 together at a solution.
    pub(super) fn new(matrix: &'a ShiftMatrix, zero_sets: &'a [Vec<usize>]) -> Self {
        let least = match zero_sets {
            [] => Monomial::ONE,
            _ => matrix.monomials.iter().copied().reduce(|a, b| a.gcd(&b)).unwrap_or(Monomial::ONE),
        };
        Self { matrix, least, zero_sets }
    }

    /// The sets of unknowns that are 0 at some solution, and the empty set for all other solutions.
    pub(super) fn sets(&self) -> impl Iterator<Item = &'a [usize]> + use<'a> {
        std::iter::once(&[][..]).chain(self.zero_sets.iter().map(Vec::as_slice))
    }

    /// Whether the monomial of a column is 0 where these unknowns are.
    pub(super) fn vanishes(&self, column: usize, zeros: &[usize]) -> bool {
        let monomial = &self.matrix.monomials[column];
        zeros.iter().any(|&unknown| monomial.exponent(unknown) > self.least.exponent(unknown))
    }

    /// Whether there is a solution at which all these columns are 0.
    pub(super) fn somewhere(&self, columns: &[usize]) -> bool {
        self.zero_sets.iter().any(|zeros| columns.iter().all(|&column| self.vanishes(column, zeros)))
    }
}
