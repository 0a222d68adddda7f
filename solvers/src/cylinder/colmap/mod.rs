//! Models of the structure-from-motion program COLMAP: a folder with `cameras`, `images` and `points3D`, all text (`.txt`) or
//! all binary (`.bin`, little-endian). Where there are both, the binary files are read, as COLMAP does.
//!
//! ```text
//!   camera        id, model, width, height, parameters (f or fx fy, cx cy, distortion)
//!   image         id, pose (qw qx qy qz tx ty tz, world to camera), camera id, name, observed points
//!   point         id, position, colour, error, track
//! ```
//!
//! Read are the cameras of the images and the positions of the points. Pixel (0, 0) is the upper left *corner* of an image,
//! so the centre of its first pixel is at (0.5, 0.5); segments have to follow that.
//!
//! A file that is cut short is refused. In a binary file every count is checked against the bytes that follow before
//! anything is made of it. A text file tells how many records it has in a comment, which COLMAP always writes; in a file
//! written by hand without that comment, records missing at the end cannot be noticed.

/// Binary files to records.
mod binary;
/// Camera models to calibration and distortion.
mod camera;
/// What is wrong with a model, and where.
mod error;
/// Records of cameras and images to photographs.
mod record;
/// Text files to records.
mod text;

use std::fs;
use std::path::Path;

use nalgebra::Point3;

use super::photograph::Photograph;

pub use error::{ColmapError, Location};

/// The photographs and points of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    /// The images with their cameras, in the order of the file.
    pub photographs: Vec<Photograph>,
    /// The points, world frame, in the order of the file.
    pub points: Vec<Point3<f64>>,
}

/// Reads the model in a folder.
///
/// # Errors
/// [`ColmapError`].
pub fn read_colmap(folder: &Path) -> Result<Model, ColmapError> {
    let read = |name: &str| {
        let path = folder.join(name);
        let file = path.display().to_string();
        match fs::read(&path) {
            Ok(bytes) => Ok((bytes, file)),
            Err(source) => Err(ColmapError::Read { file, source }),
        }
    };
    let (cameras, images, points) = if folder.join("cameras.bin").exists() {
        let [cameras, images, points] = [read("cameras.bin")?, read("images.bin")?, read("points3D.bin")?];
        (
            binary::cameras(&cameras.0, &cameras.1)?,
            binary::images(&images.0, &images.1)?,
            binary::points(&points.0, &points.1)?,
        )
    } else {
        let [cameras, images, points] = [read("cameras.txt")?, read("images.txt")?, read("points3D.txt")?];
        (
            text::cameras(&cameras.0, &cameras.1)?,
            text::images(&images.0, &images.1)?,
            text::points(&points.0, &points.1)?,
        )
    };
    Ok(Model { photographs: record::photographs(&cameras, images)?, points })
}
