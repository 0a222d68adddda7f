//! Pose and scale of a generalised camera as three quadrics, as PoseLib solves it: Kukelova,
//! Heller, Fitzgibbon, "Efficient intersection of three quadrics and applications in computer
//! vision", CVPR 2016.

use eliminant_solvers::three_quadrics;

use super::Instance;
use super::generalized::{PoseScale, of_quaternion};
use super::linear::{dot, solve};

/// As [`PoseScale`]: four of seven equations give translation and scale, linear in the rotation;
/// the other three are quadrics in its Cayley parameters.
pub(crate) struct PoseScaleQuadrics(PoseScale);

impl Instance for PoseScaleQuadrics {
    fn load(data: &[f64]) -> Self {
        Self(PoseScale::load(data))
    }

    fn solve(&self, found: &mut Vec<f64>) {
        let rows = self.0.equations();
        let left: [[f64; 4]; 4] = std::array::from_fn(|i| std::array::from_fn(|j| rows[i][9 + j]));
        let right: [[f64; 9]; 4] = std::array::from_fn(|i| std::array::from_fn(|j| -rows[i][j]));
        // (t, s) = linear R
        let linear = solve(left, right);
        let quadrics: [[f64; 10]; 3] = std::array::from_fn(|k| {
            let row = &rows[4 + k];
            quadric(&std::array::from_fn(|j| row[j] + (0..4).map(|i| row[9 + i] * linear[i][j]).sum::<f64>()))
        });
        let Ok(solutions) = three_quadrics::solve(&quadrics) else { return };
        let mut best = (f64::INFINITY, [0.0; 13]);
        for s in solutions.iter() {
            let scale = (1.0 + s.x * s.x + s.y * s.y + s.z * s.z).sqrt().recip();
            let rotation = of_quaternion([1.0, s.x, s.y, s.z].map(|entry| scale * entry));
            let mut pose = [0.0; 13];
            pose[..9].copy_from_slice(rotation.as_flattened());
            for i in 0..4 {
                pose[9 + i] = (0..9).map(|j| linear[i][j] * pose[j]).sum();
            }
            let residual = dot(&rows[7], &pose).abs();
            if residual < best.0 {
                best = (residual, pose);
            }
        }
        if best.0.is_finite() {
            found.extend(best.1);
        }
    }
}

/// r . R = 0, the rotation row by row, times 1 + x^2 + y^2 + z^2: the coefficients of x^2, x y,
/// x z, y^2, y z, z^2, x, y, z, 1.
fn quadric(r: &[f64; 9]) -> [f64; 10] {
    [
        r[0] - r[4] - r[8],
        2.0 * (r[1] + r[3]),
        2.0 * (r[2] + r[6]),
        r[4] - r[0] - r[8],
        2.0 * (r[5] + r[7]),
        r[8] - r[0] - r[4],
        2.0 * (r[7] - r[5]),
        2.0 * (r[2] - r[6]),
        2.0 * (r[3] - r[1]),
        r[0] + r[4] + r[8],
    ]
}
