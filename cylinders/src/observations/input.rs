//! Scene files. A scene is a JSON object:
//!
//! ```json
//! {
//!   "K": [[3000, 0, 2000], [0, 3000, 1500], [0, 0, 1]],
//!   "views": [
//!     {
//!       "image": "left.jpg",
//!       "camera_normalised": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 5]],
//!       "lines_pixels": [[1, 0, -1800], [1, 0, -2200]],
//!       "cylinders": ["tower", "tower"]
//!     }
//!   ]
//! }
//! ```
//!
//! - `K`: calibration in pixels, upper triangular. Optional if nothing is in pixels; with it,
//!   residuals are also in pixels. A view with another calibration has its own `K`.
//! - `views[i].camera_normalised`: 3x4 `[R t]` up to scale, world to camera; or `camera_pixels`:
//!   `K [R t]` up to scale.
//! - `views[i].lines_normalised`: lines `[a, b, c]`, `a x + b y + c = 0`, any scale and sign, in
//!   normalised image coordinates; or `lines_pixels`, in pixels; or `segments_pixels`:
//!   `[x1, y1, x2, y2]`, two end points for each line, in pixels without distortion. With end
//!   points, lines are compared with silhouettes at the end points. If a view gives its camera or
//!   its lines in several forms, these must agree.
//! - `views[i].image`: optional name of the image, for reports and for segments of a CSV file
//!   (`segments`).
//! - `views[i].cylinders`: optional, one label or `null` for each line: the cylinder whose
//!   silhouette it is. All lines without label count as silhouettes of one cylinder.
//! - `points`: optional world points `[x, y, z]`. The report gives the number of points near the
//!   surface.
//!
//! Other keys are ignored.

use std::path::Path;

use nalgebra::{Matrix3, Matrix3x4, Point2, Point3, Vector3};
use serde::Deserialize;
use thiserror::Error;

use super::scene::Scene;
use super::view::{Calibration, Camera, View, ViewError};

/// Largest difference between two forms of one camera (rotation entries; translation relative to
/// its length) or one line (unit vectors; distance of end points): about a third of a pixel at a
/// focal length of 3000.
const SPELLINGS_AGREE: f64 = 1e-4;

/// Errors of a scene file. Every message starts with the file and the place in it.
#[derive(Debug, Error)]
pub enum InputError {
    /// The file cannot be read.
    #[error("{file}: {source}")]
    Read {
        /// File name.
        file: String,
        /// Reason.
        source: std::io::Error,
    },
    /// The text is not JSON.
    #[error("{file}:{line}:{column}: not JSON: {message}")]
    NotJson {
        /// File name.
        file: String,
        /// Line, from 1.
        line: usize,
        /// Column, from 1.
        column: usize,
        /// Message of the parser.
        message: String,
    },
    /// The text is JSON, but not a scene: a key is missing or of another type.
    #[error("{file}:{line}:{column}: not a scene: {message}")]
    NotAScene {
        /// File name.
        file: String,
        /// Line, from 1.
        line: usize,
        /// Column, from 1.
        column: usize,
        /// Message of the parser.
        message: String,
    },
    /// An array has the wrong number of entries.
    #[error("{file}: {place} has {found} entries where {expected} are expected")]
    Shape {
        /// File name.
        file: String,
        /// Key and indices, such as `views[1].camera_pixels[0]`.
        place: String,
        /// Entries expected.
        expected: usize,
        /// Entries found.
        found: usize,
    },
    /// A view has no camera or no lines in either form, or has pixels without `K`.
    #[error("{file}: views[{view}] needs {needs}")]
    Missing {
        /// File name.
        file: String,
        /// Index of the view.
        view: usize,
        /// The missing keys.
        needs: &'static str,
    },
    /// Two forms of a camera or of a line differ.
    #[error("{file}: {place}: two forms of the same camera or line contradict each other")]
    Contradiction {
        /// File name.
        file: String,
        /// Key and indices.
        place: String,
    },
    /// A calibration, camera or line is not valid.
    #[error("{file}: {place}: {source}")]
    Invalid {
        /// File name.
        file: String,
        /// Key and indices.
        place: String,
        /// Reason.
        source: ViewError,
    },
}

type Rows = Vec<Vec<f64>>;

#[derive(Deserialize)]
struct SceneFile {
    #[serde(rename = "K")]
    calibration: Option<Rows>,
    views: Vec<ViewFile>,
    #[serde(default)]
    points: Rows,
}

#[derive(Deserialize)]
struct ViewFile {
    #[serde(rename = "K")]
    calibration: Option<Rows>,
    image: Option<String>,
    camera_normalised: Option<Rows>,
    camera_pixels: Option<Rows>,
    lines_normalised: Option<Rows>,
    lines_pixels: Option<Rows>,
    segments_pixels: Option<Rows>,
    cylinders: Option<Vec<Option<String>>>,
}

/// Reads a scene file.
///
/// # Errors
/// [`InputError`].
pub fn read_scene(path: &Path) -> Result<Scene, InputError> {
    let file = path.display().to_string();
    match std::fs::read_to_string(path) {
        Ok(text) => parse_scene(&text, &file),
        Err(source) => Err(InputError::Read { file, source }),
    }
}

/// Parses a scene; `file` is the name that error messages carry.
///
/// # Errors
/// [`InputError`], except [`InputError::Read`].
pub fn parse_scene(text: &str, file: &str) -> Result<Scene, InputError> {
    let scene: SceneFile = serde_json::from_str(text).map_err(|error| json_error(file, &error))?;
    let reader = Reader { file };
    let calibration = match &scene.calibration {
        Some(rows) => Some(reader.calibration(rows, "K")?),
        None => None,
    };
    let view = |(index, view)| reader.view(index, view, calibration);
    let point = |(index, point): (usize, &Vec<f64>)| {
        Ok(Point3::from(Vector3::from(reader.numbers(point, || format!("points[{index}]"))?)))
    };
    Ok(Scene {
        views: scene.views.iter().enumerate().map(view).collect::<Result<_, _>>()?,
        points: scene.points.iter().enumerate().map(point).collect::<Result<_, InputError>>()?,
    })
}

/// The message starts with the position, so the position at the end of the parser's message is
/// removed.
fn json_error(file: &str, error: &serde_json::Error) -> InputError {
    let (file, line, column) = (file.to_owned(), error.line(), error.column());
    let text = error.to_string();
    let message = text.split(" at line ").next().unwrap_or(&text).to_owned();
    if error.is_data() {
        InputError::NotAScene { file, line, column, message }
    } else {
        InputError::NotJson { file, line, column, message }
    }
}

/// Turns rows of numbers into typed values. It keeps the name of the file for messages.
struct Reader<'a> {
    file: &'a str,
}

impl Reader<'_> {
    fn view(&self, index: usize, view: &ViewFile, common: Option<Calibration>) -> Result<View, InputError> {
        let calibration = match &view.calibration {
            Some(rows) => Some(self.calibration(rows, &format!("views[{index}].K"))?),
            None => common,
        };
        let camera = self.camera(index, view, calibration)?;
        let mut parsed = self.lines(index, view, camera)?;
        if let Some(image) = &view.image {
            parsed = parsed.with_image(image.clone());
        }
        match &view.cylinders {
            Some(labels) => parsed
                .with_labels(labels.clone())
                .map_err(|source| self.invalid(&format!("views[{index}].cylinders"), source)),
            None => Ok(parsed),
        }
    }

    fn missing(&self, view: usize, needs: &'static str) -> InputError {
        InputError::Missing { file: self.file.to_owned(), view, needs }
    }

    fn camera(&self, index: usize, view: &ViewFile, calibration: Option<Calibration>) -> Result<Camera, InputError> {
        let camera = match &view.camera_normalised {
            Some(rows) => {
                let place = format!("views[{index}].camera_normalised");
                let matrix = self.camera_matrix(rows, &place)?;
                let camera = Camera::from_normalised(&matrix).map_err(|source| self.invalid(&place, source))?;
                Some(calibration.map_or(camera, |calibration| camera.with_calibration(calibration)))
            }
            None => None,
        };
        let camera_pixels = match &view.camera_pixels {
            Some(rows) => {
                let place = format!("views[{index}].camera_pixels");
                let calibration =
                    calibration.ok_or_else(|| self.missing(index, "`K`, because its camera is in pixels"))?;
                let matrix = self.camera_matrix(rows, &place)?;
                let other = Camera::from_pixels(&matrix, calibration).map_err(|source| self.invalid(&place, source))?;
                if camera.is_some_and(|camera| !cameras_agree(&camera, &other)) {
                    return Err(InputError::Contradiction { file: self.file.to_owned(), place });
                }
                Some(other)
            }
            None => None,
        };
        camera.or(camera_pixels).ok_or_else(|| self.missing(index, "`camera_normalised` or `camera_pixels`"))
    }

    fn lines(&self, index: usize, view: &ViewFile, camera: Camera) -> Result<View, InputError> {
        let place = |key| format!("views[{index}].{key}");
        if camera.calibration().is_none() && (view.lines_pixels.is_some() || view.segments_pixels.is_some()) {
            return Err(self.missing(index, "`K`, because its lines are in pixels"));
        }
        let mut parsed: Option<View> = None;
        if let Some(rows) = &view.lines_normalised {
            let place = place("lines_normalised");
            let lines = View::from_normalised_lines(camera, &self.line_rows(rows, &place)?);
            parsed = Some(lines.map_err(|source| self.invalid(&place, source))?);
        }
        if let Some(rows) = &view.lines_pixels {
            let place = place("lines_pixels");
            let lines = View::from_pixel_lines(camera, &self.line_rows(rows, &place)?);
            let lines = lines.map_err(|source| self.invalid(&place, source))?;
            let agree = |line: usize, known: &Vector3<f64>| known.cross(&lines.lines()[line]).norm() <= SPELLINGS_AGREE;
            self.check_agreement(parsed.as_ref(), lines.lines().len(), agree, &place)?;
            parsed = parsed.or(Some(lines));
        }
        if let Some(rows) = &view.segments_pixels {
            let place = place("segments_pixels");
            let segments = View::from_pixel_segments(camera, &self.segment_rows(rows, &place)?);
            let segments = segments.map_err(|source| self.invalid(&place, source))?;
            let ends = segments.ends().to_vec();
            let near = |line: &Vector3<f64>, end: &Point2<f64>| {
                line.dot(&end.to_homogeneous()).abs() <= SPELLINGS_AGREE * line.xy().norm()
            };
            let agree = |line: usize, known: &Vector3<f64>| ends[line].iter().flatten().all(|end| near(known, end));
            self.check_agreement(parsed.as_ref(), ends.len(), agree, &place)?;
            let with_ends = parsed.unwrap_or(segments).with_ends(ends);
            parsed = Some(with_ends.map_err(|source| self.invalid(&place, source))?);
        }
        parsed.ok_or_else(|| self.missing(index, "`lines_normalised`, `lines_pixels` or `segments_pixels`"))
    }

    /// Whether `count` lines in another form agree with the lines known before, if there are any. A
    /// line that has only one of the two forms does not agree.
    fn check_agreement(
        &self,
        known: Option<&View>,
        count: usize,
        agree: impl Fn(usize, &Vector3<f64>) -> bool,
        place: &str,
    ) -> Result<(), InputError> {
        let Some(known) = known.map(View::lines) else { return Ok(()) };
        let differing = (0..count.max(known.len()))
            .find(|&line| line >= count || !known.get(line).is_some_and(|known| agree(line, known)));
        let contradiction =
            |line| InputError::Contradiction { file: self.file.to_owned(), place: format!("{place}[{line}]") };
        differing.map_or(Ok(()), |line| Err(contradiction(line)))
    }

    fn calibration(&self, rows: &Rows, place: &str) -> Result<Calibration, InputError> {
        let rows: [[f64; 3]; 3] = self.matrix(rows, place)?;
        let matrix = Matrix3::from_fn(|row, column| rows[row][column]);
        Calibration::new(&matrix).map_err(|source| self.invalid(place, source))
    }

    fn camera_matrix(&self, rows: &Rows, place: &str) -> Result<Matrix3x4<f64>, InputError> {
        let rows: [[f64; 4]; 3] = self.matrix(rows, place)?;
        Ok(Matrix3x4::from_fn(|row, column| rows[row][column]))
    }

    fn line_rows(&self, rows: &Rows, place: &str) -> Result<Vec<Vector3<f64>>, InputError> {
        let line = |(index, row): (usize, &Vec<f64>)| {
            Ok(Vector3::from(self.numbers::<3>(row, || format!("{place}[{index}]"))?))
        };
        rows.iter().enumerate().map(line).collect()
    }

    fn segment_rows(&self, rows: &Rows, place: &str) -> Result<Vec<[Point2<f64>; 2]>, InputError> {
        let segment = |(index, row): (usize, &Vec<f64>)| {
            let [x1, y1, x2, y2] = self.numbers(row, || format!("{place}[{index}]"))?;
            Ok([Point2::new(x1, y1), Point2::new(x2, y2)])
        };
        rows.iter().enumerate().map(segment).collect()
    }

    fn matrix<const COLUMNS: usize>(&self, rows: &Rows, place: &str) -> Result<[[f64; COLUMNS]; 3], InputError> {
        let [first, second, third] = rows.as_slice() else {
            return Err(self.shape(place.to_owned(), 3, rows.len()));
        };
        let row = |index: usize, row: &[f64]| self.numbers(row, || format!("{place}[{index}]"));
        Ok([row(0, first)?, row(1, second)?, row(2, third)?])
    }

    fn numbers<const COUNT: usize>(
        &self,
        numbers: &[f64],
        place: impl Fn() -> String,
    ) -> Result<[f64; COUNT], InputError> {
        numbers.try_into().map_err(|_| self.shape(place(), COUNT, numbers.len()))
    }

    fn shape(&self, place: String, expected: usize, found: usize) -> InputError {
        InputError::Shape { file: self.file.to_owned(), place, expected, found }
    }

    fn invalid(&self, place: &str, source: ViewError) -> InputError {
        InputError::Invalid { file: self.file.to_owned(), place: place.to_owned(), source }
    }
}

fn cameras_agree(left: &Camera, right: &Camera) -> bool {
    let rotation = (left.rotation() - right.rotation()).amax();
    let translation = (left.translation() - right.translation()).norm();
    rotation <= SPELLINGS_AGREE && translation <= SPELLINGS_AGREE * left.translation().norm()
}
