//! Pose of a camera from points of known position.

use eliminant_solvers::{pose_3pt, pose_35pt_focal};

use super::linear::Vector;
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
        let Ok(poses) = pose_35pt_focal::solve_for_pose(&self.points, &horizontal, &vertical) else { return };
        for pose in poses.iter() {
            found.extend(pose.rotation.as_flattened());
            found.extend(pose.translation);
            found.push(pose.focal * unit);
        }
    }
}
