//! Poses of cameras whose rays do not meet in one centre.

use eliminant_solvers::{pose_4pt_generalized_scale, relpose_6pt_generalized};

use super::linear::{Matrix, Vector, cross, dot, minus, solve, times};
use super::{Instance, vectors};

/// Rays of six points in two systems, centres and directions, to poses.
pub(crate) struct SixPoint {
    first: [[Vector; 2]; 6],
    second: [[Vector; 2]; 6],
}

impl Instance for SixPoint {
    fn load(data: &[f64]) -> Self {
        let rays = |data: &[f64]| {
            let (centres, directions) = (vectors::<3, 6>(data), vectors::<3, 6>(&data[18..]));
            std::array::from_fn(|k| [centres[k], directions[k]])
        };
        Self { first: rays(data), second: rays(&data[36..]) }
    }

    fn solve(&self, found: &mut Vec<f64>) {
        let Ok(solutions) = relpose_6pt_generalized::solve(&self.first, &self.second) else { return };
        for s in solutions.iter() {
            let rotation = of_quaternion(s.q);
            found.extend(rotation.as_flattened());
            found.extend(self.translation(&rotation));
        }
    }
}

impl SixPoint {
    /// The rays of a point meet: t . n = (p2 - R p1) . n with n = R x1 x x2. Least squares over all
    /// points.
    fn translation(&self, rotation: &Matrix) -> Vector {
        let (mut normal, mut right) = ([[0.0; 3]; 3], [[0.0]; 3]);
        for ([p1, x1], [p2, x2]) in self.first.iter().zip(&self.second) {
            let n = cross(&times(rotation, x1), x2);
            let along = dot(&n, &minus(p2, &times(rotation, p1)));
            for i in 0..3 {
                for j in 0..3 {
                    normal[i][j] += n[i] * n[j];
                }
                right[i][0] += n[i] * along;
            }
        }
        solve(normal, right).map(|[x]| x)
    }
}

/// The rotation of a quaternion of length 1.
pub(crate) fn of_quaternion([w, x, y, z]: [f64; 4]) -> Matrix {
    [
        [w * w + x * x - y * y - z * z, 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), w * w - x * x + y * y - z * z, 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ]
}

/// Centres, rays of length 1 and points to the pose with the scale s: s p + depth x = R X + t.
pub(crate) struct PoseScale {
    centres: [Vector; 4],
    rays: [Vector; 4],
    points: [Vector; 4],
}

impl Instance for PoseScale {
    fn load(data: &[f64]) -> Self {
        Self { centres: vectors(data), rays: vectors(&data[12..]), points: vectors(&data[24..]) }
    }

    /// Of the eight equations the solver takes seven; the last tells which solution is returned.
    fn solve(&self, found: &mut Vec<f64>) {
        let poses = pose_4pt_generalized_scale::solve_for_scaled_pose(&self.centres, &self.rays, &self.points);
        let Ok(poses) = poses else { return };
        if let Some(best) = poses.iter().min_by(|a, b| a.residual.abs().total_cmp(&b.residual.abs())) {
            found.extend(best.rotation.as_flattened());
            found.extend(best.translation);
            found.push(best.scale);
        }
    }
}
