//! Fills and eliminates a block-triangular elimination template from tables.

use crate::elimination::lu::{BlockError, BlockMemory, Eliminated, all_finite, solve_large_block};
use crate::error::SolveError;
#[cfg(feature = "alloc")]
use crate::memory::Memory;
use crate::number::{Arithmetic, Over, Real};
use crate::size::{Element, Matrix, Size, Square, Vector, filled_matrix};

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

/// Like [`fill`](crate::emitted::fill), for few entries: a statement for each of them. `c` is the
/// list of coefficients.
#[doc(hidden)]
#[macro_export]
macro_rules! fill_entries {
    ($matrix:ident, $c:ident, [$(($row:literal, $column:literal, $slot:literal)),* $(,)?]) => {
        $($matrix[$row][$column] = $crate::emitted::Over::from_real($c[$slot]);)*
    };
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
        let mut matrix = [[R::ZERO; N]; N];
        fill(&mut matrix, self.diagonal, coefficients);
        self.eliminate_filled(&mut matrix, right, coefficients)
    }

    /// Like [`Block::eliminate`], with a diagonal block that is filled already.
    ///
    /// # Errors
    /// As [`Block::eliminate`].
    #[inline(always)]
    pub fn eliminate_filled<R: Eliminated + Over<C>, C: Copy, V: Vector<R>, const N: usize>(
        &self,
        matrix: &mut [[R; N]; N],
        right: &mut [V],
        coefficients: &[C],
    ) -> Result<(), SolveError> {
        let open = self.couple(right, coefficients)?;
        let solved = R::solve_block(matrix, open, usize::from(self.needed));
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

    /// Like [`Block::eliminate`], for a large block of `size` rows, with its matrix on the heap.
    ///
    /// # Errors
    /// As [`Block::eliminate`].
    #[cfg(feature = "alloc")]
    #[inline(never)]
    pub fn eliminate_on_heap<R: Real + Over<C>, C: Copy, V: Vector<R>>(
        &self,
        size: usize,
        right: &mut [V],
        coefficients: &[C],
        memory: &Memory,
    ) -> Result<(), SolveError> {
        let mut matrix = memory.filled(size * size, R::ZERO);
        let (mut row_scale, mut smallest) = (memory.filled(size, 0.0), memory.filled(size, 0.0));
        let memory =
            BlockMemory { matrix: matrix.as_mut(), row_scale: row_scale.as_mut(), smallest: smallest.as_mut() };
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
    #[inline(always)]
    fn couple<'r, R: Over<C>, C: Copy, V: Vector<R>>(
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
#[inline(always)]
#[must_use]
pub fn action_matrix<R: Real, B: Size>(basis: B, rows: &[ActionRow], right: &[B::Vector<R>]) -> Square<B, R> {
    action_matrix_from(basis, rows, right, R::ZERO)
}

/// Like [`action_matrix`], for all kinds of numbers. `zero` is 0.
#[inline(always)]
pub(crate) fn action_matrix_from<R: Arithmetic, B: Size>(
    basis: B,
    rows: &[ActionRow],
    right: &[B::Vector<R>],
    zero: R,
) -> Square<B, R> {
    let mut action = filled_matrix(basis, basis, zero);
    for (row, source) in action.as_mut().iter_mut().zip(rows) {
        match source {
            ActionRow::Unit(column) => {
                if let Some(entry) = row.as_mut().get_mut(usize::from(*column)) {
                    *entry = zero.constant(1.0);
                }
            }
            ActionRow::Solved(pivot) => negate_into(row.as_mut(), right, *pivot, |value| value),
        }
    }
    action
}

/// The pivots as combinations of the basis: minus their solved rows.
#[inline(always)]
#[must_use]
pub fn solved_rows<R: Real, K: Size, B: Size>(
    sizes: (K, B),
    pivots: &[u16],
    right: &[B::Vector<R>],
) -> Matrix<K, B, f64> {
    solved_rows_from(sizes, pivots, right, (0.0, R::real))
}

/// Like [`solved_rows`], for all kinds of numbers: a zero, and what is made of each number.
#[inline(always)]
pub(crate) fn solved_rows_from<R: Element + Copy, T: Arithmetic, K: Size, B: Size>(
    (count, basis): (K, B),
    pivots: &[u16],
    right: &[B::Vector<R>],
    (zero, convert): (T, impl Fn(R) -> T),
) -> Matrix<K, B, T> {
    let mut rows = filled_matrix(count, basis, zero);
    for (row, pivot) in rows.as_mut().iter_mut().zip(pivots) {
        negate_into(row.as_mut(), right, *pivot, &convert);
    }
    rows
}

#[inline(always)]
fn negate_into<R: Copy, S: core::ops::Neg<Output = S>, V: Vector<R>>(
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
    match (all_finite(data), all_finite(&[coefficients])) {
        (true, true) => Ok(()),
        (true, false) => Err(SolveError::Overflow),
        (false, _) => Err(SolveError::NonFiniteInput),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Scalar;
    use crate::number::double_double::DoubleDouble;
    use crate::size::Fixed;

    /// Pivots x0, x1 | x2, x3 and basis b:
    ///
    /// ```text
    ///   2 x0 + x1             = b0            3 x2 + x3 - 4 x0      = 5 b1
    ///     x0 - x1             = b1              x2        - 6 x1    = b0
    /// ```
    const COEFFICIENTS: [f64; 7] = [1.0, 2.0, -1.0, 3.0, -4.0, -6.0, 5.0];
    const FIRST: Block<'static> = Block {
        number: 0,
        first: 0,
        needed: 2,
        diagonal: &[(0, 0, 1), (0, 1, 0), (1, 0, 0), (1, 1, 2)],
        coupling: &[],
    };
    const SECOND: Block<'static> = Block {
        number: 1,
        first: 2,
        needed: 2,
        diagonal: &[(0, 0, 3), (0, 1, 0), (1, 0, 0)],
        coupling: &[(0, 0, 4), (1, 1, 5)],
    };
    const RIGHT: [Entry; 4] = [(0, 0, 0), (1, 1, 0), (2, 1, 6), (3, 0, 0)];
    /// The solution: x0 = (b0 + b1) / 3, x1 = (b0 - 2 b1) / 3, x2 = b0 + 6 x1, x3 = 5 b1 + 4 x0 - 3
    /// x2.
    const SOLUTION: [[f64; 2]; 4] =
        [[1.0 / 3.0, 1.0 / 3.0], [1.0 / 3.0, -2.0 / 3.0], [3.0, -4.0], [-23.0 / 3.0, 55.0 / 3.0]];

    /// Solves a block one way or another.
    type Eliminate<R> = fn(&Block<'_>, &mut [[R; 2]], &[f64]) -> Result<(), SolveError>;

    /// The three ways for a block of two rows.
    fn ways<R: Real>() -> [Eliminate<R>; 3] {
        [
            |block, right, coefficients| block.eliminate::<R, f64, _, 2>(right, coefficients),
            |block, right, coefficients| block.eliminate_large::<R, f64, _, 2>(right, coefficients),
            |block, right, coefficients| {
                let (matrix, row_scale, smallest) = (&mut [R::ZERO; 4], &mut [0.0; 2], &mut [0.0; 2]);
                let memory = BlockMemory { matrix, row_scale, smallest };
                block.eliminate_in::<R, f64, _>(memory, right, coefficients)
            },
        ]
    }

    fn solve<R: Real>(eliminate: Eliminate<R>, coefficients: &[f64]) -> Result<[[R; 2]; 4], SolveError> {
        let mut right = [[R::ZERO; 2]; 4];
        fill::<R, f64, _>(&mut right, &RIGHT, coefficients);
        eliminate(&FIRST, &mut right, coefficients)?;
        eliminate(&SECOND, &mut right, coefficients)?;
        Ok(right)
    }

    #[test]
    fn blocks_are_solved_one_after_another() {
        for eliminate in ways::<f64>() {
            let right = solve(eliminate, &COEFFICIENTS).unwrap();
            let errors = right.iter().flatten().zip(SOLUTION.iter().flatten()).map(|(x, y)| (x - y).abs());
            assert!(errors.fold(0.0, f64::max) < 1e-14, "{right:?}");
        }
        for eliminate in ways::<DoubleDouble>() {
            let right = solve(eliminate, &COEFFICIENTS).unwrap();
            assert!((right[3][1].times(DoubleDouble::from_f64(3.0)) - DoubleDouble::from_f64(55.0)).modulus() < 1e-29);
        }
    }

    #[test]
    fn errors_name_the_block_and_what_happened() {
        let with = |slot: usize, value: f64| {
            let mut coefficients = COEFFICIENTS;
            coefficients[slot] = value;
            coefficients
        };
        for eliminate in ways::<f64>() {
            // 2 x0 + x1 and x0 + x1 / 2; x2 and x3 only together.
            let singular = |number| Err(SolveError::Degenerate { block: number });
            assert_eq!(solve(eliminate, &with(2, 0.5)), singular(0));
            let number = Block { number: 7, diagonal: &[(0, 0, 1), (1, 0, 1)], ..SECOND };
            assert_eq!(eliminate(&number, &mut [[1.0; 2]; 4], &COEFFICIENTS), Err(SolveError::Degenerate { block: 7 }));
            assert_eq!(solve(eliminate, &with(4, f64::INFINITY)), Err(SolveError::Overflow));
            assert_eq!(solve(eliminate, &with(3, f64::NAN)), Err(SolveError::Overflow));
            assert_eq!(solve(eliminate, &with(5, f64::MAX)), Err(SolveError::Overflow));
            assert_eq!(eliminate(&SECOND, &mut [[0.0; 2]; 3], &COEFFICIENTS), Err(SolveError::TooLarge));
            assert_eq!(eliminate(&SECOND, &mut [[0.0; 2]; 1], &COEFFICIENTS), Err(SolveError::TooLarge));
        }
    }

    #[test]
    fn entries_out_of_range_are_ignored() {
        let mut matrix = [[0.0; 2]; 2];
        fill(&mut matrix, &[(0, 1, 1), (2, 0, 1), (0, 2, 1), (1, 1, 9), (1, 0, 0)], &[7.0, 8.0]);
        assert_eq!(matrix, [[0.0, 8.0], [7.0, 0.0]]);
        for eliminate in ways::<f64>() {
            let block = Block { coupling: &[(0, 0, 4), (1, 1, 5), (5, 0, 4), (0, 5, 4), (0, 0, 99)], ..SECOND };
            let mut right = [[0.0; 2]; 4];
            fill::<f64, f64, _>(&mut right, &RIGHT, &COEFFICIENTS);
            eliminate(&FIRST, &mut right, &COEFFICIENTS).unwrap();
            eliminate(&block, &mut right, &COEFFICIENTS).unwrap();
            assert_eq!(Ok(right), solve(eliminate, &COEFFICIENTS));
        }
    }

    #[test]
    fn rows_of_the_action_matrix_are_units_or_minus_solved_rows() {
        let right = [[1.0, -2.0, 3.0], [4.0, 5.0, 6.0]];
        let rows = [ActionRow::Solved(1), ActionRow::Unit(1), ActionRow::Solved(0)];
        let action = action_matrix(Fixed::<3>, &rows, &right);
        assert_eq!(action, [[-4.0, -5.0, -6.0], [0.0, 1.0, 0.0], [-1.0, 2.0, -3.0]]);
        let outside = action_matrix(Fixed::<3>, &[ActionRow::Solved(2), ActionRow::Unit(3)], &right);
        assert_eq!(outside, [[0.0; 3]; 3]);
        let precise = right.map(|row| row.map(DoubleDouble::from_f64));
        let read = solved_rows((Fixed::<3>, Fixed::<3>), &[1, 2, 0], &precise);
        assert_eq!(read, [[-4.0, -5.0, -6.0], [0.0; 3], [-1.0, 2.0, -3.0]]);
    }

    #[test]
    fn data_and_coefficients_must_be_finite() {
        assert_eq!(check_coefficients(&[1.0, 2.0], &[&[3.0], &[], &[4.0, 5.0]]), Ok(()));
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(check_coefficients(&[1.0], &[&[3.0], &[4.0, bad]]), Err(SolveError::NonFiniteInput));
            assert_eq!(check_coefficients(&[bad], &[&[bad], &[4.0]]), Err(SolveError::NonFiniteInput));
            assert_eq!(check_coefficients(&[1.0, bad], &[&[3.0]]), Err(SolveError::Overflow));
        }
    }
}
