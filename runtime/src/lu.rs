//! Elimination of one diagonal block of an elimination template.

use crate::error::SolveError;
use crate::float;

/// Solves `matrix * X = right`: on success `right[..N]` holds X, and `matrix` its LU factors.
///
/// ```text
///            N columns        M columns                  M columns
///   N rows [  matrix  ]     [   right   ]      ->      [     X     ]
///                           [ untouched ]              [ untouched ]
/// ```
///
/// Gaussian elimination with partial pivoting. Pivots are compared after dividing each row by its 1-norm (implicit
/// row equilibration), so a row may be scaled by any factor without changing the choice. Zero multipliers are
/// skipped: templates are sparse.
///
/// # Errors
/// [`SolveError::NonFiniteInput`] when an entry is infinite or NaN. [`SolveError::Degenerate`] when all candidates
/// for a pivot are below N * epsilon times the largest entry that their column had before elimination (in equilibrated
/// rows): what is left of the column is then rounding noise. Noise can also exceed that: of exactly singular matrices
/// of 25 rows that lack one dimension about one in eight passes, with a solution above 1e8. Also
/// [`SolveError::Degenerate`] when the solution overflows, or when `right` has fewer than N rows. `matrix` and `right`
/// are of no use after an error.
#[inline]
pub fn solve_block<const N: usize, const M: usize>(
    matrix: &mut [[f64; N]; N],
    right: &mut [[f64; M]],
) -> Result<(), SolveError> {
    solve_block_trailing(matrix, right, N)
}

/// Like [`solve_block`], but back-substitutes only the last `needed` rows of X: with the excess columns first and the
/// reducible columns last, those are the rows that the action matrix reads. The other rows of `right[..N]` are of no
/// use.
///
/// # Errors
/// As [`solve_block`].
#[inline]
pub fn solve_block_trailing<const N: usize, const M: usize>(
    matrix: &mut [[f64; N]; N],
    right: &mut [[f64; M]],
    needed: usize,
) -> Result<(), SolveError> {
    let Some(right) = right.first_chunk_mut::<N>() else {
        return Err(SolveError::Degenerate { column: 0 });
    };
    if !float::all_finite(right) {
        return Err(SolveError::NonFiniteInput);
    }
    eliminate(matrix, right)?;
    let first = N.saturating_sub(needed);
    back_substitute(matrix, right, first);
    if float::all_finite(&right[first..]) {
        Ok(())
    } else {
        Err(SolveError::Degenerate { column: N.saturating_sub(1) })
    }
}

/// Row scales (1 / 1-norm) and, per column, the smallest size that a pivot in equilibrated rows may have.
#[inline]
fn equilibrate<const N: usize>(matrix: &[[f64; N]; N]) -> Result<([f64; N], [f64; N]), SolveError> {
    let mut row_scale = [0.0; N];
    let mut column_size = [0.0; N];
    for i in 0..N {
        let mut partial = [0.0; 4];
        let (quads, rest) = matrix[i].as_chunks::<4>();
        for quad in quads {
            for lane in 0..4 {
                partial[lane] += quad[lane].abs();
            }
        }
        let norm = (partial[0] + partial[1]) + (partial[2] + partial[3]) + rest.iter().map(|x| x.abs()).sum::<f64>();
        if !norm.is_finite() {
            return Err(SolveError::NonFiniteInput);
        }
        row_scale[i] = 1.0 / norm;
        for j in 0..N {
            let size = matrix[i][j].abs() * row_scale[i];
            column_size[j] = if size > column_size[j] { size } else { column_size[j] };
        }
    }
    let threshold = N as f64 * f64::EPSILON;
    Ok((row_scale, column_size.map(|size| size * threshold)))
}

/// Forward elimination of matrix and right together, rows physically swapped.
#[inline]
fn eliminate<const N: usize, const M: usize>(
    matrix: &mut [[f64; N]; N],
    right: &mut [[f64; M]; N],
) -> Result<(), SolveError> {
    let (mut row_scale, smallest) = equilibrate(matrix)?;
    for k in 0..N {
        let mut pivot = k;
        let mut size = matrix[k][k].abs() * row_scale[k];
        for i in k + 1..N {
            let candidate = matrix[i][k].abs() * row_scale[i];
            if candidate > size {
                (pivot, size) = (i, candidate);
            }
        }
        // Also false for NaN, which a row without entries leaves behind.
        if !(size > smallest[k]) {
            return Err(SolveError::Degenerate { column: k });
        }
        if pivot != k {
            matrix.swap(k, pivot);
            right.swap(k, pivot);
            row_scale.swap(k, pivot);
        }
        let (above, below) = matrix.split_at_mut(k + 1);
        let (right_above, right_below) = right.split_at_mut(k + 1);
        let (pivot_row, pivot_right) = (&above[k], &right_above[k]);
        let inverse = 1.0 / pivot_row[k];
        for (row, right_row) in below.iter_mut().zip(right_below) {
            if row[k] != 0.0 {
                let multiplier = row[k] * inverse;
                row[k] = multiplier;
                for (entry, pivot_entry) in row[k + 1..].iter_mut().zip(&pivot_row[k + 1..]) {
                    *entry -= multiplier * pivot_entry;
                }
                for j in 0..M {
                    right_row[j] -= multiplier * pivot_right[j];
                }
            }
        }
    }
    Ok(())
}

/// Rows `first..` of U^-1 * right, from the last row up.
#[inline]
fn back_substitute<const N: usize, const M: usize>(matrix: &[[f64; N]; N], right: &mut [[f64; M]; N], first: usize) {
    for k in (first..N).rev() {
        let (above, below) = right.split_at_mut(k + 1);
        let mut row = above[k];
        for (factor, solved) in matrix[k][k + 1..].iter().zip(below.iter()) {
            if *factor != 0.0 {
                for j in 0..M {
                    row[j] -= factor * solved[j];
                }
            }
        }
        let inverse = 1.0 / matrix[k][k];
        for j in 0..M {
            row[j] *= inverse;
        }
        above[k] = row;
    }
}
