//! How a camera of unknown pose sees points of known position.

use std::f64::consts::PI;

use eliminant_generator::algebra::Random;
use nalgebra::{Matrix3, Vector3};

use super::cameras::{DEPTH, camera, in_ball, turn};
use super::uniform;

/// Poses and targets. All but the first kind are those of users: their data have structure, so that
/// unknowns vanish, are equal or, in a chart of the rotations, infinite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum View {
    /// A camera anywhere, points anywhere.
    General,
    /// The axes of the camera are those of the points.
    Aligned,
    /// A half turn about the horizontal axis of the image.
    HalfTurnX,
    /// A half turn about the vertical axis of the image: the camera looks back.
    HalfTurnY,
    /// A half turn about the optical axis.
    HalfTurnZ,
    /// A quarter turn about the optical axis.
    QuarterTurn,
    /// Straight down, with any heading: a half turn about a horizontal axis.
    Down,
    /// The centre of the camera is the origin of the points.
    AtOrigin,
    /// The first point is on the optical axis.
    Centred,
    /// The points lie in a plane, seen from anywhere.
    Plane,
    /// The points lie in a plane that is parallel to the image.
    Frontal,
    /// The first points are the corners of a square, seen from anywhere.
    Square,
    /// The first points are the corners of a square around the optical axis, parallel to the image.
    SquareHeadOn,
    /// Without what a model adds to a camera with a pinhole: no distortion, no motion during the
    /// exposure, no error of the images. Otherwise as the first kind.
    Ideal,
}

/// Half the side of the square.
const HALF_SIDE: f64 = 0.5;

impl View {
    /// All kinds.
    pub const ALL: [Self; 14] = [
        Self::General,
        Self::Aligned,
        Self::HalfTurnX,
        Self::HalfTurnY,
        Self::HalfTurnZ,
        Self::QuarterTurn,
        Self::Down,
        Self::AtOrigin,
        Self::Centred,
        Self::Plane,
        Self::Frontal,
        Self::Square,
        Self::SquareHeadOn,
        Self::Ideal,
    ];

    /// Rotation and translation: x = rotation X + translation are the coordinates in the camera.
    pub fn camera(self, random: &mut Random) -> (Matrix3<f64>, Vector3<f64>) {
        let (rotation, translation) = match self.rotation(random) {
            Some(rotation) => (rotation, 0.5 * in_ball(random) + DEPTH * Vector3::z()),
            None => camera(random),
        };
        match self {
            Self::AtOrigin => (rotation, Vector3::zeros()),
            Self::SquareHeadOn => (rotation, translation.z * Vector3::z()),
            _ => (rotation, translation),
        }
    }

    /// The rotation of a special kind.
    pub(super) fn rotation(self, random: &mut Random) -> Option<Matrix3<f64>> {
        Some(match self {
            Self::Aligned | Self::SquareHeadOn => Matrix3::identity(),
            Self::HalfTurnX => Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, -1.0)),
            Self::HalfTurnY => Matrix3::from_diagonal(&Vector3::new(-1.0, 1.0, -1.0)),
            Self::HalfTurnZ => Matrix3::from_diagonal(&Vector3::new(-1.0, -1.0, 1.0)),
            Self::QuarterTurn => Matrix3::new(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0),
            Self::Down => {
                let (s, c) = uniform(random, -PI, PI).sin_cos();
                Matrix3::new(c, s, 0.0, s, -c, 0.0, 0.0, 0.0, -1.0)
            }
            Self::Frontal => turn(Vector3::z(), uniform(random, -PI, PI)),
            _ => return None,
        })
    }

    /// Sine and cosine of the angle of a camera that is turned about one known axis only.
    pub fn turn(self, random: &mut Random) -> (f64, f64) {
        match self {
            Self::Aligned | Self::SquareHeadOn | Self::Frontal => (0.0, 1.0),
            Self::HalfTurnX | Self::HalfTurnY | Self::Down => (0.0, -1.0),
            Self::QuarterTurn => (1.0, 0.0),
            _ => uniform(random, -PI, PI).sin_cos(),
        }
    }

    /// So many points that a camera sees.
    pub fn points(self, random: &mut Random, pose: &(Matrix3<f64>, Vector3<f64>), count: usize) -> Vec<Vector3<f64>> {
        (0..count).map(|k| self.point(random, pose, k)).collect()
    }

    /// Point k.
    pub fn point(
        self,
        random: &mut Random,
        (rotation, translation): &(Matrix3<f64>, Vector3<f64>),
        k: usize,
    ) -> Vector3<f64> {
        let point = in_ball(random);
        match self {
            Self::AtOrigin => rotation.transpose() * (point + DEPTH * Vector3::z()),
            Self::Centred if k == 0 => {
                let depth = (rotation * point + translation).z;
                rotation.transpose() * (depth * Vector3::z() - translation)
            }
            Self::Plane | Self::Frontal => point.xy().push(0.0),
            Self::Square | Self::SquareHeadOn => {
                let corner = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].get(k);
                corner.map_or(point.xy().push(0.0), |&(x, y)| HALF_SIDE * Vector3::new(x, y, 0.0))
            }
            _ => point,
        }
    }
}
