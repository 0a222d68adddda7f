//! Step 3: the circle of the cross-section, by constrained least squares on its dual conic.
//!
//! The tangents of a circle with centre `(x, y)` and radius `r` are the lines `l = (a, b, c)` with `l^T C* l = 0`. Its
//! dual conic, scaled so that `d6 = -1`, is
//!
//! ```text
//!        [ d1 d2 d3 ]   [ r^2 - x^2    -x y     -x ]
//!   C* = [ d2 d4 d5 ] = [   -x y    r^2 - y^2   -y ]     d3 d5 - d2 d6 = 0
//!        [ d3 d5 d6 ]   [    -x         -y      -1 ]     d5^2 - d3^2 + d1 d6 - d4 d6 = 0
//! ```
//!
//! For a line of unit normal at distance `h` from the centre, `l^T C* l = r^2 - h^2`. The circle minimises the sum of
//! its squares, `d^T G d` with `d = (d1, 2 d2, 2 d3, d4, 2 d5, d6)` and the Gram matrix `G` of the rows
//! `(a^2, a b, a c, b^2, b c, c^2)`, subject to the two constraints. The emitted solver `circle_least_squares` returns
//! every stationary point of the Lagrangian, hence the global minimum (Gummeson & Oskarsson, "Robust and Accurate
//! Cylinder Triangulation", eq. (23)-(26)).
//!
//! The entries of `G` are products of up to four coordinates, so the origin and the unit of length decide how many digits
//! are left: lines are first shifted to the point nearest to all of them and scaled to a mean square distance of one.

use nalgebra::{Matrix2, Point2, Rotation2, Vector2};
use thiserror::Error;

use super::rectify::TangentLine;
use super::stationary::stationary_circles;

/// Root mean square distance of the lines from one point, relative to the extent of the scene, below which they count
/// as meeting there. Far below what marking lines in an image can reach, above what rounding leaves.
const CONCURRENT: f64 = 1e-9;

/// Determinant of the mean of `n n^T` over the unit normals `n` at and below which all lines count as parallel: the product
/// of the mean squares of the normals along and across them, so the square of an angle of about 1e-6.
const PARALLEL: f64 = 1e-12;

/// Root mean square of `r^2 - h^2`, in units of the normalised lines or of `r^2` where that is larger, below which a circle
/// fits exactly.
const EXACT_FIT: f64 = 1e-9;

/// A circle of the cross-section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    /// Centre, world units.
    pub centre: Point2<f64>,
    /// Radius, world units.
    pub radius: f64,
}

/// The least squares circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CircleFit {
    /// The circle of least cost.
    pub circle: Circle,
    /// Root mean square of `(r^2 - h^2) / (2 r)`, which is the distance `r - h` to first order; world units.
    pub rms: f64,
    /// Number of stationary circles among which it was chosen.
    pub stationary_points: usize,
}

/// Why there is no circle.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum CircleError {
    /// All lines pass through one point: two distinct lines, or the axis marked instead of its silhouettes.
    #[error(
        "in the cross-section all lines meet in one point: there are fewer than three distinct tangents, or the lines are \
         not silhouettes"
    )]
    Concurrent,
    /// All lines are parallel; none is nearest to a point.
    #[error("in the cross-section all lines are parallel")]
    Parallel,
    /// Several circles touch all lines exactly, as four do for three lines.
    #[error(
        "{circles} circles touch all lines of the cross-section exactly, as is the case for three lines; \
         a fourth silhouette line decides"
    )]
    Ambiguous {
        /// Number of circles.
        circles: usize,
    },
    /// A coordinate is NaN, infinite or out of range.
    #[error("the lines of the cross-section are out of range")]
    OutOfRange,
    /// No stationary point is a real circle.
    #[error("no stationary point of the least squares problem is a circle")]
    NoCircle,
    /// The emitted solver refused the data.
    #[error("the least squares problem could not be solved: {0}")]
    Solver(#[from] eliminant::SolveError),
}

/// Constrained least squares circle from at least three tangent lines; `extent` is the size of the scene in world units,
/// to which the distances of the lines from a common point are compared.
///
/// # Errors
/// [`CircleError`].
pub fn fit_circle(lines: &[TangentLine], extent: f64) -> Result<CircleFit, CircleError> {
    let normalisation = Normalisation::of(lines)?;
    if normalisation.scale <= CONCURRENT * extent {
        return Err(CircleError::Concurrent);
    }
    let normalised: Vec<_> = lines.iter().map(|line| normalisation.line(line)).collect();
    let circles = stationary_circles(&normalised)?;
    let stationary_points = circles.len();
    let mut candidates: Vec<_> = circles.into_iter().map(|circle| Candidate::new(&normalised, circle)).collect();
    candidates.sort_by(|left, right| left.rms.total_cmp(&right.rms));
    let exact = candidates.iter().filter(|candidate| candidate.is_exact()).count();
    if exact > 1 {
        return Err(CircleError::Ambiguous { circles: exact });
    }
    let best = candidates.first().ok_or(CircleError::NoCircle)?;
    Ok(CircleFit {
        circle: normalisation.circle(&best.circle),
        rms: best.rms / (2.0 * best.circle.radius) * normalisation.scale,
        stationary_points,
    })
}

/// A stationary point that is a circle, with its root mean square of `r^2 - h^2`. That is evaluated on the lines:
/// `d^T G d` cancels to nothing when the fit is good.
struct Candidate {
    circle: Circle,
    rms: f64,
}

impl Candidate {
    fn new(lines: &[TangentLine], circle: Circle) -> Self {
        let residual = |line: &TangentLine| {
            let distance = line.distance(&circle.centre).abs();
            ((circle.radius - distance) * (circle.radius + distance)).powi(2)
        };
        let mean = lines.iter().map(residual).sum::<f64>() / lines.len() as f64;
        Self { circle, rms: mean.sqrt() }
    }

    fn is_exact(&self) -> bool {
        self.rms <= EXACT_FIT * self.circle.radius.max(1.0).powi(2)
    }
}

/// Coordinates in which the nearest point to all lines is near the origin and their root mean square distance from it is one:
///
/// ```text
///     q = T (p - p0) / scale + q0
/// ```
///
/// The fixed turn `T` and shift `q0` mean nothing. Without them symmetric lines, such as cameras in equal steps around the
/// axis, have their centre at zero and stationary points with equal coordinates, where an eigenvalue of the solver is
/// infinite or double.
struct Normalisation {
    nearest: Point2<f64>,
    scale: f64,
    turn: Rotation2<f64>,
    shift: Vector2<f64>,
}

impl Normalisation {
    fn of(lines: &[TangentLine]) -> Result<Self, CircleError> {
        let count = lines.len() as f64;
        let mut matrix = Matrix2::zeros();
        let mut right = Vector2::zeros();
        for line in lines {
            matrix += line.normal * line.normal.transpose() / count;
            right -= line.normal * line.offset / count;
        }
        if matrix.determinant() <= PARALLEL {
            return Err(CircleError::Parallel);
        }
        let nearest = Point2::from(matrix.try_inverse().ok_or(CircleError::OutOfRange)? * right);
        let square = lines.iter().map(|line| line.distance(&nearest).powi(2)).sum::<f64>() / count;
        if !square.is_finite() {
            return Err(CircleError::OutOfRange);
        }
        Ok(Self { nearest, scale: square.sqrt(), turn: Rotation2::new(1.0), shift: Vector2::new(0.3, 0.2) })
    }

    fn line(&self, line: &TangentLine) -> TangentLine {
        let normal = self.turn * line.normal;
        TangentLine { normal, offset: line.distance(&self.nearest) / self.scale - normal.dot(&self.shift) }
    }

    /// Back to the coordinates of the lines.
    fn circle(&self, circle: &Circle) -> Circle {
        let centre = self.turn.inverse() * (circle.centre.coords - self.shift);
        Circle { centre: self.nearest + centre * self.scale, radius: circle.radius * self.scale }
    }
}
