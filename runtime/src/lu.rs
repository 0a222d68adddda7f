//! Elimination of one diagonal block of an elimination template.

use crate::error::SolveError;
use crate::float;
use crate::scalar::Real;

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
pub fn solve_block<R: Real, const N: usize, const M: usize>(
    matrix: &mut [[R; N]; N],
    right: &mut [[R; M]],
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
pub fn solve_block_trailing<R: Real, const N: usize, const M: usize>(
    matrix: &mut [[R; N]; N],
    right: &mut [[R; M]],
    needed: usize,
) -> Result<(), SolveError> {
    solve_rows(matrix.as_flattened_mut(), &mut [0.0; N], &mut [0.0; N], right, needed)
}

/// [`solve_block_trailing`] compiled once for all N: what large blocks gain from a known N is not worth their code.
///
/// # Errors
/// As [`solve_block`].
#[inline(never)]
pub(crate) fn solve_large_block<R: Real, const M: usize>(
    matrix: &mut [R],
    row_scale: &mut [f64],
    smallest: &mut [f64],
    right: &mut [[R; M]],
    needed: usize,
) -> Result<(), SolveError> {
    solve_rows(matrix, row_scale, smallest, right, needed)
}

/// The matrix row by row; `row_scale` and `smallest` are working memory, a number for each row.
#[inline(always)]
fn solve_rows<R: Real, const M: usize>(
    matrix: &mut [R],
    row_scale: &mut [f64],
    smallest: &mut [f64],
    right: &mut [[R; M]],
    needed: usize,
) -> Result<(), SolveError> {
    let n = row_scale.len();
    let Some(right) = right.get_mut(..n).filter(|_| matrix.len() == n * n && smallest.len() == n) else {
        return Err(SolveError::Degenerate { column: 0 });
    };
    if !float::all_finite(right) {
        return Err(SolveError::NonFiniteInput);
    }
    equilibrate(matrix, row_scale, smallest)?;
    eliminate(matrix, row_scale, smallest, right)?;
    let first = n.saturating_sub(needed);
    back_substitute(matrix, right, first);
    if float::all_finite(&right[first..]) {
        Ok(())
    } else {
        Err(SolveError::Degenerate { column: n.saturating_sub(1) })
    }
}

/// Row scales (1 / 1-norm) and, per column, the smallest size that a pivot in equilibrated rows may have.
#[inline(always)]
fn equilibrate<R: Real>(matrix: &[R], row_scale: &mut [f64], smallest: &mut [f64]) -> Result<(), SolveError> {
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
            return Err(SolveError::NonFiniteInput);
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

/// Forward elimination of matrix and right together, rows physically swapped.
#[inline(always)]
fn eliminate<R: Real, const M: usize>(
    matrix: &mut [R],
    row_scale: &mut [f64],
    smallest: &[f64],
    right: &mut [[R; M]],
) -> Result<(), SolveError> {
    let n = row_scale.len();
    for k in 0..n {
        let mut pivot = k;
        let mut size = matrix[k * n + k].modulus() * row_scale[k];
        for i in k + 1..n {
            let candidate = matrix[i * n + k].modulus() * row_scale[i];
            if candidate > size {
                (pivot, size) = (i, candidate);
            }
        }
        // Also false for NaN, which a row without entries leaves behind.
        if !(size > smallest[k]) {
            return Err(SolveError::Degenerate { column: k });
        }
        if pivot != k {
            let (above, below) = matrix.split_at_mut(pivot * n);
            above[k * n..(k + 1) * n].swap_with_slice(&mut below[..n]);
            right.swap(k, pivot);
            row_scale.swap(k, pivot);
        }
        let (above, below) = matrix.split_at_mut((k + 1) * n);
        let (right_above, right_below) = right.split_at_mut(k + 1);
        let (pivot_row, pivot_right) = (&above[k * n..], &right_above[k]);
        let inverse = pivot_row[k].reciprocal();
        for (row, right_row) in below.chunks_exact_mut(n).zip(right_below) {
            if row[k] != R::ZERO {
                let multiplier = row[k] * inverse;
                row[k] = multiplier;
                for (entry, pivot_entry) in row[k + 1..].iter_mut().zip(&pivot_row[k + 1..]) {
                    *entry -= multiplier * *pivot_entry;
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
#[inline(always)]
fn back_substitute<R: Real, const M: usize>(matrix: &[R], right: &mut [[R; M]], first: usize) {
    let n = right.len();
    for k in (first..n).rev() {
        let (above, below) = right.split_at_mut(k + 1);
        let mut row = above[k];
        for (factor, solved) in matrix[k * n + k + 1..(k + 1) * n].iter().zip(below.iter()) {
            if *factor != R::ZERO {
                for j in 0..M {
                    row[j] -= *factor * solved[j];
                }
            }
        }
        let inverse = matrix[k * n + k].reciprocal();
        for j in 0..M {
            row[j] *= inverse;
        }
        above[k] = row;
    }
}
