//! Cameras and silhouette lines: the input of the pipeline, validated once so that later steps can
//! rely on it.
//!
//! A camera maps a world point `X` to the image point `x ~ K (R X + t)`. In *normalised* image
//! coordinates `K = I`. An image line is `l` with `l^T x = 0`. The world points whose image lies on
//! the line form its *viewing plane*
//!
//! ```text
//!     l^T (R X + t) = 0,   normal n = R^T l,   through the camera centre C = -R^T t
//! ```
//!
//! and the viewing plane of a silhouette line is tangent to the cylinder.

use nalgebra::{Matrix3, Matrix3x4, Point2, Point3, Vector2, Vector3};
use thiserror::Error;

use super::distortion::Distortion;

/// Largest accepted entry of `M^T M / s^2 - I` for the left 3x3 part `M` of a camera, `s` its mean
/// row norm. It admits rotations written with four digits and refuses a camera that still contains
/// its calibration.
const ROTATION_TOLERANCE: f64 = 1e-3;

/// End points that are nearer to each other than this, pixels, determine no direction.
pub(crate) const SHORTEST_SEGMENT: f64 = 1e-3;

/// Upper triangular calibration matrix, pixels.
///
/// ```text
///       [ fx  s  px ]   focal lengths fx, fy, skew s,
///   K = [  0 fy  py ]   principal point (px, py)
///       [  0  0   1 ]
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Calibration {
    matrix: Matrix3<f64>,
}

/// A calibrated camera `[R t]`: a rotation matrix and a translation, world to camera. It keeps its
/// calibration, if there is one, for residuals in pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    rotation: Matrix3<f64>,
    translation: Vector3<f64>,
    calibration: Option<Calibration>,
    is_negated: bool,
}

/// A camera and the silhouette lines seen in it: unit 3-vectors, in normalised image coordinates.
/// If the input has them, it also keeps the name of the image, and the end points and the
/// cylinder's label of each line.
#[derive(Clone, Debug, PartialEq)]
pub struct View {
    camera: Camera,
    lines: Vec<Vector3<f64>>,
    /// End points of each line: two different points on it, normalised image coordinates.
    ends: Vec<Option<[Point2<f64>; 2]>>,
    /// One entry for each line.
    labels: Vec<Option<String>>,
    image: Option<String>,
    /// Distortion of the photograph, which has been removed from the lines.
    distortion: Distortion,
}

/// The plane `n^T (X - C) = 0` through the camera centre `C` and an image line; `n` is of unit
/// length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViewingPlane {
    /// Unit normal `n`, world frame.
    pub normal: Vector3<f64>,
    /// Camera centre `C`, world frame.
    pub centre: Point3<f64>,
    /// Unit viewing direction of the camera, world frame.
    pub forward: Vector3<f64>,
}

/// Why a camera, a calibration or a line is refused.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum ViewError {
    /// An entry of the camera is NaN or infinite, or the matrix is out of range.
    #[error("the camera has an entry that is not a finite number")]
    CameraNotFinite,
    /// The left 3x3 part is not a rotation up to scale.
    #[error(
        "the left 3x3 part of the camera is not a rotation up to scale (off by {deviation:.1e}); \
         is it in pixels, or does it have another calibration?"
    )]
    NotARotation {
        /// Largest entry of `M^T M / s^2 - I`.
        deviation: f64,
    },
    /// `K` is not finite, not upper triangular with non-zero diagonal, or its last row is not
    /// `0 0 1` up to scale.
    #[error("the calibration must be finite, upper triangular and have a non-zero diagonal")]
    NotACalibration,
    /// A line has an entry that is NaN or infinite.
    #[error("line {line} has an entry that is not a finite number")]
    LineNotFinite {
        /// Index of the line in its view.
        line: usize,
    },
    /// A line `(0, 0, c)`: zero, or at infinity.
    #[error("line {line} has no direction: its first two coefficients are zero")]
    LineWithoutDirection {
        /// Index of the line in its view.
        line: usize,
    },
    /// An end point has a coordinate that is NaN, infinite or out of range.
    #[error("line {line} has an end point that is not finite, or out of range")]
    EndNotFinite {
        /// Index of the line in its view.
        line: usize,
    },
    /// The end points of a line coincide.
    #[error("line {line} has no length: its end points coincide")]
    NoLength {
        /// Index of the line in its view.
        line: usize,
    },
    /// The number of pairs of end points, `None` included, is not the number of lines.
    #[error("{ends} pairs of end points for {lines} line(s)")]
    EndCount {
        /// Number of lines.
        lines: usize,
        /// Number of pairs, `None` included.
        ends: usize,
    },
    /// A parameter of the distortion is out of the range in which it is defined.
    #[error(
        "the distortion is not defined: its coefficients are finite, the field of view of FOV is below pi, EUCM has 0 <= alpha <= 1 and beta > 0"
    )]
    NotADistortion,
    /// Lines in pixels were given with a camera that has no calibration.
    #[error("lines in pixels need a calibration")]
    NoCalibration,
    /// The number of labels is not the number of lines.
    #[error("{labels} cylinder labels for {lines} line(s)")]
    LabelCount {
        /// Number of lines.
        lines: usize,
        /// Number of labels.
        labels: usize,
    },
}

impl Calibration {
    /// Validates a calibration matrix; any non-zero multiple of it is accepted.
    pub fn new(matrix: &Matrix3<f64>) -> Result<Self, ViewError> {
        let scaled = matrix / matrix[(2, 2)];
        let lower = [scaled[(1, 0)], scaled[(2, 0)], scaled[(2, 1)]];
        let regular = scaled.iter().all(|entry| entry.is_finite())
            && lower.iter().all(|&entry| entry == 0.0)
            && scaled[(0, 0)] != 0.0
            && scaled[(1, 1)] != 0.0;
        if regular { Ok(Self { matrix: scaled }) } else { Err(ViewError::NotACalibration) }
    }

    /// The matrix `K`, its last entry one.
    pub fn matrix(&self) -> &Matrix3<f64> {
        &self.matrix
    }

    /// A line in normalised coordinates from one in pixels: `l_n ~ K^T l_p`, because
    /// `l_p^T K x_n = 0`.
    pub fn line_to_normalised(&self, line: &Vector3<f64>) -> Vector3<f64> {
        self.matrix.tr_mul(line)
    }

    /// A line in pixels from one in normalised coordinates: `l_p ~ K^-T l_n`.
    pub fn line_to_pixels(&self, line: &Vector3<f64>) -> Vector3<f64> {
        let k = &self.matrix;
        let a = line[0] / k[(0, 0)];
        let b = (line[1] - k[(0, 1)] * a) / k[(1, 1)];
        Vector3::new(a, b, line[2] - k[(0, 2)] * a - k[(1, 2)] * b)
    }

    /// A point in normalised coordinates from one in pixels: `K^-1 x_p`.
    pub fn point_to_normalised(&self, pixel: &Point2<f64>) -> Point2<f64> {
        let k = &self.matrix;
        let y = (pixel.y - k[(1, 2)]) / k[(1, 1)];
        Point2::new((pixel.x - k[(0, 2)] - k[(0, 1)] * y) / k[(0, 0)], y)
    }

    /// A point in pixels from one in normalised coordinates: `K x_n`.
    pub fn point_to_pixels(&self, point: &Point2<f64>) -> Point2<f64> {
        Point2::from((self.matrix * point.to_homogeneous()).xy())
    }

    /// `K^-1 P` by back-substitution.
    fn remove_from(&self, camera: &Matrix3x4<f64>) -> Matrix3x4<f64> {
        let k = &self.matrix;
        let row2 = camera.row(2).clone_owned();
        let row1 = (camera.row(1) - row2 * k[(1, 2)]) / k[(1, 1)];
        let row0 = (camera.row(0) - row1 * k[(0, 1)] - row2 * k[(0, 2)]) / k[(0, 0)];
        Matrix3x4::from_rows(&[row0, row1, row2])
    }
}

impl Camera {
    /// A camera in normalised coordinates: any non-zero multiple of `[R t]`. `R` is replaced by the
    /// nearest rotation, so that rounding in the input does not reach the result.
    ///
    /// # Errors
    /// [`ViewError::CameraNotFinite`], [`ViewError::NotARotation`].
    pub fn from_normalised(camera: &Matrix3x4<f64>) -> Result<Self, ViewError> {
        let left = camera.fixed_columns::<3>(0).clone_owned();
        let largest = left.amax();
        if !camera.iter().all(|entry| entry.is_finite()) {
            return Err(ViewError::CameraNotFinite);
        }
        // The matrix is first divided by its largest entry, so that no product overflows.
        let left = left / largest;
        let scale = (left.norm_squared() / 3.0).sqrt().copysign(left.determinant());
        let rotation = left / scale;
        let deviation = (rotation.tr_mul(&rotation) - Matrix3::identity()).amax();
        // For a zero matrix the norm is NaN, although the largest entry may not be.
        if rotation.norm().is_nan() || deviation > ROTATION_TOLERANCE {
            return Err(ViewError::NotARotation { deviation });
        }
        let translation = camera.column(3) / largest / scale;
        if !translation.iter().all(|entry| entry.is_finite()) {
            return Err(ViewError::CameraNotFinite);
        }
        Ok(Self { rotation: nearest_rotation(rotation), translation, calibration: None, is_negated: scale < 0.0 })
    }

    /// A camera in pixels, `K [R t]` up to scale, with its calibration.
    ///
    /// # Errors
    /// As [`Camera::from_normalised`].
    pub fn from_pixels(camera: &Matrix3x4<f64>, calibration: Calibration) -> Result<Self, ViewError> {
        if !camera.iter().all(|entry| entry.is_finite()) {
            return Err(ViewError::CameraNotFinite);
        }
        Ok(Self::from_normalised(&calibration.remove_from(camera))?.with_calibration(calibration))
    }

    /// The same camera, with a calibration for residuals and lines in pixels.
    pub fn with_calibration(self, calibration: Calibration) -> Self {
        Self { calibration: Some(calibration), ..self }
    }

    /// Rotation matrix `R`, world to camera.
    pub fn rotation(&self) -> &Matrix3<f64> {
        &self.rotation
    }

    /// Translation `t`, world to camera, world units.
    pub fn translation(&self) -> &Vector3<f64> {
        &self.translation
    }

    /// Camera centre `C = -R^T t`, world frame.
    pub fn centre(&self) -> Point3<f64> {
        Point3::from(-self.rotation.tr_mul(&self.translation))
    }

    /// Whether the matrix was given with a negative determinant, so that its sign was changed. It
    /// is either a negative multiple of a camera, or mirrored and wrong.
    pub fn is_negated(&self) -> bool {
        self.is_negated
    }

    /// The calibration, if there is one.
    pub fn calibration(&self) -> Option<&Calibration> {
        self.calibration.as_ref()
    }
}

impl View {
    /// A view with lines in normalised image coordinates, any scale and sign.
    ///
    /// # Errors
    /// [`ViewError::LineNotFinite`], [`ViewError::LineWithoutDirection`].
    pub fn from_normalised_lines(camera: Camera, lines: &[Vector3<f64>]) -> Result<Self, ViewError> {
        let unit = |(index, line)| unit_line(index, line);
        Ok(Self::new(camera, lines.iter().enumerate().map(unit).collect::<Result<_, _>>()?))
    }

    /// A view with lines in pixels, any scale and sign.
    ///
    /// # Errors
    /// As [`View::from_normalised_lines`], and [`ViewError::NoCalibration`].
    pub fn from_pixel_lines(camera: Camera, lines: &[Vector3<f64>]) -> Result<Self, ViewError> {
        let calibration = camera.calibration().ok_or(ViewError::NoCalibration)?;
        // Unit length before and after: pixel lines are often scaled so that their entries differ
        // widely.
        let normalise = |(index, line)| {
            unit_line(index, line).and_then(|unit| unit_line(index, &calibration.line_to_normalised(&unit)))
        };
        Ok(Self::new(camera, lines.iter().enumerate().map(normalise).collect::<Result<_, _>>()?))
    }

    /// A view with the lines through pairs of points, which become the end points of the lines;
    /// pixels without distortion.
    ///
    /// # Errors
    /// [`ViewError::EndNotFinite`], [`ViewError::NoLength`] below a thousandth of a pixel, and as
    /// [`View::from_pixel_lines`].
    pub fn from_pixel_segments(camera: Camera, segments: &[[Point2<f64>; 2]]) -> Result<Self, ViewError> {
        let calibration = *camera.calibration().ok_or(ViewError::NoCalibration)?;
        for (line, segment) in segments.iter().enumerate() {
            let length = (segment[1] - segment[0]).norm();
            if !length.is_finite() {
                return Err(ViewError::EndNotFinite { line });
            }
            if length < SHORTEST_SEGMENT {
                return Err(ViewError::NoLength { line });
            }
        }
        let lines: Vec<_> = segments.iter().map(|[start, end]| line_through(start, end)).collect();
        let ends = segments.iter().map(|ends| Some(ends.map(|end| calibration.point_to_normalised(&end)))).collect();
        Self::from_pixel_lines(camera, &lines)?.with_ends(ends)
    }

    fn new(camera: Camera, lines: Vec<Vector3<f64>>) -> Self {
        let count = lines.len();
        Self {
            camera,
            lines,
            ends: vec![None; count],
            labels: vec![None; count],
            image: None,
            distortion: Distortion::default(),
        }
    }

    /// The same view with end points of lines, `None` for a line whose end points are unknown;
    /// normalised image coordinates without distortion. They are moved to the nearest points of
    /// their lines.
    ///
    /// # Errors
    /// [`ViewError::EndCount`], [`ViewError::EndNotFinite`], [`ViewError::NoLength`].
    pub fn with_ends(self, ends: Vec<Option<[Point2<f64>; 2]>>) -> Result<Self, ViewError> {
        if ends.len() != self.lines.len() {
            return Err(ViewError::EndCount { lines: self.lines.len(), ends: ends.len() });
        }
        let on_line = |(line, ends): (usize, Option<[Point2<f64>; 2]>)| {
            let Some(ends) = ends else { return Ok(None) };
            let ends = ends.map(|end| nearest_on_line(&self.lines[line], &end));
            if !ends.iter().all(|end| end.iter().all(|coordinate| coordinate.is_finite())) {
                return Err(ViewError::EndNotFinite { line });
            }
            if ends[0] == ends[1] { Err(ViewError::NoLength { line }) } else { Ok(Some(ends)) }
        };
        let ends = ends.into_iter().enumerate().map(on_line).collect::<Result<_, _>>()?;
        Ok(Self { ends, ..self })
    }

    /// The same view, with the name of its image.
    pub fn with_image(self, image: String) -> Self {
        Self { image: Some(image), ..self }
    }

    /// The same view, with the distortion of its photograph. The lines are those without
    /// distortion; it serves to draw them over the photograph.
    pub fn with_distortion(self, distortion: Distortion) -> Self {
        Self { distortion, ..self }
    }

    /// The same view, with the label of the cylinder to which each line belongs.
    ///
    /// # Errors
    /// [`ViewError::LabelCount`].
    pub fn with_labels(self, labels: Vec<Option<String>>) -> Result<Self, ViewError> {
        match labels.len() == self.lines.len() {
            true => Ok(Self { labels, ..self }),
            false => Err(ViewError::LabelCount { lines: self.lines.len(), labels: labels.len() }),
        }
    }

    /// Adds the lines of a view of the same image.
    pub(crate) fn append(&mut self, other: Self) {
        self.lines.extend(other.lines);
        self.ends.extend(other.ends);
        self.labels.extend(other.labels);
    }

    /// The same view with only the lines of one label, and the original indices of these lines.
    pub(crate) fn labelled(&self, label: Option<&str>) -> (Self, Vec<usize>) {
        let indices: Vec<_> = (0..self.lines.len()).filter(|&line| self.labels[line].as_deref() == label).collect();
        (self.selected(&indices), indices)
    }

    /// The same view with only the chosen lines.
    pub(crate) fn selected(&self, indices: &[usize]) -> Self {
        Self {
            camera: self.camera,
            lines: indices.iter().map(|&line| self.lines[line]).collect(),
            ends: indices.iter().map(|&line| self.ends[line]).collect(),
            labels: indices.iter().map(|&line| self.labels[line].clone()).collect(),
            image: self.image.clone(),
            distortion: self.distortion,
        }
    }

    /// The same view with only the chosen lines, some of them replaced by another line with its end
    /// points.
    pub(crate) fn with_joint_lines(&self, chosen: &[(usize, Option<LineWithEnds>)]) -> Self {
        let indices: Vec<_> = chosen.iter().map(|&(index, _)| index).collect();
        let mut view = self.selected(&indices);
        for (place, (line, ends)) in
            chosen.iter().enumerate().filter_map(|(place, (_, joint))| Some((place, (*joint)?)))
        {
            view.lines[place] = line;
            view.ends[place] = ends;
        }
        view
    }

    /// The camera.
    pub fn camera(&self) -> &Camera {
        &self.camera
    }

    /// The lines, of unit length, in normalised image coordinates.
    pub fn lines(&self) -> &[Vector3<f64>] {
        &self.lines
    }

    /// The end points of each line, `None` if they are unknown. They are on the line; normalised
    /// image coordinates without distortion.
    pub fn ends(&self) -> &[Option<[Point2<f64>; 2]>] {
        &self.ends
    }

    /// The labels of the cylinders to which the lines belong, one for each line.
    pub fn labels(&self) -> &[Option<String>] {
        &self.labels
    }

    /// The name of the image, if it has one.
    pub fn image(&self) -> Option<&str> {
        self.image.as_deref()
    }

    /// The distortion of the photograph. It has been removed from the lines.
    pub fn distortion(&self) -> &Distortion {
        &self.distortion
    }

    /// The viewing planes of the lines, in their order.
    pub fn planes(&self) -> impl Iterator<Item = ViewingPlane> {
        let centre = self.camera.centre();
        let forward = self.camera.rotation.row(2).transpose();
        self.lines.iter().map(move |line| ViewingPlane { normal: self.camera.rotation.tr_mul(line), centre, forward })
    }
}

/// A line of unit length and its end points, if they are known; normalised image coordinates.
pub(crate) type LineWithEnds = (Vector3<f64>, Option<[Point2<f64>; 2]>);

/// The line scaled to unit length.
fn unit_line(index: usize, line: &Vector3<f64>) -> Result<Vector3<f64>, ViewError> {
    if !line.iter().all(|entry| entry.is_finite()) {
        return Err(ViewError::LineNotFinite { line: index });
    }
    if line[0] == 0.0 && line[1] == 0.0 {
        return Err(ViewError::LineWithoutDirection { line: index });
    }
    Ok((line / line.amax()).normalize())
}

/// The line through two points, the normal of unit length.
fn line_through(start: &Point2<f64>, end: &Point2<f64>) -> Vector3<f64> {
    let along = (end - start).normalize();
    let normal = Vector2::new(-along.y, along.x);
    normal.push(-normal.dot(&nalgebra::center(start, end).coords))
}

fn nearest_on_line(line: &Vector3<f64>, point: &Point2<f64>) -> Point2<f64> {
    point - line.xy() * (line.dot(&point.to_homogeneous()) / line.xy().norm_squared())
}

/// Nearest rotation to a matrix that is one up to [`ROTATION_TOLERANCE`]: Newton's iteration
/// `R <- R (3 I - R^T R) / 2` for the polar factor squares the deviation in each step, 1e-3 to 1e-6
/// to 1e-12 to rounding.
fn nearest_rotation(mut rotation: Matrix3<f64>) -> Matrix3<f64> {
    for _ in 0..4 {
        rotation = rotation * (Matrix3::identity() * 3.0 - rotation.tr_mul(&rotation)) / 2.0;
    }
    rotation
}
