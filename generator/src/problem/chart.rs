//! The chart in which a vector that is given up to scale is solved for.
//!
//! A problem whose equations are homogeneous in a vector e of n unknowns determines it up to scale.
//! A solver needs n - 1 numbers. With an unknown set to 1 it loses all solutions in which that
//! unknown is 0, and data of exact structure have many: five points seen by a camera in planar
//! motion, say. Here a combination of all unknowns is 1 instead:
//!
//! ```text
//!   [ e_1 ]     [           ] [ u_1     ]
//!   [ ..  ]  ~  [     Q     ] [ ..      ]      Q = I - 2 v v^T / v^T v,  v = (w_1, .., w_(n-1), m)
//!   [ e_n ]     [           ] [ u_(n-1) ]
//!                             [ 1       ]
//! ```
//!
//! Q is a reflection, so that it is orthogonal and its own inverse. Its last row, the combination
//! that is 1, is
//!
//! ```text
//!   [ -2 m w_1   ..   -2 m w_(n-1)   s - m^2 ] / (s + m^2)      s = w_1^2 + .. + w_(n-1)^2
//! ```
//!
//! A vector at which it vanishes has no coordinates. Structure makes vectors of small integers,
//! (0, 3, 4) for instance, and none may be one of these. Let w_1 c_1 + .. + w_(n-1) c_(n-1) vanish
//! for no small integers c but 0, and let 2 m and s - m^2 have no common divisor. Then the last row
//! vanishes for no small integers either: c_n would have to be a multiple of 2 m.

use crate::algebra::MAX_UNKNOWNS;
use crate::expression::rational::gcd;

/// The numbers w. The least integers for which a combination of the first k vanishes have an
/// absolute value of at least 41, 7, 4, 3, 2, 2 and 2 for k = 2 to 8. So large is that of the
/// charts of 3 to 9 unknowns. Nothing is claimed of the other numbers.
const WEIGHTS: [i64; MAX_UNKNOWNS] = [37, 41, 50, 57, 93, 120, 132, 194, 205, 215, 225, 235, 245, 255, 265, 275];

/// The vector v for n unknowns.
///
/// The least m with m^2 > s / 2.1 that has no divisor in common with s, and where s - m^2 is odd.
/// At this quotient the last entry of the row is 0.35, and the others are 0.94 / sqrt(n - 1) in the
/// mean square.
fn normal(size: usize) -> Vec<i64> {
    let mut v = WEIGHTS[..size - 1].to_vec();
    let square: i64 = v.iter().map(|w| w * w).sum();
    let first = (square as f64 / 2.1).sqrt() as i64 + 1;
    v.extend(
        (first..)
            .find(|m| (square - m * m) % 2 != 0 && gcd(m.unsigned_abs().into(), square.unsigned_abs().into()) == 1),
    );
    v
}

/// The entry of Q in a row and a column, as a fraction whose denominator is that of all entries.
pub fn entry(size: usize, row: usize, column: usize) -> (i64, i64) {
    let v = normal(size);
    let square: i64 = v.iter().map(|x| x * x).sum();
    (i64::from(row == column) * square - 2 * v[row] * v[column], square)
}

/// Q for a vector of n unknowns, row by row.
pub fn chart(size: usize) -> Vec<Vec<f64>> {
    let value = |(numerator, denominator): (i64, i64)| numerator as f64 / denominator as f64;
    (0..size).map(|row| (0..size).map(|column| value(entry(size, row, column))).collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn charts_are_orthogonal_and_mix_all_unknowns() {
        for size in 2..=16 {
            let q = chart(size);
            for i in 0..size {
                for j in 0..size {
                    let product: f64 = (0..size).map(|k| q[i][k] * q[k][j]).sum();
                    assert!((product - f64::from(u8::from(i == j))).abs() < 1e-15, "{size}: {i} {j}");
                }
            }
            let last = &q[size - 1];
            assert!(last.iter().all(|x| x.abs() > 0.6 / (size as f64)), "{last:?}");
            let different = |i: usize, j: usize| (last[i].abs() - last[j].abs()).abs() > 1e-3;
            assert!((0..size).all(|i| (0..i).all(|j| different(i, j))), "{last:?}");
        }
    }

    /// All vectors of integers up to a bound, but for their sign.
    #[test]
    fn vectors_of_small_integers_have_coordinates() {
        for (size, bound) in [(2, 200), (3, 20), (4, 6), (5, 3), (6, 2), (7, 1), (8, 1), (9, 1)] {
            let row: Vec<i64> = (0..size).map(|column| entry(size, size - 1, column).0).collect();
            let choices = 2 * bound + 1_i64;
            let count = choices.pow(size as u32) / 2;
            for at in 0..count {
                let digit = |k: usize| at / choices.pow(k as u32) % choices - bound;
                let sum: i64 = (0..size).map(|k| digit(k) * row[k]).sum();
                assert_ne!(sum, 0, "{:?}", (0..size).map(digit).collect::<Vec<_>>());
            }
        }
    }
}
