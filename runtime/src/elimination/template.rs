//! Fills and eliminates a block-triangular elimination template from tables.

use crate::elimination::lu::{BlockError, BlockMemory, solve_block_trailing, solve_large_block};
use crate::error::SolveError;
use crate::number::{Over, Real};
use crate::size::{Matrix, Size, Square, Vector, filled_matrix};

/// A table entry: row, column, slot of the coefficient.
pub type Entry = (u16, u16, u16);

/// Writes the coefficients to their places. Entries out of range are ignored; the generator's
/// tables stay in range.
#[inline]
pub fn fill<R: Real + Over<C>, C: Copy, V: Vector<R>>(matrix: &mut [V], entries: &[Entry], coefficients: &[C]) {
    for &(row, column, slot) in entries {
        let row = matrix.get_mut(usize::from(row));
        let place = row.and_then(|row| row.as_mut().get_mut(usize::from(column)));
        if let (Some(place), Some(&value)) = (place, coefficients.get(usize::from(slot))) {
            *place = R::from_real(value);
        }
    }
}

/// The tables of one diagonal block of N rows, which start at row `first` of the template.
///
/// ```text
///                    pivots solved before   pivots first..first+N    basis
/// row first + i   [        coupling       |       diagonal        |  right  ]
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Block<'a> {
    /// The position of the block in the order of elimination.
    pub number: u16,
    /// The first row, which is also the first pivot.
    pub first: u16,
    /// The number of trailing pivots that are read later.
    pub needed: u16,
    /// The square block; rows and columns count from `first`.
    pub diagonal: &'a [Entry],
    /// Entries at pivots solved before; rows count from `first`, columns are absolute.
    pub coupling: &'a [Entry],
}

impl Block<'_> {
    /// Solves for the pivots of a small block: rows `first..first + N` of `right` become its solved
    /// rows.
    ///
    /// # Errors
    /// [`SolveError::Degenerate`] if the block is singular up to rounding, [`SolveError::Overflow`]
    /// if a value is not finite.
    #[inline]
    pub fn eliminate<R: Real + Over<C>, C: Copy, V: Vector<R>, const N: usize>(
        &self,
        right: &mut [V],
        coefficients: &[C],
    ) -> Result<(), SolveError> {
        let open = self.couple(right, coefficients)?;
        let mut matrix = [[R::ZERO; N]; N];
        fill(&mut matrix, self.diagonal, coefficients);
        let solved = solve_block_trailing(&mut matrix, open, usize::from(self.needed));
        solved.map_err(|error| self.solve_error(error))
    }

    /// Like [`Block::eliminate`], for a large block: little code is compiled for each N. The matrix
    /// takes 8 N^2 bytes of the stack.
    ///
    /// # Errors
    /// As [`Block::eliminate`].
    #[inline(never)]
    pub fn eliminate_large<R: Real + Over<C>, C: Copy, V: Vector<R>, const N: usize>(
        &self,
        right: &mut [V],
        coefficients: &[C],
    ) -> Result<(), SolveError> {
        let mut matrix = [[R::ZERO; N]; N];
        let (row_scale, smallest) = (&mut [0.0; N], &mut [0.0; N]);
        let memory = BlockMemory { matrix: matrix.as_flattened_mut(), row_scale, smallest };
        self.eliminate_in(memory, right, coefficients)
    }

    /// Like [`Block::eliminate`], with a size that is known at run time. All of `memory` must be
    /// zero before the call.
    ///
    /// # Errors
    /// As [`Block::eliminate`].
    #[inline]
    pub fn eliminate_in<R: Real + Over<C>, C: Copy, V: Vector<R>>(
        &self,
        memory: BlockMemory<'_, R>,
        right: &mut [V],
        coefficients: &[C],
    ) -> Result<(), SolveError> {
        let open = self.couple(right, coefficients)?;
        let n = memory.row_scale.len();
        for &(row, column, slot) in self.diagonal {
            let place = memory.matrix.get_mut(usize::from(row) * n + usize::from(column));
            if let (Some(place), Some(&value)) = (place, coefficients.get(usize::from(slot))) {
                *place = R::from_real(value);
            }
        }
        let solved = solve_large_block(memory, open, usize::from(self.needed));
        solved.map_err(|error| self.solve_error(error))
    }

    /// Subtracts the contribution of the pivots solved before; returns the rows from the block's
    /// first on.
    #[inline]
    fn couple<'r, R: Real + Over<C>, C: Copy, V: Vector<R>>(
        &self,
        right: &'r mut [V],
        coefficients: &[C],
    ) -> Result<&'r mut [V], SolveError> {
        let Some((solved, open)) = right.split_at_mut_checked(usize::from(self.first)) else {
            return Err(SolveError::TooLarge);
        };
        for &(row, pivot, slot) in self.coupling {
            let (Some(row), Some(pivot)) = (open.get_mut(usize::from(row)), solved.get(usize::from(pivot))) else {
                continue;
            };
            let Some(&factor) = coefficients.get(usize::from(slot)) else { continue };
            for (entry, known) in row.as_mut().iter_mut().zip(pivot.as_ref()) {
                *entry -= known.times(factor);
            }
        }
        Ok(open)
    }

    fn solve_error(&self, error: BlockError) -> SolveError {
        match error {
            BlockError::Singular { .. } => SolveError::Degenerate { block: usize::from(self.number) },
            // The coefficients are finite, so sums or products of them overflowed.
            BlockError::NonFinite | BlockError::Overflow => SolveError::Overflow,
            BlockError::Shape => SolveError::TooLarge,
        }
    }
}

/// The source of a row of the action matrix: the product of the action monomial and a basis
/// monomial.
#[derive(Clone, Copy, Debug)]
pub enum ActionRow {
    /// The product is the basis monomial at this position.
    Unit(u16),
    /// The product is this pivot, whose row is minus its solved row.
    Solved(u16),
}

/// The action matrix of a solved template, a row for each of `rows`. A position out of range leaves
/// a row of zeros; the generator's tables stay in range.
#[inline]
#[must_use]
pub fn action_matrix<R: Real, B: Size>(basis: B, rows: &[ActionRow], right: &[B::Vector<R>]) -> Square<B, R> {
    let mut action = filled_matrix(basis, basis, R::ZERO);
    for (row, source) in action.as_mut().iter_mut().zip(rows) {
        match source {
            ActionRow::Unit(column) => {
                if let Some(entry) = row.as_mut().get_mut(usize::from(*column)) {
                    *entry = R::ONE;
                }
            }
            ActionRow::Solved(pivot) => negate_into(row.as_mut(), right, *pivot, |value| value),
        }
    }
    action
}

/// The pivots as combinations of the basis: minus their solved rows.
#[inline]
#[must_use]
pub fn solved_rows<R: Real, K: Size, B: Size>(
    (count, basis): (K, B),
    pivots: &[u16],
    right: &[B::Vector<R>],
) -> Matrix<K, B, f64> {
    let mut rows = filled_matrix(count, basis, 0.0);
    for (row, pivot) in rows.as_mut().iter_mut().zip(pivots) {
        negate_into(row.as_mut(), right, *pivot, R::real);
    }
    rows
}

#[inline]
fn negate_into<R: Real, S: core::ops::Neg<Output = S>, V: Vector<R>>(
    row: &mut [S],
    right: &[V],
    pivot: u16,
    convert: impl Fn(R) -> S,
) {
    if let Some(solved) = right.get(usize::from(pivot)) {
        for (entry, &value) in row.iter_mut().zip(solved.as_ref()) {
            *entry = -convert(value);
        }
    }
}

/// Refuses data that are not finite, even if no equation reads them, and coefficients that are not
/// finite.
///
/// # Errors
/// [`SolveError::NonFiniteInput`] or [`SolveError::Overflow`].
#[inline]
pub fn check_coefficients(coefficients: &[f64], data: &[&[f64]]) -> Result<(), SolveError> {
    if !data.iter().all(|values| values.iter().all(|value| value.is_finite())) {
        return Err(SolveError::NonFiniteInput);
    }
    match coefficients.iter().all(|c| c.is_finite()) {
        true => Ok(()),
        false => Err(SolveError::Overflow),
    }
}
