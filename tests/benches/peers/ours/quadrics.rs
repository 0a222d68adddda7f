//! Points on three quadrics.

use eliminant_solvers::three_quadrics;

use super::{Instance, vectors};

/// Coefficients of three quadrics to their common points.
pub(crate) struct ThreeQuadrics([[f64; 10]; 3]);

impl Instance for ThreeQuadrics {
    fn load(data: &[f64]) -> Self {
        Self(vectors(data))
    }

    fn solve(&self, found: &mut Vec<f64>) {
        if let Ok(solutions) = three_quadrics::solve(&self.0) {
            solutions.iter().for_each(|s| found.extend([s.x, s.y, s.z]));
        }
    }
}
