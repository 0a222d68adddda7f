//! Elimination with the same pivots for all instances.
//!
//! Lanes cannot swap rows of their own. All swap the same rows: the row is chosen whose candidate
//! for the pivot, relative to the largest candidate of its instance, is best in the worst instance.
//! On random templates of five points in four lanes, the least of these ratios in all columns is
//! 0.19 (median) and 0.026 (minimum), and the backward error stays below 4e-15.

use fearless_simd::Simd;

use crate::batch::lanes::{Lanes, Mask};
use crate::elimination::lu::BlockError;
use crate::number::Arithmetic;
use crate::size::{Fixed, Size, Vector};

/// An instance whose pivot is smaller than this, relative to its largest candidate, would lose too
/// many digits: it is solved by itself.
const LEAST_RATIO: f64 = 1e-3;

/// The first row whose ratios all exceed this is taken without a look at the others.
const GOOD_RATIO: f64 = 0.25;

/// The row, of those from `first` on, whose entry is the best pivot for all instances, given the
/// size of the entry of each row; and for which instances it is good enough. Entries of at most
/// `noise` may be rounding errors.
#[inline(always)]
pub(super) fn choose<S: Simd, Z: Size>(
    (first, end): (usize, usize),
    sizes: &Z::Vector<Lanes<S>>,
    noise: Lanes<S>,
) -> (usize, Mask<S>) {
    let mut largest = sizes[first];
    for i in first + 1..end {
        largest = sizes[i].max(largest);
    }
    let one = largest.constant(1.0);
    let inverse = one / largest;
    let (mut best, mut ratio) = (first, -1.0);
    let (good, zero) = (largest * one.constant(GOOD_RATIO), one.constant(0.0));
    for i in first..end {
        if sizes[i].at_most(good).bits() == 0 {
            best = i;
            break;
        }
        // Zero in all instances, as most entries of a sparse template.
        if sizes[i].above(zero).bits() != 0 {
            let of_row = (sizes[i] * inverse).least();
            (best, ratio) = if of_row > ratio { (i, of_row) } else { (best, ratio) };
        }
    }
    let is_good = (sizes[best] * inverse).above(one.constant(LEAST_RATIO)).bits();
    let is_clear = largest.above(noise).bits();
    (best, Mask::from_bits(one.token(), is_good & is_clear))
}

/// Solves `matrix * X = right` for the last `needed` rows of X, like
/// [`solve_block_trailing`](crate::elimination::lu::solve_block_trailing). The results of an
/// instance that must be solved by itself are NaN.
///
/// # Errors
/// [`BlockError::Shape`].
#[inline(always)]
pub(super) fn solve_block<S: Simd, V: Vector<Lanes<S>>, const N: usize>(
    matrix: &mut [[Lanes<S>; N]; N],
    right: &mut [V],
    needed: usize,
) -> Result<(), BlockError> {
    if N == 0 {
        return Ok(());
    }
    let Some(right) = right.get_mut(..N) else { return Err(BlockError::Shape) };
    let zero = matrix[0][0].constant(0.0);
    let mut row_scale = [zero; N];
    let mut noise = [zero; N];
    for i in 0..N {
        let mut sum = zero;
        for j in 0..N {
            sum += matrix[i][j].abs();
        }
        row_scale[i] = zero.constant(1.0) / sum;
        for j in 0..N {
            noise[j] = (matrix[i][j].abs() * row_scale[i]).max(noise[j]);
        }
    }
    let rounding = zero.constant(N as f64 * f64::EPSILON);
    let mut inverses = [zero; N];
    for k in 0..N {
        let mut sizes = [zero; N];
        for i in k..N {
            sizes[i] = matrix[i][k].abs() * row_scale[i];
        }
        let (best, is_good) = choose::<S, Fixed<N>>((k, N), &sizes, noise[k] * rounding);
        if best != k {
            // Entry by entry: whole rows of lanes would be swapped by calls.
            for j in k..N {
                (matrix[k][j], matrix[best][j]) = (matrix[best][j], matrix[k][j]);
            }
            let (above, below) = right.split_at_mut(best);
            for (a, b) in above[k].as_mut().iter_mut().zip(below[0].as_mut()) {
                (*a, *b) = (*b, *a);
            }
            (row_scale[k], row_scale[best]) = (row_scale[best], row_scale[k]);
        }
        inverses[k] = is_good.select(zero.constant(1.0) / matrix[k][k], zero.constant(f64::NAN));
        for i in k + 1..N {
            // Zero in all instances, as most entries of a sparse template.
            if matrix[i][k].abs().above(zero).bits() == 0 {
                continue;
            }
            let multiplier = matrix[i][k] * inverses[k];
            for j in k + 1..N {
                matrix[i][j] = matrix[i][j].minus(multiplier, matrix[k][j]);
            }
            let (above, below) = right.split_at_mut(i);
            for (entry, &known) in below[0].as_mut().iter_mut().zip(above[k].as_ref()) {
                *entry = entry.minus(multiplier, known);
            }
        }
    }
    // 0, or NaN for an instance without some pivot.
    let mut missing = zero;
    for k in 0..N {
        missing += inverses[k] * zero;
    }
    for k in (N.saturating_sub(needed)..N).rev() {
        let inverse = inverses[k] + missing;
        let (above, below) = right.split_at_mut(k + 1);
        let row = above[k].as_mut();
        for (&factor, solved) in matrix[k][k + 1..].iter().zip(below.iter()) {
            for (entry, &known) in row.iter_mut().zip(solved.as_ref()) {
                *entry = entry.minus(factor, known);
            }
        }
        row.iter_mut().for_each(|entry| *entry = *entry * inverse);
    }
    Ok(())
}
