//! Filling and eliminating a block-triangular elimination template from tables.

use crate::error::SolveError;
use crate::lu::{solve_block_trailing, solve_large_block};
use crate::scalar::{Over, Real, Scalar};

/// A table entry: row, column, slot of the coefficient.
pub type Entry = (u16, u16, u16);

/// Writes the coefficients to their places. Entries out of range are ignored; the generator makes none.
#[inline]
pub fn fill<R: Real + Over<C>, C: Copy, const M: usize>(matrix: &mut [[R; M]], entries: &[Entry], coefficients: &[C]) {
    for &(row, column, slot) in entries {
        let place = matrix.get_mut(usize::from(row)).and_then(|row| row.get_mut(usize::from(column)));
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
pub struct Block {
    /// The first row, which is also the first pivot.
    pub first: u16,
    /// How many of the last pivots are read later.
    pub needed: u16,
    /// The square block; rows and columns count from `first`.
    pub diagonal: &'static [Entry],
    /// Entries at pivots solved before; rows count from `first`, columns are absolute.
    pub coupling: &'static [Entry],
}

/// Solves for the pivots of one block: rows `first..first + N` of `right` become its solved rows.
///
/// # Errors
/// [`SolveError::Degenerate`], as [`crate::solve_block`] or where a value overflows.
#[inline]
pub fn eliminate_block<R: Real + Over<C>, C: Copy, const N: usize, const M: usize>(
    block: &Block,
    right: &mut [[R; M]],
    coefficients: &[C],
) -> Result<(), SolveError> {
    let open = couple(block, right, coefficients)?;
    let mut matrix = [[R::ZERO; N]; N];
    fill(&mut matrix, block.diagonal, coefficients);
    solve_block_trailing(&mut matrix, open, usize::from(block.needed)).map_err(overflow)
}

/// Like [`eliminate_block`], for a large block: code of which little is compiled for each N. Its matrix is on the stack while it runs,
/// 8 N^2 bytes.
///
/// # Errors
/// As [`eliminate_block`].
#[inline(never)]
pub fn eliminate_large_block<R: Real + Over<C>, C: Copy, const N: usize, const M: usize>(
    block: &Block,
    right: &mut [[R; M]],
    coefficients: &[C],
) -> Result<(), SolveError> {
    let open = couple(block, right, coefficients)?;
    let mut matrix = [[R::ZERO; N]; N];
    fill(&mut matrix, block.diagonal, coefficients);
    let (mut row_scale, mut smallest) = ([0.0; N], [0.0; N]);
    let needed = usize::from(block.needed);
    solve_large_block(matrix.as_flattened_mut(), &mut row_scale, &mut smallest, open, needed).map_err(overflow)
}

/// Subtracts what the pivots solved before contribute; returns the rows from the block's first on.
#[inline]
fn couple<'a, R: Real + Over<C>, C: Copy, const M: usize>(
    block: &Block,
    right: &'a mut [[R; M]],
    coefficients: &[C],
) -> Result<&'a mut [[R; M]], SolveError> {
    let Some((solved, open)) = right.split_at_mut_checked(usize::from(block.first)) else {
        return Err(SolveError::Degenerate { column: 0 });
    };
    for &(row, pivot, slot) in block.coupling {
        let (Some(row), Some(pivot)) = (open.get_mut(usize::from(row)), solved.get(usize::from(pivot))) else {
            continue;
        };
        let Some(&factor) = coefficients.get(usize::from(slot)) else { continue };
        for j in 0..M {
            row[j] -= pivot[j].times(factor);
        }
    }
    Ok(open)
}

/// The coefficients are finite: where something else is not, sums and products of them overflowed.
fn overflow(error: SolveError) -> SolveError {
    match error {
        SolveError::NonFiniteInput => SolveError::Degenerate { column: 0 },
        error => error,
    }
}

/// Where a row of the action matrix comes from.
#[derive(Clone, Copy, Debug)]
pub enum ActionRow {
    /// The product is the basis monomial at this position.
    Unit(u16),
    /// It is this pivot: minus its solved row.
    Solved(u16),
}

/// The action matrix of a solved template, B rows. What is out of range leaves a row of zeros; the generator's tables fit.
#[inline]
#[must_use]
pub fn action_matrix<R: Real, const B: usize>(rows: &[ActionRow; B], right: &[[R; B]]) -> [[R; B]; B] {
    let mut action = [[R::ZERO; B]; B];
    for (row, source) in action.iter_mut().zip(rows) {
        match source {
            ActionRow::Unit(column) => {
                if let Some(entry) = row.get_mut(usize::from(*column)) {
                    *entry = R::ONE;
                }
            }
            ActionRow::Solved(pivot) => negate_into(row, right, *pivot, |value| value),
        }
    }
    action
}

/// Minus the solved rows of these pivots.
#[inline]
#[must_use]
pub fn solved_rows<R: Real, const B: usize, const K: usize>(pivots: &[u16; K], right: &[[R; B]]) -> [[f64; B]; K] {
    let mut rows = [[0.0; B]; K];
    for (row, pivot) in rows.iter_mut().zip(pivots) {
        negate_into(row, right, *pivot, R::real);
    }
    rows
}

#[inline]
fn negate_into<R: Real, S: Scalar, const B: usize>(
    row: &mut [S; B],
    right: &[[R; B]],
    pivot: u16,
    convert: impl Fn(R) -> S,
) {
    if let Some(solved) = right.get(usize::from(pivot)) {
        for j in 0..B {
            row[j] = -convert(solved[j]);
        }
    }
}

/// Refuses data that are not finite, also where no equation reads them, and coefficients that are not: an overflow or a division by
/// zero shows that the data are degenerate.
///
/// # Errors
/// [`SolveError::NonFiniteInput`] or [`SolveError::Degenerate`].
#[inline]
pub fn check_coefficients(coefficients: &[f64], data: &[&[f64]]) -> Result<(), SolveError> {
    if !data.iter().all(|values| values.iter().all(|value| value.is_finite())) {
        return Err(SolveError::NonFiniteInput);
    }
    match coefficients.iter().all(|c| c.is_finite()) {
        true => Ok(()),
        false => Err(SolveError::Degenerate { column: 0 }),
    }
}
