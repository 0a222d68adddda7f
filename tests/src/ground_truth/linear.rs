//! Random numbers, null spaces and linear equations: what the makers of all families need.

use eliminant::emitted::{self, to_chart, vector_of};
use eliminant_generator::algebra::Random;
use eliminant_generator::problem::chart::chart;
use nalgebra::{DMatrix, DVector};

/// Sum of weight times matrix, the matrices 3x3 and stored one after another.
pub fn combination(matrices: &[f64], weights: &[f64]) -> Vec<f64> {
    (0..9).map(|i| weights.iter().zip(matrices.chunks(9)).map(|(w, m)| w * m[i]).sum()).collect()
}

/// The weights with which vectors of the same length, one after another, give this one, by least
/// squares.
pub(super) fn weights(matrices: &[f64], matrix: &[f64]) -> Vec<f64> {
    let columns = DMatrix::from_column_slice(matrix.len(), matrices.len() / matrix.len(), matrices);
    let right = DVector::from_column_slice(matrix);
    let solution = columns.svd(true, true).solve(&right, 0.0).expect("asked for");
    solution.as_slice().to_vec()
}

/// The unknowns of a vector that is given up to scale.
pub fn coordinates(vector: &[f64]) -> Vec<f64> {
    let mut coordinates = vec![0.0; vector.len() - 1];
    to_chart(&chart(vector.len()), vector, &mut coordinates);
    coordinates
}

/// The vector of length 1 with these unknowns.
pub fn vector(coordinates: &[f64]) -> Vec<f64> {
    let mut vector = vec![0.0; coordinates.len() + 1];
    vector_of(&chart(vector.len()), coordinates, &mut vector);
    vector
}

/// A uniform number in [low, high).
pub fn uniform(random: &mut Random, low: f64, high: f64) -> f64 {
    low + (high - low) * 0.5 * (random.symmetric_unit() + 1.0)
}

/// An orthonormal basis of the null space of independent rows.
pub fn null_space(rows: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let columns = rows.first().map_or(0, Vec::len);
    // Square: the thin decomposition has no null vectors.
    let matrix = DMatrix::from_fn(columns, columns, |i, j| rows.get(i).map_or(0.0, |row| row[j]));
    let right = matrix.svd(false, true).v_t.expect("asked for");
    (rows.len()..columns).map(|i| right.row(i).iter().copied().collect()).collect()
}

/// The null space that a solver derives from such rows, to the last bit.
pub(super) fn derived_null_space(rows: &[Vec<f64>]) -> Vec<f64> {
    let columns = rows.first().map_or(0, Vec::len);
    let mut vectors = vec![0.0; (columns - rows.len()) * columns];
    emitted::null_space(&mut rows.concat(), rows.len(), &mut vectors).expect("random instances are not degenerate");
    vectors
}

/// The rows X with leading X = right for as many rows of each: the leading unknowns of linear
/// equations in terms of the others. NaN where they do not determine them.
pub(super) fn solved(leading: &[Vec<f64>], right: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let matrix = |rows: &[Vec<f64>]| DMatrix::from_fn(rows.len(), rows[0].len(), |i, j| rows[i][j]);
    let right = matrix(right);
    let solution = matrix(leading).lu().solve(&right).unwrap_or_else(|| right.map(|_| f64::NAN));
    solution.row_iter().map(|row| row.iter().copied().collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn null_spaces_are_orthonormal_and_null() {
        let mut random = Random::new(3);
        let rows: Vec<Vec<f64>> = (0..5).map(|_| (0..9).map(|_| random.symmetric_unit()).collect()).collect();
        let basis = null_space(&rows);
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        assert_eq!(basis.len(), 4);
        for (i, vector) in basis.iter().enumerate() {
            assert!(rows.iter().all(|row| dot(row, vector).abs() < 1e-14));
            assert!((0..4).all(|j| (dot(vector, &basis[j]) - f64::from(u8::from(i == j))).abs() < 1e-14));
        }
    }
}
