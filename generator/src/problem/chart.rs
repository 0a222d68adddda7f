//! The chart in which a vector that is given up to scale is solved for.
//!
//! A problem whose equations are homogeneous in a vector e of n unknowns determines it up to scale.
//! A solver needs n - 1 numbers. With an unknown set to 1 it loses all solutions in which that
//! unknown is 0, and data of exact structure have many: five points seen by a camera in planar
//! motion, say. Here a combination of all unknowns is 1 instead:
//!
//! ```text
//!   [ e_1 ]     [           ] [ u_1     ]
//!   [ ..  ]  ~  [     Q     ] [ ..      ]      Q = I - 2 v v^T / v^T v,  v = (2, .., n, m)
//!   [ e_n ]     [           ] [ u_(n-1) ]
//!                             [ 1       ]
//! ```
//!
//! Q is a reflection, so that it is orthogonal and its own inverse. The entries of its last row,
//! the combination that is 1, have comparable sizes and are all different: they cancel on no vector
//! of a few equal entries and zeros, as structure makes them.

/// The entry of Q in a row and a column, as a fraction whose denominator is that of all entries.
pub(super) fn entry(size: usize, row: usize, column: usize) -> (i64, i64) {
    let last = if size < 4 { size - 1 } else { size };
    let v = |at: usize| (if at + 1 == size { last } else { at + 2 }) as i64;
    let square: i64 = (0..size).map(|at| v(at) * v(at)).sum();
    (i64::from(row == column) * square - 2 * v(row) * v(column), square)
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
            assert!(last.iter().all(|x| x.abs() > 0.2 / (size as f64)), "{last:?}");
            let different = |i: usize, j: usize| (last[i].abs() - last[j].abs()).abs() > 1e-3;
            assert!((0..size).all(|i| (0..i).all(|j| different(i, j))), "{last:?}");
        }
    }
}
