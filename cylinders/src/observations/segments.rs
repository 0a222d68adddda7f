//! Line segments marked in images, as a CSV file:
//!
//! ```csv
//! image,x1,y1,x2,y2,cylinder,line
//! left.jpg,1812.5,203,1790,2950,tower,a
//! left.jpg,1788.1,3105,1781,3900,tower,a
//! left.jpg,2411,198.2,2437,2991,tower,
//! ```
//!
//! The first row names the columns, in any order and in capital or small letters; other columns are
//! ignored. Columns are separated by commas, semicolons or tabs, the same in all rows.
//!
//! - `image`: name of the image, as in the scene or in the model that has the cameras.
//! - `x1`, `y1`, `x2`, `y2`: end points, pixels of the original photograph; the reader removes
//!   the distortion.
//! - `cylinder`: optional label of the cylinder whose silhouette the segment is.
//! - `line`: optional name, any text. The segments of one image and cylinder with the same name are
//!   pieces of one line. A segment without name is a line by itself.
//!
//! COLMAP, and this reader, call the centre of the upper left pixel (0.5, 0.5). For files of
//! programs such as OpenCV that call it (0, 0) there is `PixelOrigin::Centre`.
//!
//! The line of several segments has the least sum of squared distances from all their end points,
//! in pixels without distortion. Its end points are the projections of the outermost end points to
//! the line.

use std::collections::BTreeMap;
use std::path::Path;

use csv::StringRecord;
use nalgebra::{Point2, Vector2, Vector3};
use thiserror::Error;

use super::photograph::Photograph;
use super::view::{SHORTEST_SEGMENT, View, ViewError};

/// Segments are not pieces of one line if the root mean square distance of their end points from
/// the line reaches this part of their root mean square distance along it: an angle of six degrees.
const SCATTERED: f64 = 0.1;

/// The segments of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Segments {
    file: String,
    segments: Vec<Segment>,
}

#[derive(Clone, Debug, PartialEq)]
struct Segment {
    /// Line of the file, from 1.
    row: u64,
    image: String,
    cylinder: Option<String>,
    line: Option<String>,
    ends: [Point2<f64>; 2],
}

/// Which point of the upper left pixel has the coordinates (0, 0).
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub enum PixelOrigin {
    /// Its outer corner, as in COLMAP: its centre is (0.5, 0.5).
    #[default]
    Corner,
    /// Its centre, as in OpenCV.
    Centre,
}

/// Errors of a file of segments. Every message starts with the file and the line in it.
#[derive(Debug, Error)]
pub enum SegmentError {
    /// The file cannot be read.
    #[error("{file}: {source}")]
    Read {
        /// File name.
        file: String,
        /// Reason.
        source: std::io::Error,
    },
    /// A row is not text, or has another number of columns than the first.
    #[error("{file}:{row}: {message}")]
    NotCsv {
        /// File name.
        file: String,
        /// Line, from 1.
        row: u64,
        /// Message of the parser.
        message: String,
    },
    /// A column is missing, or occurs twice.
    #[error(
        "{file}:1: the header names the column `{column}` {found} times; the columns are image,x1,y1,x2,y2 and optionally cylinder,line"
    )]
    Column {
        /// File name.
        file: String,
        /// Name of the column.
        column: &'static str,
        /// Number of times that the column occurs.
        found: usize,
    },
    /// A field is empty, not a number, or not finite.
    #[error("{file}:{row}: column `{column}` should be {expected}, not `{found}`")]
    Field {
        /// File name.
        file: String,
        /// Line, from 1.
        row: u64,
        /// Name of the column.
        column: &'static str,
        /// What was expected.
        expected: &'static str,
        /// What was found.
        found: String,
    },
    /// The end points coincide.
    #[error("{file}:{row}: the segment has no length")]
    NoLength {
        /// File name.
        file: String,
        /// Line, from 1.
        row: u64,
    },
    /// There is no image of this name.
    #[error("{file}:{row}: there is no image `{image}`")]
    UnknownImage {
        /// File name.
        file: String,
        /// Line, from 1.
        row: u64,
        /// Name of the image.
        image: String,
    },
    /// Several images have this name.
    #[error("{file}:{row}: several images are named `{image}`")]
    AmbiguousImage {
        /// File name.
        file: String,
        /// Line, from 1.
        row: u64,
        /// Name of the image.
        image: String,
    },
    /// The camera of the image has no calibration, so its pixels cannot be used.
    #[error("{file}:{row}: the camera of `{image}` has no calibration")]
    NoCalibration {
        /// File name.
        file: String,
        /// Line, from 1.
        row: u64,
        /// Name of the image.
        image: String,
    },
    /// An end point lies outside the image of the lens.
    #[error("{file}:{row}: the distortion of `{image}` cannot be removed at ({x}, {y}): far outside the image?")]
    BeyondDistortion {
        /// File name.
        file: String,
        /// Line, from 1.
        row: u64,
        /// Name of the image.
        image: String,
        /// Pixel.
        x: f64,
        /// Pixel.
        y: f64,
    },
    /// The segments of one line do not lie on a line.
    #[error("{file}:{row}: the segments of line `{line}` do not lie on one line")]
    Scattered {
        /// File name.
        file: String,
        /// Line of the first of them, from 1.
        row: u64,
        /// Name of the line.
        line: String,
    },
    /// The fitted line is out of range.
    #[error("{file}:{row}: the segment is out of range")]
    OutOfRange {
        /// File name.
        file: String,
        /// Line of its first segment, from 1.
        row: u64,
    },
    /// The lines of an image are not valid.
    #[error("{file}: the lines of `{image}`: {source}")]
    View {
        /// File name.
        file: String,
        /// Name of the image.
        image: String,
        /// Reason.
        source: ViewError,
    },
}

/// Reads a CSV file of segments.
///
/// # Errors
/// [`SegmentError`]: the errors that the rows show without the cameras.
pub fn read_segments(path: &Path) -> Result<Segments, SegmentError> {
    let file = path.display().to_string();
    match std::fs::read(path) {
        Ok(bytes) => parse_segments(&bytes, &file),
        Err(source) => Err(SegmentError::Read { file, source }),
    }
}

/// Parses CSV text; `file` is the name that error messages carry.
///
/// # Errors
/// As [`read_segments`], except [`SegmentError::Read`].
pub fn parse_segments(text: &[u8], file: &str) -> Result<Segments, SegmentError> {
    let text = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).delimiter(separator(text)).from_reader(text);
    let header = reader.headers().map_err(|error| csv_error(text, file, &error))?.clone();
    let columns = Columns::find(&header, file)?;
    let mut segments = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|error| csv_error(text, file, &error))?;
        segments.push(columns.segment(&record, file, row(text, record.position()))?);
    }
    Ok(Segments { file: file.to_owned(), segments })
}

/// The separator of columns: of comma, semicolon and tab, the one that is most often in the first
/// line.
fn separator(text: &[u8]) -> u8 {
    let header = text.trim_ascii_start().split(|&byte| byte == b'\n').next().unwrap_or_default();
    let count = |separator: u8| header.iter().filter(|&&byte| byte == separator).count();
    // The last of several largest counts is taken, so that the comma comes last.
    [b'\t', b';', b','].into_iter().max_by_key(|&separator| count(separator)).unwrap_or(b',')
}

/// The line of a record. The position of the reader is the end of the previous record, which line
/// breaks may follow.
fn row(text: &[u8], position: Option<&csv::Position>) -> u64 {
    let Some(position) = position else {
        return 1;
    };
    let rest = usize::try_from(position.byte()).ok().and_then(|byte| text.get(byte..)).unwrap_or_default();
    let breaks = rest.iter().take_while(|byte| b"\r\n".contains(byte)).filter(|&&byte| byte == b'\n');
    position.line() + breaks.count() as u64
}

fn csv_error(text: &[u8], file: &str, error: &csv::Error) -> SegmentError {
    let row = row(text, error.position());
    let message = match error.kind() {
        csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
            format!("{len} columns where the header has {expected_len}")
        }
        csv::ErrorKind::Utf8 { err, .. } => format!("column {} is not UTF-8 text", err.field() + 1),
        _ => error.to_string(),
    };
    SegmentError::NotCsv { file: file.to_owned(), row, message }
}

/// Indices of the columns.
struct Columns {
    image: usize,
    ends: [(&'static str, usize); 4],
    cylinder: Option<usize>,
    line: Option<usize>,
}

impl Columns {
    fn find(header: &StringRecord, file: &str) -> Result<Self, SegmentError> {
        let optional = |column: &'static str| {
            let mut places =
                header.iter().enumerate().filter(|(_, name)| name.eq_ignore_ascii_case(column)).map(|(index, _)| index);
            match (places.next(), places.count()) {
                (first, 0) => Ok(first),
                (_, more) => Err(SegmentError::Column { file: file.to_owned(), column, found: 1 + more }),
            }
        };
        let required = |column: &'static str| {
            optional(column)?.ok_or_else(|| SegmentError::Column { file: file.to_owned(), column, found: 0 })
        };
        let end = |column| Ok((column, required(column)?));
        Ok(Self {
            image: required("image")?,
            ends: [end("x1")?, end("y1")?, end("x2")?, end("y2")?],
            cylinder: optional("cylinder")?,
            line: optional("line")?,
        })
    }

    fn segment(&self, record: &StringRecord, file: &str, row: u64) -> Result<Segment, SegmentError> {
        let text = |index: usize| record.get(index).filter(|text| !text.is_empty());
        let field = |column, expected, found: &str| SegmentError::Field {
            file: file.to_owned(),
            row,
            column,
            expected,
            found: found.to_owned(),
        };
        let number = |(column, index): (&'static str, usize)| {
            let found = text(index).unwrap_or_default();
            let number = found.parse().ok().filter(|number: &f64| number.is_finite());
            number.ok_or_else(|| field(column, "a finite number of pixels", found))
        };
        let [x1, y1, x2, y2] = self.ends;
        let ends = [Point2::new(number(x1)?, number(y1)?), Point2::new(number(x2)?, number(y2)?)];
        if (ends[1] - ends[0]).norm() < SHORTEST_SEGMENT {
            return Err(SegmentError::NoLength { file: file.to_owned(), row });
        }
        let label = |column: Option<usize>| column.and_then(text).map(str::to_owned);
        Ok(Segment {
            row,
            image: text(self.image).ok_or_else(|| field("image", "the name of an image", ""))?.to_owned(),
            cylinder: label(self.cylinder),
            line: label(self.line),
            ends,
        })
    }
}

/// The segments of one line, at least one.
struct Pieces<'a> {
    first: &'a Segment,
    more: Vec<&'a Segment>,
}

impl Segments {
    /// The same segments, with pixels counted from the corner of the image. `origin` is where they
    /// are counted from now.
    pub fn with_pixel_origin(mut self, origin: PixelOrigin) -> Self {
        if origin == PixelOrigin::Centre {
            let ends = self.segments.iter_mut().flat_map(|segment| &mut segment.ends);
            ends.for_each(|end| *end += Vector2::new(0.5, 0.5));
        }
        self
    }

    /// The lines of the segments as views: one view for each photograph with lines, in the order of
    /// the photographs. The lines are in the order of their first segments.
    ///
    /// # Errors
    /// [`SegmentError`]: the errors that need the cameras.
    pub fn views(&self, photographs: &[Photograph]) -> Result<Vec<View>, SegmentError> {
        let mut lines: BTreeMap<usize, Vec<Pieces<'_>>> = BTreeMap::new();
        let by_name = Names::of(photographs);
        for segment in &self.segments {
            let lines = lines.entry(by_name.find(segment, &self.file)?).or_default();
            let same = |pieces: &&mut Pieces<'_>| {
                segment.line.is_some() && pieces.first.line == segment.line && pieces.first.cylinder == segment.cylinder
            };
            match lines.iter_mut().find(same) {
                Some(pieces) => pieces.more.push(segment),
                None => lines.push(Pieces { first: segment, more: Vec::new() }),
            }
        }
        lines.into_iter().map(|(index, lines)| self.view(&photographs[index], &lines)).collect()
    }

    fn view(&self, photograph: &Photograph, lines: &[Pieces<'_>]) -> Result<View, SegmentError> {
        let fitted = lines.iter().map(|pieces| self.fit(photograph, pieces));
        let (fitted, ends): (Vec<_>, Vec<_>) = fitted.collect::<Result<Vec<_>, _>>()?.into_iter().unzip();
        let calibration = photograph.camera.calibration();
        let normalised = |ends: [Point2<f64>; 2]| {
            calibration.map(|calibration| ends.map(|end| calibration.point_to_normalised(&end)))
        };
        let labels = lines.iter().map(|pieces| pieces.first.cylinder.clone()).collect();
        let view = View::from_pixel_lines(photograph.camera, &fitted)
            .and_then(|view| view.with_ends(ends.into_iter().map(normalised).collect()))
            .and_then(|view| view.with_labels(labels));
        let (file, image) = (self.file.clone(), photograph.name.clone());
        match view {
            Ok(view) => Ok(view.with_image(image).with_distortion(photograph.distortion)),
            Err(source) => Err(SegmentError::View { file, image, source }),
        }
    }

    /// Total least squares through the end points: the line through their centroid along the main
    /// axis of their scatter, and the outermost end points projected to it, pixels.
    fn fit(
        &self,
        photograph: &Photograph,
        pieces: &Pieces<'_>,
    ) -> Result<(Vector3<f64>, [Point2<f64>; 2]), SegmentError> {
        let mut points = Vec::with_capacity(2 + 2 * pieces.more.len());
        for segment in std::iter::once(&pieces.first).chain(&pieces.more) {
            for end in &segment.ends {
                points.push(self.undistort(photograph, segment, end)?);
            }
        }
        let count = points.len() as f64;
        let centroid = points.iter().map(|point| point.coords / count).sum::<Vector2<f64>>();
        // The unit is the largest coordinate, so that no square overflows.
        let size = points.iter().map(|point| (point.coords - centroid).amax()).fold(0.0, f64::max);
        let (mut difference, mut product, mut sum) = (0.0, 0.0, 0.0);
        for point in &points {
            let offset = (point.coords - centroid) / size;
            difference += (offset.x - offset.y) * (offset.x + offset.y);
            product += 2.0 * offset.x * offset.y;
            sum += offset.norm_squared();
        }
        let (file, row) = (self.file.clone(), pieces.first.row);
        let (sine, cosine) = (0.5 * product.atan2(difference)).sin_cos();
        let line = Vector3::new(-sine, cosine, sine * centroid.x - cosine * centroid.y);
        if !line.iter().all(|entry| entry.is_finite()) {
            return Err(SegmentError::OutOfRange { file, row });
        }
        // The scatter matrix [a b; b c] has the eigenvalues (a + c +- |(a - c, 2 b)|) / 2.
        let spread = difference.hypot(product);
        if !pieces.more.is_empty() && sum - spread > SCATTERED * SCATTERED * (sum + spread) {
            let line = pieces.first.line.clone().unwrap_or_default();
            return Err(SegmentError::Scattered { file, row, line });
        }
        let along = Vector2::new(cosine, sine);
        let positions = points.iter().map(|point| along.dot(&(point.coords - centroid)));
        let (first, last) = positions
            .fold((f64::INFINITY, -f64::INFINITY), |(first, last), position| (first.min(position), last.max(position)));
        Ok((line, [first, last].map(|position| Point2::from(centroid + along * position))))
    }

    fn undistort(
        &self,
        photograph: &Photograph,
        segment: &Segment,
        end: &Point2<f64>,
    ) -> Result<Point2<f64>, SegmentError> {
        let (file, row, image) = (self.file.clone(), segment.row, segment.image.clone());
        if photograph.camera.calibration().is_none() {
            return Err(SegmentError::NoCalibration { file, row, image });
        }
        let beyond = SegmentError::BeyondDistortion { file, row, image, x: end.x, y: end.y };
        photograph.undistort(end).ok_or(beyond)
    }
}

/// Index of the photograph of each name; `None` if several photographs have the name.
struct Names<'a>(BTreeMap<&'a str, Option<usize>>);

impl<'a> Names<'a> {
    fn of(photographs: &'a [Photograph]) -> Self {
        let mut names = BTreeMap::new();
        for (index, photograph) in photographs.iter().enumerate() {
            names.entry(photograph.name.as_str()).and_modify(|place| *place = None).or_insert(Some(index));
        }
        Self(names)
    }

    fn find(&self, segment: &Segment, file: &str) -> Result<usize, SegmentError> {
        let (file, row, image) = (file.to_owned(), segment.row, segment.image.clone());
        match self.0.get(segment.image.as_str()) {
            Some(Some(index)) => Ok(*index),
            Some(None) => Err(SegmentError::AmbiguousImage { file, row, image }),
            None => Err(SegmentError::UnknownImage { file, row, image }),
        }
    }
}
