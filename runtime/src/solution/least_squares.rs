//! Unknowns that occur linearly, from equations with the others known.

use core::ops::{Add, Div, Mul, Neg, Sub};

/// Larger systems are not solved.
pub const MOST_LINEAR: usize = 4;

/// The x with the least sum of squares of A x + b, from the normal equations A^T A x = -A^T b. A is
/// m x n, and its rows come with their entry of b:
///
/// ```text
///           x_1  ..  x_n   1
///   rows  [                     ]
///         [      A         b    ]
/// ```
///
/// Where A x + b = 0 can be solved, complex numbers need no conjugates. There are no pivots, so
/// that several instances take the same steps: A^T A of real numbers needs none. The normal
/// equations lose half of the digits where A is nearly singular; the polish brings them back.
/// Nothing is written if there are more than [`MOST_LINEAR`] unknowns, or no rows.
#[inline]
pub fn least_squares<T>(rows: &[T], x: &mut [T])
where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T> + Div<Output = T> + Neg<Output = T>,
{
    let n = x.len();
    let Some(&any) = rows.first() else { return };
    if n > MOST_LINEAR {
        return;
    }
    let mut normal = [[any; MOST_LINEAR + 1]; MOST_LINEAR];
    for i in 0..n {
        for j in i..=n {
            let products = rows.chunks_exact(n + 1).map(|row| row[i] * row[j]);
            let Some(sum) = products.reduce(|sum, product| sum + product) else { return };
            normal[i][j] = sum;
        }
    }
    // The upper triangle of a symmetric matrix stays symmetric under elimination.
    for pivot in 0..n {
        for i in pivot + 1..n {
            let factor = normal[pivot][i] / normal[pivot][pivot];
            for j in i..=n {
                normal[i][j] = normal[i][j] - factor * normal[pivot][j];
            }
        }
    }
    for i in (0..n).rev() {
        let sum = (i + 1..n).fold(normal[i][n], |sum, j| sum + normal[i][j] * x[j]);
        x[i] = -sum / normal[i][i];
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
            let rows: Vec<f64> = (0..n + 2).flat_map(row).collect();
            let mut x = vec![0.0; n];
            least_squares(&rows, &mut x);
            assert!(x.iter().zip(expected).all(|(x, e)| (x - e).abs() < 1e-11), "{n}: {x:?}");
        }
    }

    #[test]
    fn what_cannot_be_solved_is_fitted() {
        // x = 1, 2 and 6: their mean.
        let mut x = [0.0];
        least_squares(&[1.0, -1.0, 1.0, -2.0, 1.0, -6.0], &mut x);
        assert_eq!(x, [3.0]);
    }

    #[test]
    fn complex_systems_are_solved() {
        let i = Complex::new(0.0, 1.0);
        let one = Complex::new(1.0, 0.0);
        // (1 + i) x = 2 and x = 1 - i.
        let mut x = [one];
        least_squares(&[one + i, -(one + one), one, i - one], &mut x);
        assert!((x[0] - (one - i)).norm() < 1e-15, "{x:?}");
    }

    #[test]
    fn sizes_that_do_not_fit_write_nothing() {
        let mut x = [7.0; MOST_LINEAR + 1];
        least_squares(&[1.0; 12], &mut x);
        assert_eq!(x, [7.0; MOST_LINEAR + 1]);
        let mut x = [7.0];
        least_squares(&[], &mut x);
        assert_eq!(x, [7.0]);
    }
}
