//! Essential matrices to poses.

use super::linear::{Matrix, Vector, cross, dot, times};

/// Appends the poses (R, row by row, then t of length 1) of an essential matrix E = \[t\]x R, up to
/// a factor, for which all points lie in front of both cameras.
///
/// The columns of E are orthogonal to t, so that t lies along their cross products. With |t| = 1
/// and the cofactors C of E, R is C - \[t\]x E, and for -E it is C + \[t\]x E (Horn, "Recovering
/// baseline and orientation from essential matrix", 1990).
pub(crate) fn poses<const N: usize>(e: &Matrix, first: &[Vector; N], second: &[Vector; N], found: &mut Vec<f64>) {
    let square: f64 = e.iter().map(|row| dot(row, row)).sum();
    let scale = (2.0 / square).sqrt();
    let e = e.map(|row| row.map(|x| scale * x));
    let columns: Matrix = std::array::from_fn(|j| std::array::from_fn(|i| e[i][j]));
    let products = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| cross(&columns[i], &columns[j]));
    let squares = products.map(|product| dot(&product, &product));
    let largest = (0..3).fold(0, |best, i| if squares[i] > squares[best] { i } else { best });
    let inverse = squares[largest].sqrt().recip();
    let t = products[largest].map(|x| inverse * x);
    // Columns of [t]x E.
    let turned = columns.map(|column| cross(&t, &column));
    for sign in [-1.0, 1.0] {
        let rotation: Matrix = std::array::from_fn(|i| std::array::from_fn(|j| products[j][i] + sign * turned[j][i]));
        if let Some(side) = side(&rotation, &t, first, second) {
            found.extend(rotation.as_flattened());
            found.extend(t.map(|x| side * x));
        }
    }
}

/// 1 if all points are in front of both cameras, -1 if they are with -t.
fn side<const N: usize>(rotation: &Matrix, t: &Vector, first: &[Vector; N], second: &[Vector; N]) -> Option<f64> {
    let mut side = 0.0;
    for (x1, x2) in first.iter().zip(second) {
        let x1 = times(rotation, x1);
        // The depths that bring depth_1 R x1 + t nearest to depth_2 x2, times a positive number.
        let (inner, along_1, along_2) = (dot(&x1, x2), dot(&x1, t), dot(x2, t));
        let depths = [inner * along_2 - dot(x2, x2) * along_1, dot(&x1, &x1) * along_2 - inner * along_1];
        if depths[0] * depths[1] <= 0.0 || depths[0] * side < 0.0 {
            return None;
        }
        side = depths[0].signum();
    }
    Some(side)
}
