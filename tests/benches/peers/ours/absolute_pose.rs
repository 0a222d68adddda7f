//! Pose of a camera from points of known position.

use eliminant_solvers::{pose_3pt, pose_35pt_focal};

use super::linear::{Matrix, Vector, cross, dot, minus, times};
use super::{Instance, vectors};

/// Rays of length 1 to three points, and the points, to poses.
pub(crate) struct ThreePoint([Vector; 3], [Vector; 3]);

impl Instance for ThreePoint {
    fn load(data: &[f64]) -> Self {
        Self(vectors(data), vectors(&data[9..]))
    }

    fn solve(&self, found: &mut Vec<f64>) {
        let Self(rays, points) = self;
        let Ok(poses) = pose_3pt::solve_for_pose(rays, points) else { return };
        for pose in poses.iter() {
            found.extend(pose.rotation.as_flattened());
            found.extend(pose.translation);
        }
    }
}

/// Image points of four points, of the last the horizontal coordinate, to poses and focal lengths.
pub(crate) struct ThreeAndAHalfPoint {
    images: [[f64; 2]; 4],
    points: [Vector; 4],
}

impl Instance for ThreeAndAHalfPoint {
    fn load(data: &[f64]) -> Self {
        Self { images: vectors(data), points: vectors(&data[8..]) }
    }

    fn solve(&self, found: &mut Vec<f64>) {
        let unit = self.images.as_flattened()[..7].iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
        let horizontal: [f64; 4] = std::array::from_fn(|k| self.images[k][0] / unit);
        let vertical: [f64; 3] = std::array::from_fn(|k| self.images[k][1] / unit);
        let Ok(solutions) = pose_35pt_focal::solve(&self.points, &horizontal, &vertical) else { return };
        for s in solutions.iter() {
            if let Some((rotation, translation, focal)) = self.pose(s.x, s.y, &horizontal, &vertical) {
                found.extend(rotation.as_flattened());
                found.extend(translation);
                found.push(focal * unit);
            }
        }
    }
}

impl ThreeAndAHalfPoint {
    /// Pose and focal length of the quaternion (1, x, y, 0).
    ///
    /// With Y the point turned by it, (c, s) the turn about the axis, g = 1/f and h = g t_3
    ///
    /// ```text
    ///   u (g Y_3 + h) = c Y_1 - s Y_2 + t_1      v (g Y_3 + h) = s Y_1 + c Y_2 + t_2
    /// ```
    ///
    /// Two rows of the problem's matrix, which eliminate h, t_1 and t_2, give (c, s, g) up to a
    /// factor.
    fn pose(&self, x: f64, y: f64, u: &[f64; 4], v: &[f64; 3]) -> Option<(Matrix, Vector, f64)> {
        let size = (1.0 + x * x + y * y).recip();
        let turn = [
            [size * (1.0 + x * x - y * y), size * 2.0 * x * y, size * 2.0 * y],
            [size * 2.0 * x * y, size * (1.0 - x * x + y * y), size * -2.0 * x],
            [size * -2.0 * y, size * 2.0 * x, size * (1.0 - x * x - y * y)],
        ];
        let turned = self.points.each_ref().map(|point| times(&turn, point));
        let row = |i: usize, j: usize, k: usize| {
            let (to_j, to_k) = (minus(&turned[j], &turned[i]), minus(&turned[k], &turned[i]));
            let (across, down) = (u[i] - u[j], v[i] - v[k]);
            [
                down * to_j[0] - across * to_k[1],
                -down * to_j[1] - across * to_k[0],
                -down * u[j] * to_j[2] + across * v[k] * to_k[2],
            ]
        };
        let rows = [row(0, 1, 2), row(0, 2, 1), row(1, 3, 2), row(2, 3, 1)];
        let pairs = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)].map(|(i, j)| cross(&rows[i], &rows[j]));
        let [c, s, g] =
            pairs.into_iter().reduce(|best, next| if dot(&next, &next) > dot(&best, &best) { next } else { best })?;
        let scale = (c * c + s * s).sqrt().recip().copysign(g);
        let [c, s, g] = [c, s, g].map(|x| scale * x);
        // h by least squares on the differences to the first point.
        let (mut above, mut below) = (0.0, 0.0);
        for k in 1..4 {
            let to = minus(&turned[k], &turned[0]);
            let mut add = |from: f64, at: f64, rest: f64| {
                let step = at - from;
                above += step * (rest - g * (at * turned[k][2] - from * turned[0][2]));
                below += step * step;
            };
            add(u[0], u[k], c * to[0] - s * to[1]);
            if k < 3 {
                add(v[0], v[k], s * to[0] + c * to[1]);
            }
        }
        let h = above / below;
        let [y1, y2, y3] = turned[0];
        let depth = g * y3 + h;
        let translation = [u[0] * depth - (c * y1 - s * y2), v[0] * depth - (s * y1 + c * y2), h / g];
        let rotation: Matrix = [
            std::array::from_fn(|j| c * turn[0][j] - s * turn[1][j]),
            std::array::from_fn(|j| s * turn[0][j] + c * turn[1][j]),
            turn[2],
        ];
        Some((rotation, translation, g.recip()))
    }
}
