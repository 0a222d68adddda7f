//! Unknowns that occur linearly, from equations with the others known.

use core::ops::{Add, Div, Mul, Neg, Sub};

/// Larger systems are not solved.
pub const MOST_LINEAR: usize = 4;

/// The x with the least sum of squares of A x + b. A is m x n, and its rows come with their entry
/// of b:
///
/// ```text
///           x_1  ..  x_n   1
///   rows  [                     ]
///         [      A         b    ]
/// ```
///
/// Columns are made orthogonal to those before them, one after another, b like the others
/// (modified Gram-Schmidt, here without roots; Higham, "Accuracy and Stability of Numerical
/// Algorithms", 2002, section 20.3): errors grow with the condition of A, those of normal equations
/// with its square.
/// There are no pivots, so that several instances take the same steps. Where A x + b = 0 can be
/// solved, complex numbers need no conjugates. Nothing is written if there are more than
/// [`MOST_LINEAR`] unknowns, or no rows; the rows are overwritten.
#[inline]
pub fn least_squares<T>(rows: &mut [T], x: &mut [T])
where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T> + Div<Output = T> + Neg<Output = T>,
{
    let n = x.len();
    let Some(&any) = rows.first() else { return };
    if n > MOST_LINEAR {
        return;
    }
    let mut triangle = [[any; MOST_LINEAR + 1]; MOST_LINEAR];
    for pivot in 0..n {
        let product = |rows: &[T], column: usize| {
            let products = rows.chunks_exact(n + 1).map(|row| row[pivot] * row[column]);
            products.reduce(|sum, product| sum + product)
        };
        let Some(square) = product(rows, pivot) else { return };
        for column in pivot + 1..=n {
            let Some(along) = product(rows, column) else { return };
            let part = along / square;
            for row in rows.chunks_exact_mut(n + 1) {
                row[column] = row[column] - part * row[pivot];
            }
            triangle[pivot][column] = part;
        }
    }
    for i in (0..n).rev() {
        x[i] = -(i + 1..n).fold(triangle[i][n], |sum, j| sum + triangle[i][j] * x[j]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Complex;
    use std::vec;
    use std::vec::Vec;

    #[test]
    fn systems_that_can_be_solved_are() {
        let expected = [2.0, -3.0, 0.5, 4.0];
        let entry = |i: usize, j: usize| {
            f64::from((7 * i as u32 * i as u32 + 5 * j as u32 + 3 * i as u32 * j as u32) % 11) - 4.0
        };
        for n in 1..=MOST_LINEAR {
            let row = |i: usize| {
                let of_x = (0..n).map(move |j| entry(i, j));
                let constant: f64 = of_x.clone().zip(expected).map(|(a, x)| -a * x).sum();
                of_x.chain([constant])
            };
            let mut rows: Vec<f64> = (0..n + 2).flat_map(row).collect();
            let mut x = vec![0.0; n];
            least_squares(&mut rows, &mut x);
            assert!(x.iter().zip(expected).all(|(x, e)| (x - e).abs() < 1e-11), "{n}: {x:?}");
        }
    }

    /// The product of this matrix and its transpose is singular in `f64` (Läuchli 1961).
    #[test]
    fn columns_may_be_nearly_dependent() {
        let e = 1e-9;
        let mut x = [0.0_f64; 2];
        least_squares(&mut [1.0, 1.0, -3.0, e, 0.0, -e, 0.0, e, -2.0 * e], &mut x);
        assert!((x[0] - 1.0).abs() < 1e-6 && (x[1] - 2.0).abs() < 1e-6, "{x:?}");
    }

    #[test]
    fn what_cannot_be_solved_is_fitted() {
        // x = 1, 2 and 6: their mean.
        let mut x = [0.0];
        least_squares(&mut [1.0, -1.0, 1.0, -2.0, 1.0, -6.0], &mut x);
        assert_eq!(x, [3.0]);
    }

    #[test]
    fn complex_systems_are_solved() {
        let i = Complex::new(0.0, 1.0);
        let one = Complex::new(1.0, 0.0);
        // (1 + i) x = 2 and x = 1 - i.
        let mut x = [one];
        least_squares(&mut [one + i, -(one + one), one, i - one], &mut x);
        assert!((x[0] - (one - i)).norm() < 1e-15, "{x:?}");
    }

    #[test]
    fn sizes_that_do_not_fit_write_nothing() {
        let mut x = [7.0; MOST_LINEAR + 1];
        least_squares(&mut [1.0; 12], &mut x);
        assert_eq!(x, [7.0; MOST_LINEAR + 1]);
        let mut x = [7.0];
        least_squares(&mut [], &mut x);
        assert_eq!(x, [7.0]);
    }
}
