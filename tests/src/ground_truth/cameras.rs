//! Cameras that look at points: what the families of pose problems share.

use std::f64::consts::PI;

use eliminant_generator::algebra::Random;
use nalgebra::{Matrix3, Quaternion, Rotation3, UnitQuaternion, Vector2, Vector3};

use super::uniform;

/// A camera 2 to 6 units from a ball of radius 1, looking at a point inside the ball of half its
/// radius: x = rotation X + translation are the coordinates in the camera.
pub fn camera(random: &mut Random) -> (Matrix3<f64>, Vector3<f64>) {
    let direction = in_ball(random).normalize();
    let centre = direction * uniform(random, 2.0, 6.0);
    let up = in_ball(random);
    let rotation = Rotation3::look_at_lh(&(0.5 * in_ball(random) - centre), &up).into_inner();
    (rotation, -rotation * centre)
}

/// How the second camera is placed beside the first. All but the first kind are motions of
/// vehicles, robots and turntables, of which data have structure: entries of null vectors vanish,
/// or are equal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    /// Independently of the first.
    General,
    /// A turn about the vertical, and a translation in the plane.
    Planar,
    /// Along the optical axis, without a rotation.
    Forward,
    /// Along the horizontal axis of the image, without a rotation.
    Sideways,
    /// Any translation, without a rotation.
    Translation,
    /// A half turn about the optical axis, and any translation.
    HalfTurn,
    /// A quarter turn about the optical axis, and any translation.
    QuarterTurn,
    /// About a vertical axis through the middle of the points.
    Turntable,
    /// As the first kind, by lenses without distortion.
    Undistorted,
}

impl Motion {
    /// All kinds.
    pub const ALL: [Self; 9] = [
        Self::General,
        Self::Planar,
        Self::Forward,
        Self::Sideways,
        Self::Translation,
        Self::HalfTurn,
        Self::QuarterTurn,
        Self::Turntable,
        Self::Undistorted,
    ];

    /// Rotation R and translation t of a special motion, x2 = R x1 + t, where the points are
    /// [`DEPTH`] in front of the first camera; `None` for a general one.
    fn draw(self, random: &mut Random) -> Option<(Matrix3<f64>, Vector3<f64>)> {
        let identity = Matrix3::identity();
        Some(match self {
            Self::General | Self::Undistorted => return None,
            Self::Planar => {
                let (angle, way) = (uniform(random, -0.5, 0.5), uniform(random, 0.0, 2.0 * PI));
                (turn(Vector3::y(), angle), Vector3::new(way.sin(), 0.0, way.cos()))
            }
            Self::Forward => (identity, Vector3::z()),
            Self::Sideways => (identity, Vector3::x()),
            Self::Translation => (identity, in_ball(random)),
            Self::HalfTurn => (turn(Vector3::z(), PI), in_ball(random)),
            Self::QuarterTurn => (turn(Vector3::z(), 0.5 * PI), in_ball(random)),
            Self::Turntable => {
                let rotation = turn(Vector3::y(), uniform(random, 0.1, 0.6));
                (rotation, DEPTH * (Vector3::z() - rotation * Vector3::z()))
            }
        })
    }
}

/// The rotation about an axis of length 1.
pub(super) fn turn(axis: Vector3<f64>, angle: f64) -> Matrix3<f64> {
    Rotation3::new(axis * angle).into_inner()
}

/// The distance of the middle of the points from the first camera of a special motion.
pub(super) const DEPTH: f64 = 5.0;

/// Two cameras: rotation and translation from the first camera's coordinates to the second's, and
/// points in the first's. The optical axes of a general motion do not meet.
pub fn two_cameras(
    (random, motion): (&mut Random, Motion),
    points: usize,
) -> (Matrix3<f64>, Vector3<f64>, Vec<Vector3<f64>>) {
    if let Some((rotation, translation)) = motion.draw(random) {
        let points = (0..points).map(|_| in_ball(random) + DEPTH * Vector3::z()).collect();
        return (rotation, translation, points);
    }
    let ((r1, t1), (r2, t2)) = (camera(random), camera(random));
    let rotation = r2 * r1.transpose();
    let points = (0..points).map(|_| r1 * in_ball(random) + t1).collect();
    (rotation, t2 - rotation * t1, points)
}

/// Any turn about the vertical, the y axis.
pub fn upright(random: &mut Random) -> Matrix3<f64> {
    Rotation3::new(Vector3::y() * uniform(random, -PI, PI)).into_inner()
}

/// As [`two_cameras`], for upright cameras. Motions that do not leave a camera upright are replaced
/// by any turn about a vertical axis near the points.
pub fn upright_cameras(
    (random, motion): (&mut Random, Motion),
    points: usize,
) -> (Matrix3<f64>, Vector3<f64>, Vec<Vector3<f64>>) {
    if !matches!(motion, Motion::General | Motion::Undistorted | Motion::HalfTurn | Motion::QuarterTurn) {
        return two_cameras((random, motion), points);
    }
    let (rotation, middle) = (upright(random), DEPTH * Vector3::z());
    let points = (0..points).map(|_| in_ball(random) + middle).collect();
    (rotation, middle - rotation * middle + in_ball(random), points)
}

/// A uniform point of the unit ball, not at its very centre.
pub fn in_ball(random: &mut Random) -> Vector3<f64> {
    loop {
        let point = Vector3::from_fn(|_, _| random.symmetric_unit());
        if (0.01..1.0).contains(&point.norm()) {
            return point;
        }
    }
}

/// Image of a point in the camera's coordinates, the principal point at the origin.
pub fn image(point: &Vector3<f64>, focal: f64) -> Vector2<f64> {
    focal * point.xy() / point.z
}

/// The d with d / (1 + radial |d|^2) = point, the division model; `radial` is not positive.
pub fn distorted(point: Vector2<f64>, radial: f64) -> Vector2<f64> {
    point * (2.0 / (1.0 + (1.0 - 4.0 * radial * point.norm_squared()).sqrt()))
}

/// The unit quaternion (w, x, y, z) of a rotation, w >= 0.
pub(super) fn quaternion(rotation: &Matrix3<f64>) -> [f64; 4] {
    let q = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(*rotation));
    let sign = if q.w < 0.0 { -1.0 } else { 1.0 };
    [q.w, q.i, q.j, q.k].map(|x| sign * x)
}

/// The rotation to the frame in which problems in a chart of the rotations are solved, that of the
/// quaternion (23, 14, 3, 19).
pub(super) fn frame() -> Matrix3<f64> {
    let quaternion = Quaternion::new(23.0, 14.0, 3.0, 19.0);
    UnitQuaternion::from_quaternion(quaternion).to_rotation_matrix().into_inner()
}

/// The Cayley parameters of a rotation, which is not a half turn.
pub(super) fn cayley(rotation: &Matrix3<f64>) -> Vec<f64> {
    let [w, x, y, z] = quaternion(rotation);
    vec![x / w, y / w, z / w]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_in_front_of_both_cameras() {
        let mut random = Random::new(1);
        for motion in (0..200).flat_map(|_| Motion::ALL) {
            let (rotation, translation, points) = two_cameras((&mut random, motion), 6);
            assert!((rotation.determinant() - 1.0).abs() < 1e-12);
            assert!((rotation * rotation.transpose() - Matrix3::identity()).norm() < 1e-12);
            for point in points {
                assert!(point.z > 0.0 && (rotation * point + translation).z > 0.0);
            }
            let (rotation, translation, points) = upright_cameras((&mut random, motion), 3);
            assert!((rotation * Vector3::y() - Vector3::y()).norm() < 1e-15);
            assert!(points.iter().all(|point| point.z > 0.0 && (rotation * point + translation).z > 0.0));
        }
    }

    #[test]
    fn distorted_points_are_undistorted_by_the_division_model() {
        let mut random = Random::new(4);
        for _ in 0..1000 {
            let point = Vector2::from_fn(|_, _| random.symmetric_unit());
            let radial = -uniform(&mut random, 0.0, 1.0);
            let d = distorted(point, radial);
            assert!((d / (1.0 + radial * d.norm_squared()) - point).norm() < 1e-14);
        }
    }

    #[test]
    fn quaternions_give_back_their_rotations() {
        let mut random = Random::new(5);
        for _ in 0..1000 {
            let (rotation, _) = camera(&mut random);
            let [w, x, y, z] = quaternion(&rotation);
            let again = UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z)).to_rotation_matrix();
            assert!(w >= 0.0 && (again.matrix() - rotation).norm() < 1e-12);
        }
    }
}
