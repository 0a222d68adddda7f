//! Relative pose of two cameras from points in both images.

use eliminant_solvers::{fundamental_8pt_radial, relpose_5pt, relpose_6pt_focal};

use super::linear::{Matrix, Vector, null_space};
use super::{Instance, essential, vectors};

/// The nine coefficients of x2^T E x1 = 0, row by row.
fn epipolar_row(x1: &Vector, x2: &Vector) -> [f64; 9] {
    std::array::from_fn(|at| x2[at / 3] * x1[at % 3])
}

fn matrix(values: [f64; 9]) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| values[3 * i + j]))
}

/// Rays of five points to essential matrices of norm 1.
pub(crate) struct FivePoint([Vector; 5], [Vector; 5]);

impl Instance for FivePoint {
    fn load(data: &[f64]) -> Self {
        Self(vectors(data), vectors(&data[15..]))
    }

    fn solve(&self, found: &mut Vec<f64>) {
        let rows: [[f64; 9]; 5] = std::array::from_fn(|k| epipolar_row(&self.0[k], &self.1[k]));
        let basis: [[f64; 9]; 4] = null_space(rows);
        let Ok(solutions) = relpose_5pt::solve(&basis.map(matrix)) else { return };
        for s in solutions.iter() {
            // The basis is orthonormal, and the weights have length 1.
            let [a, b, c, d] = s.weights;
            found.extend((0..9).map(|i| a * basis[0][i] + b * basis[1][i] + c * basis[2][i] + d * basis[3][i]));
        }
    }
}

/// Image points of six points to poses and the focal length.
pub(crate) struct SixPointFocal([Vector; 6], [Vector; 6]);

impl Instance for SixPointFocal {
    fn load(data: &[f64]) -> Self {
        Self(vectors(data), vectors(&data[18..]))
    }

    fn solve(&self, found: &mut Vec<f64>) {
        let rows: [[f64; 9]; 6] = std::array::from_fn(|k| epipolar_row(&self.0[k], &self.1[k]));
        let basis: [[f64; 9]; 3] = null_space(rows);
        let Ok(solutions) = relpose_6pt_focal::solve(&basis.map(matrix)) else { return };
        for s in solutions.iter().filter(|s| s.w > 0.0) {
            let focal = s.w.sqrt().recip();
            let calibration = [focal, focal, 1.0];
            let [a, b, c] = s.weights;
            let f = matrix(std::array::from_fn(|i| a * basis[0][i] + b * basis[1][i] + c * basis[2][i]));
            let e: Matrix = std::array::from_fn(|i| std::array::from_fn(|j| calibration[i] * f[i][j] * calibration[j]));
            let rays = |x: &Vector| [x[0] / focal, x[1] / focal, x[2]];
            let (first, second) = (self.0.each_ref().map(rays), self.1.each_ref().map(rays));
            let mut poses = std::mem::take(found);
            let before = poses.len();
            essential::poses(&e, &first, &second, &mut poses);
            // The focal length follows each pose.
            let count = (poses.len() - before) / 12;
            for k in (0..count).rev() {
                poses.insert(before + 12 * (k + 1), focal);
            }
            *found = poses;
        }
    }
}

/// Image points of nine points, of which the first eight are used, to fundamental matrices and the
/// distortion.
pub(crate) struct RadialEightPoint([[f64; 2]; 8], [[f64; 2]; 8]);

impl Instance for RadialEightPoint {
    fn load(data: &[f64]) -> Self {
        let points = |data: &[f64]| vectors::<3, 8>(data).map(|[x, y, _]| [x, y]);
        Self(points(data), points(&data[27..]))
    }

    fn solve(&self, found: &mut Vec<f64>) {
        let Ok(solutions) = fundamental_8pt_radial::solve_for_radial_epipolar(&self.0, &self.1) else { return };
        for s in solutions.iter() {
            found.extend(s.fundamental.as_flattened());
            found.push(s.radial);
        }
    }
}
