//! Camera models, by their numbers in binary files.
//!
//! | number | model | parameters |
//! |--:|---|---|
//! | 0 | `SIMPLE_PINHOLE` | f, cx, cy |
//! | 1 | `PINHOLE` | fx, fy, cx, cy |
//! | 2 | `SIMPLE_RADIAL` | f, cx, cy, k1 |
//! | 3 | `RADIAL` | f, cx, cy, k1, k2 |
//! | 4 | `OPENCV` | fx, fy, cx, cy, k1, k2, p1, p2 |
//! | 5 | `OPENCV_FISHEYE` | fx, fy, cx, cy, k1, k2, k3, k4 |
//! | 6 | `FULL_OPENCV` | fx, fy, cx, cy, k1, k2, p1, p2, k3, k4, k5, k6 |
//! | 7 | `FOV` | fx, fy, cx, cy, omega |
//! | 8 | `SIMPLE_RADIAL_FISHEYE` | f, cx, cy, k1 |
//! | 9 | `RADIAL_FISHEYE` | f, cx, cy, k1, k2 |
//! | 10 | `THIN_PRISM_FISHEYE` | fx, fy, cx, cy, k1, k2, p1, p2, k3, k4, sx1, sy1 |
//! | 11 | `RAD_TAN_THIN_PRISM_FISHEYE` | fx, fy, cx, cy, k0, .., k5, p0, p1, s0, s1, s2, s3 |
//! | 12 | `SIMPLE_DIVISION` | f, cx, cy, k |
//! | 13 | `DIVISION` | fx, fy, cx, cy, k |
//! | 14 | `SIMPLE_FISHEYE` | f, cx, cy |
//! | 15 | `FISHEYE` | fx, fy, cx, cy |
//! | 16 | `EUCM` | fx, fy, cx, cy, alpha, beta |
//!
//! `EQUIRECTANGULAR`, number 17, is a panorama: no plane shows all of it, so it is refused.

use nalgebra::Matrix3;

use crate::observations::distortion::{Distortion, Projection};
use crate::observations::view::{Calibration, ViewError};

/// Name and number of parameters of the supported models, by number.
const MODELS: [(&str, usize); 17] = [
    ("SIMPLE_PINHOLE", 3),
    ("PINHOLE", 4),
    ("SIMPLE_RADIAL", 4),
    ("RADIAL", 5),
    ("OPENCV", 8),
    ("OPENCV_FISHEYE", 8),
    ("FULL_OPENCV", 12),
    ("FOV", 5),
    ("SIMPLE_RADIAL_FISHEYE", 4),
    ("RADIAL_FISHEYE", 5),
    ("THIN_PRISM_FISHEYE", 12),
    ("RAD_TAN_THIN_PRISM_FISHEYE", 16),
    ("SIMPLE_DIVISION", 4),
    ("DIVISION", 5),
    ("SIMPLE_FISHEYE", 3),
    ("FISHEYE", 4),
    ("EUCM", 6),
];

/// Number of the model of panoramas.
const PANORAMA: (i32, &str) = (17, "EQUIRECTANGULAR");

/// A supported camera model: its index in [`MODELS`].
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(super) struct CameraModel(usize);

impl CameraModel {
    /// The model of this name, if it is supported.
    pub(super) fn from_name(name: &str) -> Option<Self> {
        MODELS.iter().position(|(known, _)| *known == name).map(Self)
    }

    /// The model of this number. If it is not supported, the error is its name, or its number if it
    /// has no known name.
    pub(super) fn from_number(number: i32) -> Result<Self, String> {
        match usize::try_from(number) {
            Ok(index) if index < MODELS.len() => Ok(Self(index)),
            _ if number == PANORAMA.0 => Err(PANORAMA.1.to_owned()),
            _ => Err(format!("number {number}")),
        }
    }

    pub(super) fn name(self) -> &'static str {
        MODELS[self.0].0
    }

    /// Number of parameters.
    pub(super) fn parameter_count(self) -> usize {
        MODELS[self.0].1
    }

    /// Calibration and distortion of a camera; `None` if the model has another number of
    /// parameters.
    pub(super) fn lens(self, parameters: &[f64]) -> Option<Result<(Calibration, Distortion), ViewError>> {
        if parameters.len() != self.parameter_count() {
            return None;
        }
        // The names tell which models have one focal length.
        let has_one_focal = self.name().starts_with("SIMPLE") || self.name().starts_with("RADIAL");
        let (focal, rest) = parameters.split_at(if has_one_focal { 1 } else { 2 });
        let (centre, coefficients) = rest.split_at(2);
        let distortion = self.distortion(coefficients);
        let (fx, fy) = (*focal.first()?, *focal.last()?);
        let matrix = Matrix3::new(fx, 0.0, centre[0], 0.0, fy, centre[1], 0.0, 0.0, 1.0);
        if !distortion.is_defined() {
            return Some(Err(ViewError::NotADistortion));
        }
        Some(Calibration::new(&matrix).map(|calibration| (calibration, distortion)))
    }

    /// The distortion; the coefficients are the parameters after the principal point.
    fn distortion(self, coefficients: &[f64]) -> Distortion {
        let plain = Distortion::default();
        let fisheye = Distortion { projection: Projection::Equidistant, ..plain };
        let radial = |given: &[f64]| std::array::from_fn(|index| given.get(index).copied().unwrap_or(0.0));
        match (self.name(), coefficients) {
            ("SIMPLE_RADIAL" | "RADIAL", given) => Distortion { radial: radial(given), ..plain },
            ("OPENCV", &[k1, k2, p1, p2]) => Distortion::polynomial([k1, k2], [p1, p2]),
            ("FULL_OPENCV", &[k1, k2, p1, p2, k3, k4, k5, k6]) => {
                Distortion { radial: radial(&[k1, k2, k3]), denominator: [k4, k5, k6], tangential: [p1, p2], ..plain }
            }
            ("FOV", &[omega]) => Distortion { projection: Projection::FieldOfView(omega), ..plain },
            ("SIMPLE_DIVISION" | "DIVISION", &[k]) => Distortion { projection: Projection::Division(k), ..plain },
            ("EUCM", &[alpha, beta]) => Distortion { projection: Projection::Unified(alpha, beta), ..plain },
            ("THIN_PRISM_FISHEYE", &[k1, k2, p1, p2, k3, k4, x1, y1]) => Distortion {
                radial: radial(&[k1, k2, k3, k4]),
                tangential: [p1, p2],
                prism: [x1, 0.0, y1, 0.0],
                ..fisheye
            },
            // Its first tangential coefficient belongs to x, that of OpenCV to y.
            ("RAD_TAN_THIN_PRISM_FISHEYE", &[k0, k1, k2, k3, k4, k5, p0, p1, s0, s1, s2, s3]) => Distortion {
                radial: [k0, k1, k2, k3, k4, k5],
                tangential: [p1, p0],
                prism: [s0, s1, s2, s3],
                radial_first: true,
                ..fisheye
            },
            (name, given) if name.contains("FISHEYE") => Distortion { radial: radial(given), ..fisheye },
            // The pinholes have no coefficients.
            _ => plain,
        }
    }
}
