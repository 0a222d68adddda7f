//! Elimination of one diagonal block of an elimination template.

use arrayvec::ArrayVec;

use crate::number::{Arithmetic, Real};
use crate::size::Vector;

/// Why a block has no solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlockError {
    /// An entry is infinite or NaN.
    NonFinite,
    /// No candidate for a pivot is above rounding.
    Singular {
        /// The column in which the rank was lost, counted from zero.
        column: usize,
    },
    /// The solution is not finite.
    Overflow,
    /// The slices do not have the lengths that belong together.
    Shape,
}

/// A square matrix, row by row, and the working memory of its elimination.
#[derive(Debug)]
pub struct BlockMemory<'a, R> {
    /// N^2 entries.
    pub matrix: &'a mut [R],
    /// N entries: 1 / 1-norm of each row.
    pub row_scale: &'a mut [f64],
    /// N entries, zero before the call: the smallest size that a pivot of each column may have.
    pub smallest: &'a mut [f64],
}

/// Solves `matrix * X = right`. On success `right[..N]` holds X, and `matrix` its factor U.
///
/// ```text
///            N columns        M columns                  M columns
///   N rows [  matrix  ]     [   right   ]      ->      [     X     ]
///                           [ untouched ]              [ untouched ]
/// ```
///
/// Gaussian elimination with partial pivoting. Pivots are compared after each row is divided by its
/// 1-norm (implicit row equilibration), so the scale of a row does not change the choice. Zero
/// multipliers are skipped, because templates are sparse.
///
/// # Errors
/// [`BlockError::NonFinite`] if an entry is infinite or NaN. [`BlockError::Singular`] if all
/// candidates for a pivot are below N * epsilon times the largest entry that their column had
/// before elimination (in equilibrated rows): what is left of the column is then rounding noise.
/// Noise can exceed that bound: of exactly singular matrices of 25 rows and rank 24, about one in
/// eight passes, with a solution above 1e8. [`BlockError::Overflow`] if the solution overflows.
/// [`BlockError::Shape`] if `right` has fewer than N rows. After an error the contents of `matrix`
/// and `right` are undefined.
#[inline]
pub fn solve_block<R: Real, V: Vector<R>, const N: usize>(
    matrix: &mut [[R; N]; N],
    right: &mut [V],
) -> Result<(), BlockError> {
    solve_block_trailing(matrix, right, N)
}

/// Like [`solve_block`], but back-substitutes only the last `needed` rows of X. If excess columns
/// come first and reducible columns last, those are the rows that the action matrix reads. The
/// contents of the other rows of `right[..N]` are undefined.
///
/// # Errors
/// As [`solve_block`].
#[inline]
pub fn solve_block_trailing<R: Real, V: Vector<R>, const N: usize>(
    matrix: &mut [[R; N]; N],
    right: &mut [V],
    needed: usize,
) -> Result<(), BlockError> {
    let (row_scale, smallest) = (&mut [0.0; N], &mut [0.0; N]);
    solve_rows(BlockMemory { matrix: matrix.as_flattened_mut(), row_scale, smallest }, right, needed, back_substitute)
}

/// Like [`solve_block_trailing`], with a size that is known at run time. The code is compiled once
/// for all N: large blocks gain little from a constant N.
///
/// # Errors
/// As [`solve_block`].
#[inline(never)]
pub fn solve_large_block<R: Real, V: Vector<R>>(
    memory: BlockMemory<'_, R>,
    right: &mut [V],
    needed: usize,
) -> Result<(), BlockError> {
    solve_rows(memory, right, needed, back_substitute)
}

/// Like [`solve_large_block`], on rows of a length that is known at run time, too. The code is
/// compiled once for all sizes.
#[inline(never)]
fn solve_slices<R: Real>(memory: BlockMemory<'_, R>, right: &mut [&mut [R]], needed: usize) -> Result<(), BlockError> {
    solve_rows(memory, right, needed, back_substitute_in_place)
}

/// Numbers with which a block of a template is eliminated.
pub trait Eliminated: Arithmetic {
    /// Solves a diagonal block: see [`solve_block_trailing`].
    ///
    /// # Errors
    /// As [`solve_block_trailing`].
    fn solve_block<V: Vector<Self>, const N: usize>(
        matrix: &mut [[Self; N]; N],
        right: &mut [V],
        needed: usize,
    ) -> Result<(), BlockError>;
}

impl<R: Real> Eliminated for R {
    #[inline(always)]
    fn solve_block<V: Vector<Self>, const N: usize>(
        matrix: &mut [[R; N]; N],
        right: &mut [V],
        needed: usize,
    ) -> Result<(), BlockError> {
        R::by_precision(
            (matrix, right),
            |(matrix, right)| solve_block_trailing(matrix, right, needed),
            |(matrix, right)| {
                let (row_scale, smallest) = (&mut [0.0; N], &mut [0.0; N]);
                let memory = BlockMemory { matrix: matrix.as_flattened_mut(), row_scale, smallest };
                let mut right: ArrayVec<&mut [R], N> = right.iter_mut().map(|row| row.as_mut()).take(N).collect();
                solve_slices(memory, &mut right, needed)
            },
        )
    }
}

/// `back_substitute` computes the rows from some row on: [`back_substitute`], for example.
#[inline(always)]
fn solve_rows<R: Real, V: AsRef<[R]> + AsMut<[R]>>(
    memory: BlockMemory<'_, R>,
    right: &mut [V],
    needed: usize,
    back_substitute: impl FnOnce(&[R], &mut [V], usize),
) -> Result<(), BlockError> {
    let BlockMemory { matrix, row_scale, smallest } = memory;
    let n = row_scale.len();
    let Some(right) = right.get_mut(..n).filter(|_| matrix.len() == n * n && smallest.len() == n) else {
        return Err(BlockError::Shape);
    };
    if !all_finite(right) {
        return Err(BlockError::NonFinite);
    }
    equilibrate(matrix, row_scale, smallest)?;
    eliminate(matrix, row_scale, smallest, right)?;
    let first = n.saturating_sub(needed);
    back_substitute(matrix, right, first);
    if all_finite(&right[first..]) { Ok(()) } else { Err(BlockError::Overflow) }
}

/// True if no entry is infinite or NaN. There is no early exit, so that the loop vectorises.
#[inline(always)]
pub(crate) fn all_finite<R: Real, V: AsRef<[R]>>(rows: &[V]) -> bool {
    /// Independent sums: the loop over a single sum could not be vectorised.
    const LANES: usize = 4;
    // x * 0 is 0 for finite x and NaN otherwise.
    let mut sums = [0.0; LANES];
    for row in rows {
        let (groups, rest) = row.as_ref().as_chunks::<LANES>();
        for group in groups {
            for lane in 0..LANES {
                sums[lane] += group[lane].real() * 0.0;
            }
        }
        for (sum, entry) in sums.iter_mut().zip(rest) {
            *sum += entry.real() * 0.0;
        }
    }
    sums.iter().all(|&sum| sum == 0.0)
}

/// Computes row scales (1 / 1-norm) and, per column, the smallest size that a pivot in equilibrated
/// rows may have.
#[inline(always)]
fn equilibrate<R: Real>(matrix: &[R], row_scale: &mut [f64], smallest: &mut [f64]) -> Result<(), BlockError> {
    let n = row_scale.len();
    for (row, scale) in matrix.chunks_exact(n.max(1)).zip(row_scale.iter_mut()) {
        let mut partial = [0.0; 4];
        let (quads, rest) = row.as_chunks::<4>();
        for quad in quads {
            for lane in 0..4 {
                partial[lane] += quad[lane].modulus();
            }
        }
        let norm =
            (partial[0] + partial[1]) + (partial[2] + partial[3]) + rest.iter().map(|x| x.modulus()).sum::<f64>();
        if !norm.is_finite() {
            return Err(BlockError::NonFinite);
        }
        *scale = 1.0 / norm;
        for (largest, entry) in smallest.iter_mut().zip(row) {
            let size = entry.modulus() * *scale;
            *largest = if size > *largest { size } else { *largest };
        }
    }
    let threshold = n as f64 * R::EPSILON;
    smallest.iter_mut().for_each(|size| *size *= threshold);
    Ok(())
}

/// In blocks of at most this size, whole rows are subtracted, though columns before the pivot are
/// zero in all rows from the pivot on: a length that the compiler knows saves more time.
const WHOLE_ROWS: usize = 12;

/// Eliminates forward in matrix and right together; rows are swapped in memory.
#[inline(always)]
fn eliminate<R: Real, V: AsRef<[R]> + AsMut<[R]>>(
    matrix: &mut [R],
    row_scale: &mut [f64],
    smallest: &[f64],
    right: &mut [V],
) -> Result<(), BlockError> {
    let n = row_scale.len();
    let whole_rows = n <= WHOLE_ROWS;
    for k in 0..n {
        let mut pivot = k;
        let mut size = matrix[k * n + k].modulus() * row_scale[k];
        for i in k + 1..n {
            let candidate = matrix[i * n + k].modulus() * row_scale[i];
            if candidate > size {
                (pivot, size) = (i, candidate);
            }
        }
        // The comparison is also false for NaN, the size in a row of zeros, whose scale is
        // infinite.
        if !(size > smallest[k]) {
            return Err(BlockError::Singular { column: k });
        }
        if pivot != k {
            let (above, below) = matrix.split_at_mut(pivot * n);
            above[k * n..(k + 1) * n].swap_with_slice(&mut below[..n]);
            let (above, below) = right.split_at_mut(pivot);
            above[k].as_mut().swap_with_slice(below[0].as_mut());
            row_scale.swap(k, pivot);
        }
        let (above, below) = matrix.split_at_mut((k + 1) * n);
        let (right_above, right_below) = right.split_at_mut(k + 1);
        let (pivot_row, pivot_right) = (&above[k * n..], &right_above[k]);
        let inverse = pivot_row[k].reciprocal();
        let first = if whole_rows { 0 } else { k + 1 };
        for (row, right_row) in below.chunks_exact_mut(n).zip(right_below) {
            if row[k] != R::ZERO {
                let multiplier = row[k] * inverse;
                for (entry, pivot_entry) in row[first..].iter_mut().zip(&pivot_row[first..]) {
                    *entry -= multiplier * *pivot_entry;
                }
                row[k] = R::ZERO;
                for (entry, pivot_entry) in right_row.as_mut().iter_mut().zip(pivot_right.as_ref()) {
                    *entry -= multiplier * *pivot_entry;
                }
            }
        }
    }
    Ok(())
}

/// Computes rows `first..` of U^-1 * right, from the last row up.
#[inline(always)]
fn back_substitute<R: Real, V: Vector<R>>(matrix: &[R], right: &mut [V], first: usize) {
    let n = right.len();
    for k in (first..n).rev() {
        let (above, below) = right.split_at_mut(k + 1);
        let mut row = above[k].clone();
        for (factor, solved) in matrix[k * n + k + 1..(k + 1) * n].iter().zip(below.iter()) {
            if *factor != R::ZERO {
                for (entry, known) in row.as_mut().iter_mut().zip(solved.as_ref()) {
                    *entry -= *factor * *known;
                }
            }
        }
        let inverse = matrix[k * n + k].reciprocal();
        row.as_mut().iter_mut().for_each(|entry| *entry *= inverse);
        above[k] = row;
    }
}

/// Like [`back_substitute`], on rows that have an owner elsewhere. In a copy entries can stay in
/// registers, which does not matter at twice the precision.
#[inline(always)]
fn back_substitute_in_place<R: Real>(matrix: &[R], right: &mut [&mut [R]], first: usize) {
    let n = right.len();
    for k in (first..n).rev() {
        let (above, below) = right.split_at_mut(k + 1);
        let row = &mut *above[k];
        for (factor, solved) in matrix[k * n + k + 1..(k + 1) * n].iter().zip(below.iter()) {
            if *factor != R::ZERO {
                for (entry, known) in row.iter_mut().zip(solved.iter()) {
                    *entry -= *factor * *known;
                }
            }
        }
        let inverse = matrix[k * n + k].reciprocal();
        row.iter_mut().for_each(|entry| *entry *= inverse);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Scalar;
    use crate::number::double_double::DoubleDouble;

    /// Numbers in [-1, 1): the fractional parts of an irrational times squares, with digits below
    /// those of `f64`.
    fn drawn(k: usize) -> DoubleDouble {
        let part = |k: usize| 2.0 * ((k * k) as f64 * 0.754_877_666_246_692_8).fract() - 1.0;
        DoubleDouble::from_f64(part(k)) + DoubleDouble::from_f64(part(k + 1000) * 1e-20)
    }

    /// At twice the precision the solution has the bits that a size known to the compiler gives.
    fn agrees<const N: usize, const M: usize, const ROWS: usize>(matrix: [[DoubleDouble; N]; N], needed: usize) {
        let mut right: [[DoubleDouble; M]; ROWS] =
            core::array::from_fn(|i| core::array::from_fn(|j| drawn(500 + M * i + j)));
        let (mut of_slices, mut right_of_slices) = (matrix, right);
        let mut constant = matrix;
        let solved = solve_block_trailing(&mut constant, &mut right, needed);
        assert_eq!(DoubleDouble::solve_block(&mut of_slices, &mut right_of_slices, needed), solved);
        if solved.is_ok() {
            assert_eq!((of_slices, &right_of_slices[N - needed..]), (constant, &right[N - needed..]));
        }
        let is_regular = matrix[N - 1] != [DoubleDouble::ZERO; N];
        assert_eq!(solved.is_ok(), is_regular && ROWS >= N, "{solved:?}");
    }

    #[test]
    fn slices_give_the_same_bits_at_twice_the_precision() {
        for seed in 0..20 {
            let mut matrix: [[DoubleDouble; 5]; 5] =
                core::array::from_fn(|i| core::array::from_fn(|j| drawn(100 * seed + 5 * i + j)));
            // The first pivot is elsewhere.
            matrix[0][0] = DoubleDouble::ZERO;
            agrees::<5, 3, 5>(matrix, 5);
            agrees::<5, 3, 7>(matrix, 2);
            agrees::<5, 1, 4>(matrix, 5);
            matrix[4] = [DoubleDouble::ZERO; 5];
            agrees::<5, 3, 5>(matrix, 5);
        }
    }
}
