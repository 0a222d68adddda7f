//! Instances whose solutions are known beforehand: geometry first, data from it.

mod absolute_pose;
mod benchmarks;
mod cameras;
mod circles;
mod optimal_pose;
mod orbits;
mod platforms;
mod points;
mod radial_distortion;
mod ranging;
mod relative_pose;
mod triangulation;

pub use circles::{Circle, Line, gram, minimal_conic, minimal_data, normalised};
use eliminant_generator::algebra::Random;
use nalgebra::DMatrix;

use crate::Case;
use crate::statistics::worst;

/// A truth counts as found if some real solution is this close.
pub const FOUND: f64 = 1e-6;

/// Data of a problem with solutions known from the way they were made.
pub struct KnownInstance {
    /// Flat data, as a [`crate::Case`] takes them.
    pub data: Vec<f64>,
    /// What the solver must find, in the terms of [`Maker::error`]; not always all solutions.
    pub truths: Vec<Vec<f64>>,
}

/// Makes instances of one problem.
pub struct Maker {
    /// Name of the problem.
    pub name: &'static str,
    /// Draws an instance.
    pub make: fn(&mut Random) -> KnownInstance,
    /// The relative error of a solution against a truth: `error(data, solution, truth)`.
    pub error: fn(&[f64], &[f64], &[f64]) -> f64,
}

impl Maker {
    /// Draws an instance and solves it: the error of the truth that is found worst, infinite where a solution is missing altogether.
    pub fn worst_error(&self, case: &Case, random: &mut Random) -> f64 {
        let instance = (self.make)(random);
        let Ok(found) = (case.solve)(&instance.data) else { return f64::INFINITY };
        let error_of = |truth: &Vec<f64>| {
            found.iter().map(|solution| (self.error)(&instance.data, solution, truth)).fold(f64::INFINITY, f64::min)
        };
        worst(instance.truths.iter().map(error_of))
    }
}

/// One maker for every problem, by name.
pub fn makers() -> Vec<Maker> {
    let families = [
        absolute_pose::makers(),
        benchmarks::makers(),
        circles::makers(),
        optimal_pose::makers(),
        orbits::makers(),
        platforms::makers(),
        points::makers(),
        radial_distortion::makers(),
        ranging::makers(),
        relative_pose::makers(),
        triangulation::makers(),
    ];
    let mut makers: Vec<Maker> = families.into_iter().flatten().collect();
    makers.sort_by_key(|maker| maker.name);
    makers
}

/// |x - truth| / |truth|.
pub fn relative_error(x: &[f64], truth: &[f64]) -> f64 {
    let square = |v: &mut dyn Iterator<Item = f64>| v.map(|x| x * x).sum::<f64>().sqrt();
    square(&mut x.iter().zip(truth).map(|(x, t)| x - t)) / square(&mut truth.iter().copied())
}

/// Distance of the unit vectors along x and truth, up to sign.
pub fn projective_error(x: &[f64], truth: &[f64]) -> f64 {
    let norm = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    let (x_norm, truth_norm) = (norm(x), norm(truth));
    let unit: Vec<f64> = x.iter().map(|x| x / x_norm).collect();
    let [plus, minus] = [1.0, -1.0].map(|sign| {
        let truth: Vec<f64> = truth.iter().map(|t| sign * t / truth_norm).collect();
        relative_error(&unit, &truth)
    });
    plus.min(minus)
}

/// The largest relative error of the unknowns, each for itself.
fn largest_relative_error(x: &[f64], truth: &[f64]) -> f64 {
    worst(x.iter().zip(truth).map(|(x, truth)| (x - truth).abs() / truth.abs()))
}

/// Sum of weight times matrix, the matrices 3x3 and stored one after another.
pub fn combination(matrices: &[f64], weights: &[f64]) -> Vec<f64> {
    (0..9).map(|i| weights.iter().zip(matrices.chunks(9)).map(|(w, m)| w * m[i]).sum()).collect()
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

/// The rows X with leading X = right for as many rows of each: the leading unknowns of linear equations in terms of the others.
fn solved(leading: &[Vec<f64>], right: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let matrix = |rows: &[Vec<f64>]| DMatrix::from_fn(rows.len(), rows[0].len(), |i, j| rows[i][j]);
    let solution = matrix(leading).lu().solve(&matrix(right)).expect("random instances are not degenerate");
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
