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

use nalgebra::{Matrix2, Point2, Vector2};
use thiserror::Error;

use super::rectify::TangentLine;

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
    /// Number of real stationary points among which it was chosen.
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
    #[error("none of the {stationary_points} real stationary points is a circle")]
    NoCircle {
        /// Number of real stationary points.
        stationary_points: usize,
    },
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
    let stationary_points = stationary_points(&gram(&normalised))?;

    let mut candidates: Vec<_> = stationary_points
        .iter()
        .map(|&[d1, _, d3, _, d5]| (Point2::new(-d3, -d5), d1 + d3 * d3))
        .filter(|&(_, radius_squared)| radius_squared > 0.0)
        .map(|(centre, radius_squared)| Candidate::new(&normalised, centre, radius_squared.sqrt()))
        .collect();
    candidates.sort_by(|left, right| left.rms.total_cmp(&right.rms));
    let exact = candidates.iter().filter(|candidate| candidate.is_exact()).count();
    if exact > 1 {
        return Err(CircleError::Ambiguous { circles: exact });
    }
    let best = candidates.first().ok_or(CircleError::NoCircle { stationary_points: stationary_points.len() })?;
    Ok(CircleFit {
        circle: normalisation.circle(&best.circle),
        rms: best.rms / (2.0 * best.circle.radius) * normalisation.scale,
        stationary_points: stationary_points.len(),
    })
}

/// Mean over the lines of `row^T row` with `row = (a^2, a b, a c, b^2, b c, c^2)`.
pub fn gram(lines: &[TangentLine]) -> [[f64; 6]; 6] {
    let mut gram = [[0.0; 6]; 6];
    for line in lines {
        let (a, b, c) = (line.normal.x, line.normal.y, line.offset);
        let row = [a * a, a * b, a * c, b * b, b * c, c * c];
        for i in 0..6 {
            for j in 0..6 {
                gram[i][j] += row[i] * row[j] / lines.len() as f64;
            }
        }
    }
    gram
}

/// All real stationary points `(d1, .., d5)` of the least squares problem with this Gram matrix.
fn stationary_points(gram: &[[f64; 6]; 6]) -> Result<Vec<[f64; 5]>, CircleError> {
    let solutions = crate::circle_least_squares::solve(gram)?;
    Ok(solutions.iter().map(|point| [point.d1, point.d2, point.d3, point.d4, point.d5]).collect())
}

/// A stationary point that is a circle, with its root mean square of `r^2 - h^2`. That is evaluated on the lines:
/// `d^T G d` cancels to nothing when the fit is good.
struct Candidate {
    circle: Circle,
    rms: f64,
}

impl Candidate {
    fn new(lines: &[TangentLine], centre: Point2<f64>, radius: f64) -> Self {
        let residual = |line: &TangentLine| {
            let distance = line.distance(&centre).abs();
            ((radius - distance) * (radius + distance)).powi(2)
        };
        let mean = lines.iter().map(residual).sum::<f64>() / lines.len() as f64;
        Self { circle: Circle { centre, radius }, rms: mean.sqrt() }
    }

    fn is_exact(&self) -> bool {
        self.rms <= EXACT_FIT * self.circle.radius.max(1.0).powi(2)
    }
}

/// Shift to the point nearest to all lines, and division by the root mean square distance from it.
struct Normalisation {
    centre: Point2<f64>,
    scale: f64,
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
        let centre = Point2::from(matrix.try_inverse().ok_or(CircleError::OutOfRange)? * right);
        let square = lines.iter().map(|line| line.distance(&centre).powi(2)).sum::<f64>() / count;
        if square.is_finite() { Ok(Self { centre, scale: square.sqrt() }) } else { Err(CircleError::OutOfRange) }
    }

    fn line(&self, line: &TangentLine) -> TangentLine {
        TangentLine { normal: line.normal, offset: line.distance(&self.centre) / self.scale }
    }

    fn circle(&self, circle: &Circle) -> Circle {
        Circle { centre: self.centre + circle.centre.coords * self.scale, radius: circle.radius * self.scale }
    }
}
