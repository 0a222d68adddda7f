//! Cameras of Bundler, `bundle.out` of version 0.3, with the list of its images:
//!
//! ```text
//!   # Bundle file v0.3
//!   CAMERAS POINTS
//!   f k1 k2          for each camera: focal length, pixels, radial distortion; f = 0: not found
//!   R                three rows, world to camera
//!   t
//!   X Y Z            for each point: position,
//!   R G B            colour,
//!   VIEWS (..)..     and where it is seen
//! ```
//!
//! The camera looks along -z, and pixels are counted from the middle of the image to the right and
//! up. This reader changes both to the axes of COLMAP, z forward and y down from the upper left
//! corner, for which it needs the sizes of the images. Segments are in pixels from that corner.
//!
//! The list has one line for each camera: the name of its image, and perhaps width and height of
//! the image, pixels. Other fields, such as the `0 FOCAL` of Bundler's own lists, are ignored.
//! Images without sizes have one size in common.

use std::fs;
use std::path::Path;
use std::str::FromStr;

use nalgebra::{Matrix3, Matrix3x4, Point3, Vector3};
use thiserror::Error;

use super::colmap::Model;
use super::distortion::Distortion;
use super::photograph::Photograph;
use super::view::{Calibration, Camera, ViewError};

/// Errors of the files of Bundler. Every message starts with the file and the line in it.
#[derive(Debug, Error)]
pub enum BundlerError {
    /// A file cannot be read.
    #[error("{file}: {source}")]
    Read {
        /// File name.
        file: String,
        /// Reason.
        source: std::io::Error,
    },
    /// The first line is not that of version 0.3.
    #[error("{file}:1: the first line should be `# Bundle file v0.3`, not `{found}`")]
    Version {
        /// File name.
        file: String,
        /// The first line.
        found: String,
    },
    /// A field is missing or malformed.
    #[error("{file}:{line}: {field} should be a finite number, not `{found}`")]
    Field {
        /// File name.
        file: String,
        /// Line, from 1.
        line: usize,
        /// Name of the field.
        field: &'static str,
        /// What was found; empty at the end of the file.
        found: String,
    },
    /// The list has another number of images than there are cameras.
    #[error("{file}: {images} images for {cameras} cameras; expected is one line for each camera")]
    ImageCount {
        /// Name of the list.
        file: String,
        /// Lines of the list.
        images: usize,
        /// Number of cameras.
        cameras: usize,
    },
    /// The size of an image is not known.
    #[error("{file}:{line}: the size of `{image}` is not known; hint: give it in the list, or with --image-size")]
    NoSize {
        /// Name of the list.
        file: String,
        /// Line, from 1.
        line: usize,
        /// Name of the image.
        image: String,
    },
    /// A camera is not valid.
    #[error("{file}: camera {camera}: {source}")]
    Invalid {
        /// File name.
        file: String,
        /// Index of the camera, from 0.
        camera: usize,
        /// Reason.
        source: ViewError,
    },
}

/// Reads the files. Images whose camera was not found are left out. `size` is the width and height
/// of images for which the list has none.
///
/// # Errors
/// [`BundlerError`].
pub fn read_bundler(bundle: &Path, list: &Path, size: Option<[f64; 2]>) -> Result<Model, BundlerError> {
    let read = |path: &Path| {
        let file = path.display().to_string();
        match fs::read_to_string(path) {
            Ok(text) => Ok((file, text)),
            Err(source) => Err(BundlerError::Read { file, source }),
        }
    };
    let (bundle, list) = (read(bundle)?, read(list)?);
    parse_bundler((&bundle.0, &bundle.1), (&list.0, &list.1), size)
}

/// Parses the texts; each comes with the name that error messages carry.
///
/// # Errors
/// [`BundlerError`], except [`BundlerError::Read`].
pub fn parse_bundler(
    (file, text): (&str, &str),
    (list_file, list): (&str, &str),
    size: Option<[f64; 2]>,
) -> Result<Model, BundlerError> {
    let first = text.lines().next().unwrap_or_default();
    if !(first.starts_with('#') && first.contains("v0.3")) {
        return Err(BundlerError::Version { file: file.to_owned(), found: first.to_owned() });
    }
    let mut fields = Fields::new(file, text);
    let (cameras, points): (usize, usize) =
        (fields.next("the number of cameras")?, fields.next("the number of points")?);
    let images: Vec<_> = list.lines().enumerate().filter(|(_, line)| !line.trim().is_empty()).collect();
    if images.len() != cameras {
        return Err(BundlerError::ImageCount { file: list_file.to_owned(), images: images.len(), cameras });
    }
    let mut photographs = Vec::new();
    for (camera, (index, line)) in images.into_iter().enumerate() {
        let [f, k1, k2] = fields.numbers("the focal length or distortion")?;
        let rotation: [f64; 9] = fields.numbers("the rotation")?;
        let translation: [f64; 3] = fields.numbers("the translation")?;
        if f == 0.0 {
            continue;
        }
        let listed: Vec<_> = line.split_whitespace().collect();
        let side = |text: &str| text.parse().ok().filter(|side: &f64| *side > 0.0 && side.is_finite());
        let sides = match listed[..] {
            [_, width, height] => side(width).zip(side(height)).map(|(width, height)| [width, height]),
            _ => None,
        };
        let (name, sides) = (listed[0], sides.or(size));
        let (file, line, image) = (list_file.to_owned(), index + 1, name.to_owned());
        let Some(size) = sides else { return Err(BundlerError::NoSize { file, line, image }) };
        let found = photograph(name, [f, k1, k2], &rotation, translation, size);
        let invalid = |source| BundlerError::Invalid { file: fields.file.to_owned(), camera, source };
        photographs.push(found.map_err(invalid)?);
    }
    let mut positions = Vec::new();
    for _ in 0..points {
        positions.push(Point3::from(Vector3::from(fields.numbers("a coordinate of a point")?)));
        fields.numbers::<3>("a colour")?;
        let views: usize = fields.next("the number of views of a point")?;
        for _ in 0..views {
            fields.numbers::<4>("a view of a point")?;
        }
    }
    Ok(Model { photographs, points: positions })
}

fn photograph(
    name: &str,
    [focal, k1, k2]: [f64; 3],
    rotation: &[f64; 9],
    translation: [f64; 3],
    [width, height]: [f64; 2],
) -> Result<Photograph, ViewError> {
    // To the axes of COLMAP: half a turn about x. Radial distortion is the same in both.
    let turn = Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, -1.0));
    let mut matrix = Matrix3x4::zeros();
    matrix.fixed_columns_mut::<3>(0).copy_from(&(turn * Matrix3::from_row_slice(rotation)));
    matrix.set_column(3, &(turn * Vector3::from(translation)));
    let calibration =
        Calibration::new(&Matrix3::new(focal, 0.0, width / 2.0, 0.0, focal, height / 2.0, 0.0, 0.0, 1.0))?;
    let camera = Camera::from_normalised(&matrix)?.with_calibration(calibration);
    if camera.is_negated() {
        return Err(ViewError::NotARotation { deviation: 2.0 });
    }
    Ok(Photograph { name: name.to_owned(), camera, distortion: Distortion::polynomial([k1, k2], [0.0; 2]) })
}

/// The fields of a file after its first line, with the numbers of their lines.
struct Fields<'a> {
    file: &'a str,
    fields: Box<dyn Iterator<Item = (usize, &'a str)> + 'a>,
    /// Line of the last field.
    line: usize,
}

impl<'a> Fields<'a> {
    fn new(file: &'a str, text: &'a str) -> Self {
        let lines = text.lines().enumerate().skip(1);
        let fields = lines.flat_map(|(index, line)| line.split_whitespace().map(move |field| (index + 1, field)));
        Self { file, fields: Box::new(fields), line: 1 }
    }

    fn next<T: FromStr>(&mut self, field: &'static str) -> Result<T, BundlerError> {
        let found = self.fields.next();
        self.line = found.map_or(self.line, |(line, _)| line);
        let text = found.map_or("", |(_, text)| text);
        text.parse().map_err(|_| self.failure(field, text))
    }

    fn numbers<const COUNT: usize>(&mut self, field: &'static str) -> Result<[f64; COUNT], BundlerError> {
        let mut numbers = [0.0_f64; COUNT];
        for number in &mut numbers {
            *number = self.next(field)?;
            if !number.is_finite() {
                return Err(self.failure(field, &number.to_string()));
            }
        }
        Ok(numbers)
    }

    fn failure(&self, field: &'static str, found: &str) -> BundlerError {
        BundlerError::Field { file: self.file.to_owned(), line: self.line, field, found: found.to_owned() }
    }
}
