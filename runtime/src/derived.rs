//! Data that are derived from data before a solve: square roots, linear systems, null spaces and
//! choices.

use crate::error::SolveError;
use crate::number::Real;
use crate::number::float::{exponent, power_of_two, sqrt};
use crate::number::sums::sum_of;

/// What is left of a row or a pivot, relative to its row as it was given, counts as rounding below
/// this times the number of columns.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Writes the square roots of numbers.
///
/// # Errors
/// [`SolveError::Overflow`] where a number is negative or not finite.
pub fn square_root(numbers: &[f64], roots: &mut [f64]) -> Result<(), SolveError> {
    for (root, &number) in roots.iter_mut().zip(numbers) {
        *root = sqrt(number);
        if !root.is_finite() {
            return Err(SolveError::Overflow);
        }
    }
    Ok(())
}

/// Writes orthonormal vectors that span the null space of a matrix.
///
/// ```text
///                   columns
///            [ . . . . . . . . . ]                          columns
///     rows   [ . . A, by rows  . ]     ->    columns - rows [ . . . vectors . . . ]
///            [ . . . . . . . . . ]
/// ```
///
/// Householder reflections take A to a triangle on its left, with the row of which most is left
/// taken next; the reflected last unit vectors span the null space (Golub, Van Loan, "Matrix
/// computations", sections 5.2 and 5.4). The scale of a row does not matter.
///
/// # Errors
/// [`SolveError::Overflow`] for a number that is not finite, [`SolveError::LostRank`] if a
/// row depends on others up to rounding, or the lengths do not belong together. The contents of
/// both lists are undefined after an error, and those of `matrix` also without one.
pub fn null_space(matrix: &mut [f64], rows: usize, vectors: &mut [f64]) -> Result<(), SolveError> {
    null_space_sized(matrix, (rows, matrix.len().checked_div(rows).unwrap_or(0)), vectors)
}

/// As [`null_space`], for a size that the compiler knows. The results have the same bits.
///
/// # Errors
/// As [`null_space`].
pub fn null_space_small<const ROWS: usize, const COLUMNS: usize>(
    matrix: &mut [f64],
    vectors: &mut [f64],
) -> Result<(), SolveError> {
    null_space_sized(matrix, (ROWS, COLUMNS), vectors)
}

#[inline(always)]
fn null_space_sized(
    matrix: &mut [f64],
    (rows, columns): (usize, usize),
    vectors: &mut [f64],
) -> Result<(), SolveError> {
    let is_consistent = 0 < rows && rows < columns && vectors.len() == (columns - rows) * columns;
    if !is_consistent || matrix.len() != rows * columns {
        return Err(SolveError::LostRank);
    }
    for row in matrix.chunks_exact_mut(columns) {
        let factor = scale_of(row)?;
        row.iter_mut().for_each(|x| *x *= factor);
    }
    for step in 0..rows {
        let (mut best, mut largest) = (step, 0.0);
        for (at, row) in matrix.chunks_exact(columns).enumerate().skip(step) {
            let square = dot(row, row);
            if square > largest {
                (best, largest) = (at, square);
            }
        }
        let length = sqrt(largest);
        if !(length > ROUNDING * columns as f64) {
            return Err(SolveError::LostRank);
        }
        for column in 0..columns {
            matrix.swap(step * columns + column, best * columns + column);
        }
        let (done, others) = matrix.split_at_mut((step + 1) * columns);
        let mirror = &mut done[step * columns..];
        // Reflects the row to a multiple of a unit vector. The mirror gets the length sqrt(2).
        let head = mirror[step];
        mirror[step] = head + length.copysign(head);
        let factor = 1.0 / sqrt(largest + length * head.abs());
        mirror.iter_mut().for_each(|x| *x *= factor);
        for row in others.chunks_exact_mut(columns) {
            reflect(mirror, row);
            // What is left of the row is to the right. Later mirrors have zeros here, so that all
            // loops have the length of a row.
            row[step] = 0.0;
        }
    }
    for (at, vector) in vectors.chunks_exact_mut(columns).enumerate() {
        vector.fill(0.0);
        vector[rows + at] = 1.0;
        for mirror in matrix.chunks_exact(columns).rev() {
            reflect(mirror, vector);
        }
    }
    Ok(())
}

/// x - v (v x), for a vector v of length sqrt(2).
#[inline(always)]
fn reflect(v: &[f64], x: &mut [f64]) {
    let product = dot(v, x);
    x.iter_mut().zip(v).for_each(|(x, v)| *x -= product * v);
}

#[inline(always)]
fn dot(a: &[f64], b: &[f64]) -> f64 {
    sum_of(a.len().min(b.len()), 0.0, |k| a[k] * b[k])
}

/// Writes the values whose key is least.
///
/// ```text
///   operands:  the keys, then the values of each of them      chosen:  the values of one
/// ```
///
/// What is not finite, key or value, is not chosen, such as what was derived from a matrix without
/// full rank.
///
/// # Errors
/// [`SolveError::LostRank`] if no key is finite with its values, or the lengths do not belong
/// together.
pub fn least(operands: &[f64], keys: usize, chosen: &mut [f64]) -> Result<(), SolveError> {
    if chosen.is_empty() || operands.len() != keys * (1 + chosen.len()) {
        return Err(SolveError::LostRank);
    }
    let (keys, values) = operands.split_at(keys);
    let of_keys = keys.iter().zip(values.chunks_exact(chosen.len()));
    let finite = of_keys.filter(|(key, values)| key.is_finite() && values.iter().all(|x| x.is_finite()));
    let (_, least) = finite.min_by(|(a, _), (b, _)| a.total_cmp(b)).ok_or(SolveError::LostRank)?;
    chosen.copy_from_slice(least);
    Ok(())
}

/// The power of two that takes the largest entry of a row to about 1, so that no digit changes.
#[inline(always)]
fn scale_of<R: Real>(row: &[R]) -> Result<f64, SolveError> {
    let (mut largest, mut is_finite) = (0.0, true);
    for x in row {
        is_finite &= x.is_finite();
        largest = if x.magnitude() > largest { x.magnitude() } else { largest };
    }
    if is_finite { Ok(power_of_two(-exponent(largest))) } else { Err(SolveError::Overflow) }
}

/// Writes the solution X of A X = B.
///
/// ```text
///   matrix:  A, size x size, row by row, then B, size x right      solution:  size x right
/// ```
///
/// Gaussian elimination with partial pivoting of rows and columns that are equilibrated by powers
/// of two: the units of equations and of unknowns do not matter. A pivot must be more than `least`,
/// which is for `f64` and is less at twice the precision, and more than rounding.
///
/// # Errors
/// [`SolveError::Overflow`] if a number or X is not finite, [`SolveError::LostRank`] if A is
/// singular up to rounding, or the lengths do not belong together. The contents of both lists are
/// undefined after an error, and those of `matrix` also without one.
pub fn solve_linear<R: Real>(matrix: &mut [R], size: usize, least: f64, solution: &mut [R]) -> Result<(), SolveError> {
    solve_sized(matrix, (size, solution.len().checked_div(size).unwrap_or(0)), least, solution)
}

/// As [`solve_linear`], for a small size and number of right sides that the compiler knows. The
/// results have the same bits.
///
/// # Errors
/// As [`solve_linear`].
pub fn solve_small<R: Real, const SIZE: usize, const RIGHT: usize>(
    matrix: &mut [R],
    least: f64,
    solution: &mut [R],
) -> Result<(), SolveError> {
    solve_sized(matrix, (SIZE, RIGHT), least, solution)
}

#[inline(always)]
fn solve_sized<R: Real>(
    matrix: &mut [R],
    (size, right): (usize, usize),
    least: f64,
    solution: &mut [R],
) -> Result<(), SolveError> {
    if right == 0 || solution.len() != size * right || matrix.len() != size * (size + right) {
        return Err(SolveError::LostRank);
    }
    let (a, b) = matrix.split_at_mut(size * size);
    solution.copy_from_slice(b);
    let least = (least / f64::EPSILON).max(8.0 * size as f64) * R::EPSILON;
    if !solution.iter().all(|x| x.is_finite()) {
        return Err(SolveError::Overflow);
    }
    for (row, of_right) in a.chunks_exact_mut(size).zip(solution.chunks_exact_mut(right)) {
        let factor = scale_of(row)?;
        row.iter_mut().for_each(|x| *x = x.scale(factor));
        of_right.iter_mut().for_each(|x| *x = x.scale(factor));
    }
    // The right sides are copied, so that their place can hold the factors of the columns.
    let factors = &mut b[..size];
    for (column, factor) in factors.iter_mut().enumerate() {
        let largest = (0..size).fold(0.0, |largest, row| f64::max(largest, a[row * size + column].magnitude()));
        let of_column = if largest > 0.0 { power_of_two(-exponent(largest)) } else { 1.0 };
        for row in 0..size {
            a[row * size + column] = a[row * size + column].scale(of_column);
        }
        *factor = R::from_f64(of_column);
    }
    for step in 0..size {
        let (mut best, mut largest) = (step, 0.0);
        for row in step..size {
            let magnitude = a[row * size + step].magnitude();
            if magnitude > largest {
                (best, largest) = (row, magnitude);
            }
        }
        if !(largest > least) {
            return Err(SolveError::LostRank);
        }
        for column in 0..size {
            a.swap(step * size + column, best * size + column);
        }
        for column in 0..right {
            solution.swap(step * right + column, best * right + column);
        }
        for row in step + 1..size {
            let factor = a[row * size + step] / a[step * size + step];
            for column in step + 1..size {
                let of_pivot = a[step * size + column];
                a[row * size + column] -= factor * of_pivot;
            }
            subtract_row(solution, right, (row, step), factor);
        }
    }
    for step in (0..size).rev() {
        for other in step + 1..size {
            subtract_row(solution, right, (step, other), a[step * size + other]);
        }
        let pivot = a[step * size + step];
        solution[step * right..][..right].iter_mut().for_each(|x| *x = *x / pivot);
    }
    for (of_unknown, &factor) in solution.chunks_exact_mut(right).zip(factors.iter()) {
        of_unknown.iter_mut().for_each(|x| *x *= factor);
    }
    if solution.iter().all(|x| x.is_finite()) { Ok(()) } else { Err(SolveError::Overflow) }
}

/// Subtracts a multiple of one row of a matrix with so many columns from another one.
#[inline(always)]
fn subtract_row<R: Real>(matrix: &mut [R], columns: usize, (row, other): (usize, usize), factor: R) {
    for column in 0..columns {
        let subtrahend = factor * matrix[other * columns + column];
        matrix[row * columns + column] -= subtrahend;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers in [-1, 1) without a generator: the fractional parts of an irrational times squares.
    fn drawn(count: usize) -> impl Iterator<Item = f64> {
        (1..=count).map(|k| 2.0 * ((k * k) as f64 * 0.754_877_666_246_692_8).fract() - 1.0)
    }

    #[test]
    fn null_vectors_are_orthonormal_whatever_the_scale_of_a_row() {
        for scale in [1.0, 1e-150, 1e150] {
            let (rows, columns) = (5, 9);
            let mut matrix = [0.0; 45];
            matrix.iter_mut().zip(drawn(45)).for_each(|(x, value)| *x = value);
            matrix[18..27].iter_mut().for_each(|x| *x *= scale);
            let (given, mut vectors) = (matrix, [0.0; 36]);
            null_space(&mut matrix, rows, &mut vectors).unwrap();
            let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            for (i, v) in vectors.chunks(columns).enumerate() {
                for (j, w) in vectors.chunks(columns).enumerate() {
                    assert!((dot(v, w) - f64::from(u8::from(i == j))).abs() < 1e-15);
                }
                for row in given.chunks(columns) {
                    assert!(dot(row, v).abs() < 1e-15 * row.iter().fold(0.0, |m: f64, x| m.max(x.abs())));
                }
            }
        }
    }

    #[test]
    fn systems_are_solved_whatever_the_scale_of_a_row() {
        for scale in [1.0, 1e-150, 1e150] {
            let mut matrix = [0.0; 24];
            matrix.iter_mut().zip(drawn(24)).for_each(|(x, value)| *x = value);
            // No pivot on the diagonal.
            matrix[0] = 0.0;
            matrix[4..8].iter_mut().for_each(|x| *x *= scale);
            matrix[18..20].iter_mut().for_each(|x| *x *= scale);
            let (given, mut x) = (matrix, [0.0; 8]);
            solve_linear(&mut matrix, 4, 0.0, &mut x).unwrap();
            for (row, column) in (0..4).flat_map(|row| (0..2).map(move |column| (row, column))) {
                let product: f64 = (0..4).map(|k| given[row * 4 + k] * x[k * 2 + column]).sum();
                let right = given[16 + row * 2 + column];
                assert!((product - right).abs() <= 1e-14 * if row == 1 { scale } else { 1.0 }, "{product} {right}");
            }
        }
    }

    #[test]
    fn the_least_key_that_is_finite_chooses() {
        let chosen = |operands: &[f64], keys: usize, size: usize| {
            let mut chosen = [0.0; 2];
            least(operands, keys, &mut chosen[..size]).map(|()| chosen)
        };
        assert_eq!(chosen(&[2.0, -1.0, 0.5, 20.0, 10.0, 5.0], 3, 1), Ok([10.0, 0.0]));
        assert_eq!(chosen(&[f64::NAN, f64::NEG_INFINITY, 9.0, 1.0, 2.0, 3.0], 3, 1), Ok([3.0, 0.0]));
        assert_eq!(chosen(&[3.0, 3.0, 1.0, 2.0, 4.0, 5.0], 2, 2), Ok([1.0, 2.0]));
        assert_eq!(chosen(&[f64::NAN, f64::INFINITY, 1.0, 2.0], 2, 1), Err(SolveError::LostRank));
        assert_eq!(chosen(&[1.0, 2.0, f64::NAN, 5.0], 2, 1), Ok([5.0, 0.0]));
        assert_eq!(chosen(&[1.0, 2.0, 4.0, 3.0, 5.0, f64::INFINITY], 2, 2), Ok([4.0, 3.0]));
        assert_eq!(chosen(&[1.0, f64::NAN], 1, 1), Err(SolveError::LostRank));
        assert_eq!(chosen(&[1.0, 2.0, 3.0], 2, 1), Err(SolveError::LostRank));
        assert_eq!(chosen(&[1.0], 1, 0), Err(SolveError::LostRank));
    }

    #[test]
    fn lost_rank_and_numbers_that_are_not_finite_are_errors() {
        let third = 1.0 / 3.0;
        let mut dependent = [1.0, 2.0, 3.0, third, 2.0 * third, 1.0];
        assert_eq!(null_space(&mut dependent, 2, &mut [0.0; 3]), Err(SolveError::LostRank));
        assert_eq!(null_space(&mut [0.0; 6], 2, &mut [0.0; 3]), Err(SolveError::LostRank));
        assert_eq!(null_space(&mut [1.0; 6], 2, &mut [0.0; 4]), Err(SolveError::LostRank));
        assert_eq!(
            solve_linear(&mut [1.0, 3.0, third, 1.0, 1.0, 1.0], 2, 0.0, &mut [0.0; 2]),
            Err(SolveError::LostRank)
        );
        assert_eq!(solve_linear(&mut [1e-8, 1.0, 1.0, 1.0, 1.0, 1.0], 2, 0.5, &mut [0.0; 2]), Ok(()));
        assert_eq!(solve_linear(&mut [1.0, 1.0, 1.0, 1.5, 1.0, 1.0], 2, 0.5, &mut [0.0; 2]), Err(SolveError::LostRank));
        assert_eq!(solve_linear::<f64>(&mut [], 0, 0.0, &mut []), Err(SolveError::LostRank));
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(null_space(&mut [1.0, bad], 1, &mut [0.0; 2]), Err(SolveError::Overflow));
            assert_eq!(solve_linear(&mut [bad, 1.0], 1, 0.0, &mut [0.0]), Err(SolveError::Overflow));
            assert_eq!(solve_linear(&mut [1.0, bad], 1, 0.0, &mut [0.0]), Err(SolveError::Overflow));
        }
        let mut roots = [0.0; 2];
        assert_eq!((square_root(&[2.25, 0.0], &mut roots), roots), (Ok(()), [1.5, 0.0]));
        assert_eq!(square_root(&[-1e-300], &mut roots), Err(SolveError::Overflow));
        assert_eq!(solve_linear(&mut [1e-300, 1e300], 1, 0.0, &mut [0.0]), Err(SolveError::Overflow));
    }

    #[test]
    fn units_of_unknowns_do_not_matter() {
        let size = 5;
        let given: [f64; 30] = {
            let mut matrix = [0.0; 30];
            matrix.iter_mut().zip(drawn(30)).for_each(|(x, value)| *x = value);
            matrix
        };
        let solved = |scale: i32| {
            let (mut matrix, mut solution) = (given, [0.0; 5]);
            for row in 0..size {
                for column in 0..size {
                    matrix[row * size + column] *= power_of_two(scale * column as i32);
                }
            }
            solve_linear(&mut matrix, size, 0.0, &mut solution).unwrap();
            core::array::from_fn::<f64, 5, _>(|k| solution[k] * power_of_two(scale * k as i32))
        };
        let wanted = solved(0);
        for scale in [-100, -30, 30, 100] {
            // Rows are equilibrated first, so that another pivot may be taken.
            for (x, wanted) in solved(scale).iter().zip(wanted) {
                assert!((x - wanted).abs() < 1e-13 * wanted.abs(), "{x} for {wanted} at {scale}");
            }
        }
    }
}
