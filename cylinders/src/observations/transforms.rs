//! Cameras in `transforms.json`, as instant-ngp and nerfstudio write and read them:
//!
//! ```json
//! {
//!   "fl_x": 3000, "fl_y": 3000, "cx": 2000, "cy": 1500, "w": 4000, "h": 3000,
//!   "k1": -0.1, "k2": 0.02, "p1": 0.001, "p2": -0.001,
//!   "frames": [
//!     {
//!       "file_path": "images/left.jpg",
//!       "transform_matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 5], [0, 0, 0, 1]]
//!     }
//!   ]
//! }
//! ```
//!
//! - `transform_matrix`: camera to world, in the axes of OpenGL: x to the right, y up, and the
//!   camera looks along -z. A scale of its rotation is removed.
//! - `fl_x`, `fl_y`: focal lengths, pixels; or `camera_angle_x`, `camera_angle_y`: fields of view,
//!   radians, which need `w`, `h`. One direction stands for the other. `cx`, `cy`: principal point,
//!   by default the middle of the image. A frame may have its own values of all of these.
//! - `camera_model`: `OPENCV` (the default), `PINHOLE`, `SIMPLE_PINHOLE`, `OPENCV_FISHEYE`; with
//!   `is_fisheye: true` the latter. Coefficients `k1` .. `k4`, `p1`, `p2`, by default zero:
//!   `OPENCV` takes `k1` to `k3` and refuses another `k4` than zero, since its meaning differs
//!   between programs; the fisheye takes `k1` to `k4`.
//! - `file_path`: the name of the image in segments.
//!
//! The pixel coordinates (0, 0) are the upper left corner of an image, as in COLMAP.

use std::fs;
use std::path::Path;

use nalgebra::{Matrix3, Matrix3x4, Matrix4, Vector3};
use serde::Deserialize;
use thiserror::Error;

use super::colmap::Model;
use super::distortion::{Distortion, Projection};
use super::photograph::Photograph;
use super::view::{Calibration, Camera, ViewError};

/// Errors of a file of transforms. Every message starts with the file and the place in it.
#[derive(Debug, Error)]
pub enum TransformsError {
    /// The file cannot be read.
    #[error("{file}: {source}")]
    Read {
        /// File name.
        file: String,
        /// Reason.
        source: std::io::Error,
    },
    /// The text is not JSON, or a key is missing or of another type.
    #[error("{file}: {message}; expected is the transforms.json of instant-ngp or nerfstudio")]
    NotTransforms {
        /// File name.
        file: String,
        /// Message of the parser, with line and column.
        message: String,
    },
    /// There are no frames.
    #[error("{file}: `frames` is empty: there are no images")]
    NoFrames {
        /// File name.
        file: String,
    },
    /// A frame lacks something, or has something that is not supported.
    #[error("{file}: frames[{frame}] ({image}): {what}")]
    Frame {
        /// File name.
        file: String,
        /// Index of the frame.
        frame: usize,
        /// Its image.
        image: String,
        /// What is missing or not supported, and what was expected.
        what: String,
    },
    /// A camera or its calibration is not valid.
    #[error("{file}: frames[{frame}] ({image}): {source}")]
    Invalid {
        /// File name.
        file: String,
        /// Index of the frame.
        frame: usize,
        /// Its image.
        image: String,
        /// Reason.
        source: ViewError,
    },
}

/// What the file gives for all frames, and a frame for itself.
#[derive(Clone, Debug, Default, Deserialize)]
struct Intrinsics {
    camera_model: Option<String>,
    is_fisheye: Option<bool>,
    camera_angle_x: Option<f64>,
    camera_angle_y: Option<f64>,
    fl_x: Option<f64>,
    fl_y: Option<f64>,
    cx: Option<f64>,
    cy: Option<f64>,
    w: Option<f64>,
    h: Option<f64>,
    k1: Option<f64>,
    k2: Option<f64>,
    k3: Option<f64>,
    k4: Option<f64>,
    p1: Option<f64>,
    p2: Option<f64>,
}

#[derive(Deserialize)]
struct File {
    #[serde(flatten)]
    intrinsics: Intrinsics,
    frames: Vec<Frame>,
}

#[derive(Deserialize)]
struct Frame {
    file_path: String,
    transform_matrix: [[f64; 4]; 4],
    #[serde(flatten)]
    intrinsics: Intrinsics,
}

/// Reads a file of transforms. The model has no points.
///
/// # Errors
/// [`TransformsError`].
pub fn read_transforms(path: &Path) -> Result<Model, TransformsError> {
    let file = path.display().to_string();
    match fs::read_to_string(path) {
        Ok(text) => parse_transforms(&text, &file),
        Err(source) => Err(TransformsError::Read { file, source }),
    }
}

/// Parses the text of a file of transforms; `file` is the name that error messages carry.
///
/// # Errors
/// [`TransformsError`], except [`TransformsError::Read`].
pub fn parse_transforms(text: &str, file: &str) -> Result<Model, TransformsError> {
    let not_transforms =
        |error: serde_json::Error| TransformsError::NotTransforms { file: file.to_owned(), message: error.to_string() };
    let read: File = serde_json::from_str(text).map_err(not_transforms)?;
    if read.frames.is_empty() {
        return Err(TransformsError::NoFrames { file: file.to_owned() });
    }
    let photograph = |(index, frame): (usize, Frame)| {
        let image = frame.file_path.clone();
        let failure =
            |what: String| TransformsError::Frame { file: file.to_owned(), frame: index, image: image.clone(), what };
        let invalid =
            |source| TransformsError::Invalid { file: file.to_owned(), frame: index, image: image.clone(), source };
        let intrinsics = frame.intrinsics.or(&read.intrinsics);
        let matrix = intrinsics.matrix().map_err(failure)?;
        let distortion = intrinsics.distortion().map_err(failure)?;
        let camera = camera(&frame.transform_matrix).map_err(invalid)?;
        let calibration = Calibration::new(&matrix).map_err(invalid)?;
        if !distortion.is_defined() {
            return Err(invalid(ViewError::NotADistortion));
        }
        Ok(Photograph { name: image.clone(), camera: camera.with_calibration(calibration), distortion })
    };
    let photographs = read.frames.into_iter().enumerate().map(photograph).collect::<Result<_, _>>()?;
    Ok(Model { photographs, points: Vec::new() })
}

/// The camera of a matrix from the camera, in the axes of OpenGL, to the world.
fn camera(rows: &[[f64; 4]; 4]) -> Result<Camera, ViewError> {
    let to_world = Matrix4::from_fn(|row, column| rows[row][column]);
    let rotation = to_world.fixed_view::<3, 3>(0, 0) * Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, -1.0));
    let centre = to_world.fixed_view::<3, 1>(0, 3).clone_owned();
    // The scale of a rotation is the norm of its columns.
    let inverse = rotation.transpose() / (rotation.norm_squared() / 3.0).sqrt();
    let mut matrix = Matrix3x4::zeros();
    matrix.fixed_columns_mut::<3>(0).copy_from(&inverse);
    matrix.set_column(3, &(-inverse * centre));
    let camera = Camera::from_normalised(&matrix)?;
    // A negative multiple of a camera is one; a mirrored transform is not.
    if camera.is_negated() { Err(ViewError::NotARotation { deviation: 2.0 }) } else { Ok(camera) }
}

impl Intrinsics {
    /// The values of the frame, and where it has none those of the file.
    fn or(self, all: &Self) -> Self {
        Self {
            camera_model: self.camera_model.or_else(|| all.camera_model.clone()),
            is_fisheye: self.is_fisheye.or(all.is_fisheye),
            camera_angle_x: self.camera_angle_x.or(all.camera_angle_x),
            camera_angle_y: self.camera_angle_y.or(all.camera_angle_y),
            fl_x: self.fl_x.or(all.fl_x),
            fl_y: self.fl_y.or(all.fl_y),
            cx: self.cx.or(all.cx),
            cy: self.cy.or(all.cy),
            w: self.w.or(all.w),
            h: self.h.or(all.h),
            k1: self.k1.or(all.k1),
            k2: self.k2.or(all.k2),
            k3: self.k3.or(all.k3),
            k4: self.k4.or(all.k4),
            p1: self.p1.or(all.p1),
            p2: self.p2.or(all.p2),
        }
    }

    fn matrix(&self) -> Result<Matrix3<f64>, String> {
        let by_angle = |angle: Option<f64>, side: Option<f64>| Some(side? / (2.0 * (angle? / 2.0).tan()));
        let fx = self.fl_x.or_else(|| by_angle(self.camera_angle_x, self.w));
        let fy = self.fl_y.or_else(|| by_angle(self.camera_angle_y, self.h));
        let (Some(fx), Some(fy)) = (fx.or(fy), fy.or(fx)) else {
            return Err("no focal length: `fl_x` is needed, or `camera_angle_x` with `w`".to_owned());
        };
        let centre = |given: Option<f64>, side: Option<f64>| given.or_else(|| side.map(|side| side / 2.0));
        let (Some(cx), Some(cy)) = (centre(self.cx, self.w), centre(self.cy, self.h)) else {
            return Err("no principal point: `cx` and `cy` are needed, or `w` and `h`".to_owned());
        };
        Ok(Matrix3::new(fx, 0.0, cx, 0.0, fy, cy, 0.0, 0.0, 1.0))
    }

    fn distortion(&self) -> Result<Distortion, String> {
        let [k1, k2, k3, k4] = [self.k1, self.k2, self.k3, self.k4].map(Option::unwrap_or_default);
        let tangential = [self.p1, self.p2].map(Option::unwrap_or_default);
        let named = self.camera_model.as_deref().unwrap_or("OPENCV");
        match if self.is_fisheye == Some(true) { "OPENCV_FISHEYE" } else { named } {
            "SIMPLE_PINHOLE" | "PINHOLE" => Ok(Distortion::default()),
            "OPENCV" if k4 == 0.0 => {
                Ok(Distortion { radial: [k1, k2, k3, 0.0, 0.0, 0.0], ..Distortion::polynomial([0.0; 2], tangential) })
            }
            "OPENCV" => {
                Err(format!("`k4` is {k4}: with the model OPENCV its meaning differs between programs; expected is 0"))
            }
            "OPENCV_FISHEYE" => Ok(Distortion {
                projection: Projection::Equidistant,
                radial: [k1, k2, k3, k4, 0.0, 0.0],
                ..Distortion::default()
            }),
            other => Err(format!("the camera model {other} is not supported; PINHOLE, OPENCV and OPENCV_FISHEYE are")),
        }
    }
}
