//! Coordinates in which the numerical methods work. The entries of their matrices are products of
//! up to four coordinates, so the origin and the unit of length decide how many digits rounding
//! leaves.

use nalgebra::{Isometry2, Matrix2, Matrix3, Point2, Vector2};

use super::circle::{Circle, CircleError};
use super::rectify::TangentLine;
use super::section::SectionLine;

/// All lines count as parallel if the determinant of the mean of `n n^T` over the unit normals `n`
/// is at most this. It is the product of the mean squares of the normals along and across the
/// lines, so this is the square of an angle of about 1e-6.
const PARALLEL: f64 = 1e-12;

/// The lines count as concurrent if their root mean square distance from one point, relative to
/// their largest distance from the origin, is at most this: rounding leaves only three digits.
const CONCURRENT: f64 = 1e-13;

/// Coordinates in which the point nearest to all lines (weighted) is the origin and the lines' root
/// mean square distance from it is one:
///
/// ```text
///   q = (p - origin) / scale
/// ```
#[derive(Clone, Copy, Debug)]
pub(crate) struct Normalisation {
    origin: Point2<f64>,
    /// World units in one unit of the new coordinates.
    pub(crate) scale: f64,
}

impl Normalisation {
    /// Fails if the lines are parallel, concurrent or out of range.
    pub(crate) fn of(lines: &[SectionLine]) -> Result<Self, CircleError> {
        let total: f64 = lines.iter().map(|line| line.weight).sum();
        let mut matrix = Matrix2::zeros();
        let mut right = Vector2::zeros();
        for SectionLine { line, weight, .. } in lines {
            matrix += line.normal * line.normal.transpose() * (weight / total);
            right -= line.normal * (line.offset * weight / total);
        }
        if matrix.determinant() <= PARALLEL {
            return Err(CircleError::Parallel);
        }
        let origin = Point2::from(matrix.try_inverse().ok_or(CircleError::OutOfRange)? * right);
        let square = |line: &SectionLine| line.weight / total * line.line.distance(&origin).powi(2);
        let scale = lines.iter().map(square).sum::<f64>().sqrt();
        if !scale.is_finite() {
            return Err(CircleError::OutOfRange);
        }
        let extent = lines.iter().map(|line| line.line.offset.abs()).fold(0.0, f64::max);
        if scale <= CONCURRENT * extent || scale == 0.0 {
            return Err(CircleError::Concurrent);
        }
        Ok(Self { origin, scale })
    }

    /// A line in the new coordinates.
    pub(crate) fn line(&self, line: &TangentLine) -> TangentLine {
        TangentLine { normal: line.normal, offset: line.distance(&self.origin) / self.scale }
    }

    /// Lines in the new coordinates.
    pub(crate) fn lines(&self, lines: &[SectionLine]) -> Vec<SectionLine> {
        lines.iter().map(|line| SectionLine { line: self.line(&line.line), ..*line }).collect()
    }

    /// A circle back in the coordinates of the lines.
    pub(crate) fn circle(&self, circle: &Circle) -> Circle {
        Circle { centre: self.origin + circle.centre.coords * self.scale, radius: circle.radius * self.scale }
    }

    /// A dual conic back in the coordinates of the lines: `A C* A^T` with `p = A q`.
    pub(crate) fn dual_conic(&self, dual_conic: &Matrix3<f64>) -> Matrix3<f64> {
        let Self { origin, scale } = self;
        let map = Matrix3::new(*scale, 0.0, origin.x, 0.0, *scale, origin.y, 0.0, 0.0, 1.0);
        map * dual_conic * map.transpose()
    }
}

/// A turn by `angle` and a fixed shift that break symmetries. Without them, the lines of cameras in
/// equal steps around the axis have their centre at zero and solutions with equal coordinates, so
/// that an eigenvalue of an emitted solver is infinite or double.
pub(crate) fn generic_motion(angle: f64) -> Isometry2<f64> {
    Isometry2::new(Vector2::new(0.3, 0.2), angle)
}

/// A line after a motion of the plane.
pub(crate) fn moved_line(motion: &Isometry2<f64>, line: &TangentLine) -> TangentLine {
    let normal = motion.rotation * line.normal;
    TangentLine { normal, offset: line.offset - normal.dot(&motion.translation.vector) }
}
