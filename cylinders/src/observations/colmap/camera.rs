//! Camera models.
//!
//! | number | model | parameters |
//! |--:|---|---|
//! | 0 | `SIMPLE_PINHOLE` | f, cx, cy |
//! | 1 | `PINHOLE` | fx, fy, cx, cy |
//! | 2 | `SIMPLE_RADIAL` | f, cx, cy, k1 |
//! | 3 | `RADIAL` | f, cx, cy, k1, k2 |
//! | 4 | `OPENCV` | fx, fy, cx, cy, k1, k2, p1, p2 |

use nalgebra::Matrix3;

use crate::observations::distortion::Distortion;
use crate::observations::view::{Calibration, ViewError};

/// The names of the models with the numbers 0, 1, ... Models after the fifth are not supported.
const NAMES: [&str; 12] = [
    "SIMPLE_PINHOLE",
    "PINHOLE",
    "SIMPLE_RADIAL",
    "RADIAL",
    "OPENCV",
    "OPENCV_FISHEYE",
    "FULL_OPENCV",
    "FOV",
    "SIMPLE_RADIAL_FISHEYE",
    "RADIAL_FISHEYE",
    "THIN_PRISM_FISHEYE",
    "RAD_TAN_THIN_PRISM_FISHEYE",
];

/// A supported camera model.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(super) enum CameraModel {
    SimplePinhole,
    Pinhole,
    SimpleRadial,
    Radial,
    OpenCv,
}

use CameraModel::{OpenCv, Pinhole, Radial, SimplePinhole, SimpleRadial};

/// All supported models, by number.
const MODELS: [CameraModel; 5] = [SimplePinhole, Pinhole, SimpleRadial, Radial, OpenCv];

impl CameraModel {
    /// The model of this name, if it is supported.
    pub(super) fn from_name(name: &str) -> Option<Self> {
        MODELS.into_iter().find(|model| model.name() == name)
    }

    /// The model of this number. If it is not supported, the error is its name, or its number if it
    /// has no known name.
    pub(super) fn from_number(number: i32) -> Result<Self, String> {
        let index = usize::try_from(number).unwrap_or(usize::MAX);
        match MODELS.get(index) {
            Some(model) => Ok(*model),
            None => Err(NAMES.get(index).map_or(format!("number {number}"), |name| (*name).to_owned())),
        }
    }

    pub(super) fn name(self) -> &'static str {
        NAMES[self as usize]
    }

    /// Number of parameters.
    pub(super) fn parameter_count(self) -> usize {
        match self {
            SimplePinhole => 3,
            Pinhole | SimpleRadial => 4,
            Radial => 5,
            OpenCv => 8,
        }
    }

    /// Calibration and distortion of a camera; `None` if the model has another number of
    /// parameters.
    pub(super) fn lens(self, parameters: &[f64]) -> Option<Result<(Calibration, Distortion), ViewError>> {
        let none = [0.0, 0.0];
        let (focal, centre, radial, tangential) = match (self, parameters) {
            (SimplePinhole, &[f, cx, cy]) => ([f, f], [cx, cy], none, none),
            (Pinhole, &[fx, fy, cx, cy]) => ([fx, fy], [cx, cy], none, none),
            (SimpleRadial, &[f, cx, cy, k1]) => ([f, f], [cx, cy], [k1, 0.0], none),
            (Radial, &[f, cx, cy, k1, k2]) => ([f, f], [cx, cy], [k1, k2], none),
            (OpenCv, &[fx, fy, cx, cy, k1, k2, p1, p2]) => ([fx, fy], [cx, cy], [k1, k2], [p1, p2]),
            _ => return None,
        };
        let matrix = Matrix3::new(focal[0], 0.0, centre[0], 0.0, focal[1], centre[1], 0.0, 0.0, 1.0);
        let distortion = Distortion { radial, tangential };
        Some(Calibration::new(&matrix).map(|calibration| (calibration, distortion)))
    }
}
