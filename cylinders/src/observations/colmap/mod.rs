//! Models of the structure-from-motion program COLMAP: a folder with `cameras`, `images` and
//! `points3D`, all text (`.txt`) or all binary (`.bin`, little-endian). If a folder has both, the
//! binary files are read, as COLMAP does.
//!
//! ```text
//!   camera        id, model, width, height, parameters (f or fx fy, cx cy, distortion)
//!   image         id, pose (qw qx qy qz tx ty tz, world to camera), camera id, name,
//!                 observed points
//!   point         id, position, colour, error, track
//! ```
//!
//! The reader takes the cameras of the images and the positions of the points. `points3D` may be
//! missing. All camera models but that of panoramas are supported (`camera.rs`). The pixel
//! coordinates (0, 0) are the upper left *corner* of an image, so the centre of its first pixel is
//! at (0.5, 0.5). Segments must use the same coordinates, or be moved
//! ([`Segments::with_pixel_origin`](super::segments::Segments::with_pixel_origin)).
//!
//! A truncated file is refused. In a binary file every count is checked against the remaining bytes
//! before memory is allocated. A text file gives its number of records in a comment, which COLMAP
//! always writes. In a file without that comment, missing records at the end cannot be noticed.

/// Binary files to records.
mod binary;
/// Camera models to calibration and distortion.
mod camera;
/// Errors of a model, with their places in the files.
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

/// How the files of a model are written.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Encoding {
    /// `.txt`
    Text,
    /// `.bin`
    Binary,
}

impl Encoding {
    /// Names of the files of cameras, images and points.
    pub fn file_names(self) -> [&'static str; 3] {
        match self {
            Self::Text => ["cameras.txt", "images.txt", "points3D.txt"],
            Self::Binary => ["cameras.bin", "images.bin", "points3D.bin"],
        }
    }

    /// A file of no points.
    fn without_points(self) -> &'static [u8] {
        match self {
            Self::Text => &[],
            Self::Binary => &[0; 8],
        }
    }
}

/// Reads the model in a folder.
///
/// # Errors
/// [`ColmapError`].
pub fn read_colmap(folder: &Path) -> Result<Model, ColmapError> {
    let is_binary = folder.join("cameras.bin").exists();
    let encoding = if is_binary { Encoding::Binary } else { Encoding::Text };
    let read = |name: &str| {
        let path = folder.join(name);
        let file = path.display().to_string();
        match fs::read(&path) {
            Ok(bytes) => Ok((file, bytes)),
            Err(source) => Err(ColmapError::Read { file, source }),
        }
    };
    let [cameras, images, points] = encoding.file_names();
    let no_points = || (points.to_owned(), encoding.without_points().to_vec());
    let points = if folder.join(points).exists() { read(points)? } else { no_points() };
    let files = [read(cameras)?, read(images)?, points];
    parse_colmap(encoding, files.each_ref().map(|(name, content)| (name.as_str(), content.as_slice())))
}

/// Parses the files of cameras, images and points: the name that error messages carry, and the
/// content of each.
///
/// # Errors
/// [`ColmapError`], except [`ColmapError::Read`].
pub fn parse_colmap(encoding: Encoding, files: [(&str, &[u8]); 3]) -> Result<Model, ColmapError> {
    let [cameras, images, points] = files;
    let (cameras, images, points) = match encoding {
        Encoding::Text => (text::cameras(cameras)?, text::images(images)?, text::points(points)?),
        Encoding::Binary => (binary::cameras(cameras)?, binary::images(images)?, binary::points(points)?),
    };
    if images.is_empty() {
        return Err(ColmapError::NoImages { file: files[1].0.to_owned() });
    }
    Ok(Model { photographs: record::photographs(&cameras, images)?, points })
}
