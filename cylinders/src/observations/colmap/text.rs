//! Text files: one line for each record, two lines for an image. Fields are separated by blanks,
//! and lines that start with `#` are comments.
//!
//! ```text
//!   cameras.txt    CAMERA_ID MODEL WIDTH HEIGHT PARAMETERS..
//!   images.txt     IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME
//!                  (X Y POINT3D_ID)..                               perhaps empty
//!   points3D.txt   POINT3D_ID X Y Z R G B ERROR (IMAGE_ID POINT2D_IDX)..
//! ```
//!
//! One of the comments that COLMAP writes, such as `# Number of cameras: 2`, gives the number of
//! records. With this comment, the file is complete if it has this number of records and its last
//! line ends with a line break.

use std::str::FromStr;

use nalgebra::Point3;

use super::camera::CameraModel;
use super::error::{ColmapError, Location};
use super::record::{CameraRecord, ImageRecord};

/// The cameras of `cameras.txt`.
pub(super) fn cameras((file, bytes): (&str, &[u8])) -> Result<Vec<CameraRecord>, ColmapError> {
    Lines::new(bytes, file, "cameras")?.records(|line, _| {
        let mut fields = line.fields();
        let id = fields.next("the id of the camera", "a number")?;
        let model: String = fields.next("the camera model", "a name")?;
        let at = line.location();
        let Some(model) = CameraModel::from_name(&model) else {
            return Err(ColmapError::UnsupportedModel { at, camera: id, model });
        };
        for side in ["the width", "the height"] {
            fields.next::<u64>(side, "a number of pixels")?;
        }
        let mut parameters = Vec::new();
        while !fields.is_empty() {
            parameters.push(fields.next("a parameter of the camera", "a number")?);
        }
        Ok(CameraRecord { at, id, model, parameters })
    })
}

/// The images of `images.txt`.
pub(super) fn images((file, bytes): (&str, &[u8])) -> Result<Vec<ImageRecord>, ColmapError> {
    Lines::new(bytes, file, "images")?.records(|line, rest| {
        let mut fields = line.fields();
        let id = fields.next("the id of the image", "a number")?;
        let mut number = |field| fields.next(field, "a number");
        let quaternion = [number("QW")?, number("QX")?, number("QY")?, number("QZ")?];
        let translation = [number("TX")?, number("TY")?, number("TZ")?];
        let camera = fields.next("the id of the camera", "a number")?;
        // The name extends to the end of the line, because names may contain blanks.
        let name = fields.rest.to_owned();
        let at = line.location();
        if name.is_empty() {
            return Err(ColmapError::CutShort { at, record: format!("image {id}, before its name") });
        }
        let Some(observations) = rest.next() else {
            return Err(ColmapError::CutShort { at, record: format!("image {id}, before the line of its points") });
        };
        let found = observations.text.split_whitespace().count();
        match found % 3 {
            0 => Ok(ImageRecord { at, id, quaternion, translation, camera, name }),
            _ => Err(ColmapError::FieldCount {
                at: observations.location(),
                expected: "the points of an image have three each, in a line of their own that may be empty",
                found,
            }),
        }
    })
}

/// The points of `points3D.txt`.
pub(super) fn points((file, bytes): (&str, &[u8])) -> Result<Vec<Point3<f64>>, ColmapError> {
    Lines::new(bytes, file, "points")?.records(|line, _| {
        let found = line.text.split_whitespace().count();
        if found < 8 || found % 2 != 0 {
            let expected = "a point has eight, and two more for each image that shows it";
            return Err(ColmapError::FieldCount { at: line.location(), expected, found });
        }
        let mut fields = line.fields();
        let id: u64 = fields.next("the id of the point", "a number")?;
        let mut number = |field| fields.next(field, "a number");
        let position: [f64; 3] = [number("X")?, number("Y")?, number("Z")?];
        if !position.iter().all(|coordinate| coordinate.is_finite()) {
            let what = "a coordinate that is not a finite number";
            return Err(ColmapError::Value { at: line.location(), record: format!("point {id}"), what });
        }
        Ok(Point3::from(position))
    })
}

/// A line, without its break.
#[derive(Clone, Copy)]
struct Line<'a> {
    file: &'a str,
    number: usize,
    text: &'a str,
}

impl<'a> Line<'a> {
    fn location(&self) -> Location {
        Location::Line { file: self.file.to_owned(), line: self.number }
    }

    fn fields(&self) -> Fields<'a> {
        Fields { line: *self, rest: self.text.trim() }
    }
}

/// The remaining fields of a line.
struct Fields<'a> {
    line: Line<'a>,
    /// The rest of the line without surrounding blanks.
    rest: &'a str,
}

impl Fields<'_> {
    fn is_empty(&self) -> bool {
        self.rest.is_empty()
    }

    fn next<T: FromStr>(&mut self, field: &'static str, expected: &'static str) -> Result<T, ColmapError> {
        let (found, rest) = self.rest.split_once(char::is_whitespace).unwrap_or((self.rest, ""));
        self.rest = rest.trim_start();
        match found.parse() {
            Ok(value) if !found.is_empty() => Ok(value),
            _ => Err(ColmapError::Field { at: self.line.location(), field, expected, found: found.to_owned() }),
        }
    }
}

/// The lines of a file.
struct Lines<'a> {
    lines: std::iter::Enumerate<std::str::Lines<'a>>,
    file: &'a str,
    /// What the records are, such as cameras.
    records: &'static str,
    /// Whether the last line has a line break.
    ends_with_break: bool,
}

impl<'a> Iterator for Lines<'a> {
    type Item = Line<'a>;

    fn next(&mut self) -> Option<Line<'a>> {
        self.lines.next().map(|(index, text)| Line { file: self.file, number: index + 1, text })
    }
}

impl<'a> Lines<'a> {
    fn new(bytes: &'a [u8], file: &'a str, records: &'static str) -> Result<Self, ColmapError> {
        match std::str::from_utf8(bytes) {
            Ok(text) => {
                Ok(Self { lines: text.lines().enumerate(), file, records, ends_with_break: text.ends_with('\n') })
            }
            Err(error) => {
                let line = 1 + bytes[..error.valid_up_to()].iter().filter(|&&byte| byte == b'\n').count();
                Err(ColmapError::NotUtf8 { at: Location::Line { file: file.to_owned(), line } })
            }
        }
    }

    /// All records. `read` gets the first line of a record, and the lines after it if it needs
    /// more.
    fn records<T>(
        mut self,
        mut read: impl FnMut(&Line<'a>, &mut Self) -> Result<T, ColmapError>,
    ) -> Result<Vec<T>, ColmapError> {
        let mut records = Vec::new();
        let mut announced = None;
        let mut last = None;
        while let Some(line) = self.next() {
            if line.text.trim_start().starts_with('#') {
                announced = announced.or(self.announced(&line)?.map(|count| (count, line)));
            } else if !line.text.trim().is_empty() {
                records.push(read(&line, &mut self)?);
            }
            last = Some(line);
        }
        let Some(last) = last else {
            return Ok(records);
        };
        match announced {
            Some((announced, line)) if announced != records.len() => {
                let (at, found) = (line.location(), records.len());
                Err(ColmapError::Announced { at, records: self.records, announced, found })
            }
            Some(_) if !self.ends_with_break => {
                Err(ColmapError::CutShort { at: last.location(), record: "a line without line break".to_owned() })
            }
            None if records.is_empty() => {
                Err(ColmapError::CutShort { at: last.location(), record: "the comments at its start".to_owned() })
            }
            _ => Ok(records),
        }
    }

    /// The number of records, if the comment gives it.
    fn announced(&self, comment: &Line<'_>) -> Result<Option<usize>, ColmapError> {
        let Some((_, rest)) = comment.text.split_once(&format!("Number of {}:", self.records)) else {
            return Ok(None);
        };
        let found = rest.split(',').next().unwrap_or(rest).trim();
        found.parse().map(Some).map_err(|_| ColmapError::Field {
            at: comment.location(),
            field: "the number of records",
            expected: "a number",
            found: found.to_owned(),
        })
    }
}
