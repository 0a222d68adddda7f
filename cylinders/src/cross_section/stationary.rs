//! All circles at which the least squares cost is stationary, from the Gram matrix by the emitted
//! solver.
//!
//! For a centre at the distances `h_i` from the lines the best squared radius is the mean of
//! `h_i^2`. The cost is then a quartic in the centre, and its nine stationary points are the
//! intersections of two cubics. The leading forms of the cubics share a factor if the directions of
//! the lines are *balanced*: the fourth-order mean of the normals has a symmetry, as for the sides
//! of a regular polygon, cameras on a ring in equal steps, or two pairs of parallel lines. Some of
//! the nine points are then at infinity and the elimination loses rank, but the minimum stays
//! finite. A small perturbation makes the data generic:
//!
//! ```text
//!   G balanced --> G + epsilon S generic --> nine points
//!     --> Newton's method on the lines --> points of G
//! ```
//!
//! with a fixed symmetric matrix `S`. The points that are at infinity for `G` become finite but far
//! away, and their cost is large.
//!
//! A solver that computes its solutions from eigenvectors can miss some if eigenvalues nearly
//! coincide, and this depends on the coordinates. A count shows whether a real point is missing:
//! the quartic grows towards infinity on all sides, so its minima and maxima outnumber its saddle
//! points by exactly one (Poincare and Hopf). Until this holds, the problem is solved again in
//! turned coordinates, and new points are added.

use eliminant::SolveError;
use nalgebra::{Matrix2, Point2, Vector2};

use super::circle::Circle;
use super::normalise::{generic_motion, moved_line};
use super::section::SectionLine;

/// Size `epsilon` of the entries added to a Gram matrix whose entries are of order one. Its square
/// is below rounding, so that Newton's method needs two steps. Its inverse is the condition of the
/// elimination and leaves ten digits to start from.
const PERTURBATION: f64 = 1e-6;

/// Angles by which the coordinates are turned, one after the other, until no stationary point is
/// missing, radians.
const TURNS: [f64; 4] = [1.0, 1.9, 2.5, 0.4];

/// Limit on the steps of Newton's method.
const NEWTON_STEPS: usize = 10;

/// Newton's method has converged if its step is at most this, relative to the larger of one and the
/// distance of the centre from the origin. The next step would be of the size of its square.
const CONVERGED: f64 = 1e-9;

/// Two circles are the same if the distance of their centres is at most this, relative to the
/// larger of one and the radius.
const SAME_CIRCLE: f64 = 1e-7;

/// A circle at which the cost is stationary.
pub(crate) struct StationaryPoint {
    pub(crate) circle: Circle,
    pub(crate) kind: Kind,
}

/// The kind of a stationary point of the cost as a function of the centre.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(crate) enum Kind {
    Minimum,
    Maximum,
    Saddle,
}

impl Kind {
    /// 1 for a minimum or maximum, -1 for a saddle point.
    fn index(self) -> i32 {
        if self == Self::Saddle { -1 } else { 1 }
    }
}

/// All real circles at which the cost is stationary. Coordinates must be normalised, so that the
/// distances of the lines from the origin are of order one.
pub(crate) fn stationary_points(lines: &[SectionLine]) -> Result<Vec<StationaryPoint>, SolveError> {
    let mut points: Vec<StationaryPoint> = Vec::new();
    let mut failure = None;
    for turn in TURNS {
        match solve_turned(lines, turn) {
            Ok(centres) => {
                for point in centres.into_iter().filter_map(|centre| polish(lines, centre)) {
                    if !points.iter().any(|other| same(&other.circle, &point.circle)) {
                        points.push(point);
                    }
                }
            }
            Err(error) => failure = Some(error),
        }
        if points.iter().map(|point| point.kind.index()).sum::<i32>() == 1 {
            break;
        }
    }
    match failure {
        Some(error) if points.is_empty() => Err(error),
        _ => Ok(points),
    }
}

/// Centres of the stationary circles, computed in turned coordinates.
fn solve_turned(lines: &[SectionLine], turn: f64) -> Result<Vec<Point2<f64>>, SolveError> {
    let motion = generic_motion(turn);
    let moved: Vec<_> =
        lines.iter().map(|line| SectionLine { line: moved_line(&motion, &line.line), ..*line }).collect();
    let gram = gram(&moved);
    let solutions = match eliminant_solvers::circle_least_squares::solve(&gram) {
        Ok(solutions) if !solutions.is_empty() => solutions,
        Ok(_) | Err(SolveError::Degenerate { .. } | SolveError::Overflow) => {
            eliminant_solvers::circle_least_squares::solve(&perturbed(&gram))?
        }
        Err(error) => return Err(error),
    };
    let back = motion.inverse();
    Ok(solutions.into_iter().map(|point| back * Point2::new(-point.d3, -point.d5)).collect())
}

/// Weighted mean over the lines of `row^T row` with `row = (a^2, a b, a c, b^2, b c, c^2)`.
fn gram(lines: &[SectionLine]) -> [[f64; 6]; 6] {
    let total: f64 = lines.iter().map(|line| line.weight).sum();
    let mut gram = [[0.0; 6]; 6];
    for SectionLine { line, weight, .. } in lines {
        let (a, b, c) = (line.normal.x, line.normal.y, line.offset);
        let row = [a * a, a * b, a * c, b * b, b * c, c * c];
        for i in 0..6 {
            for j in 0..6 {
                gram[i][j] += row[i] * row[j] * (weight / total);
            }
        }
    }
    gram
}

/// `G + epsilon S`, with a symmetric matrix `S` without structure.
fn perturbed(gram: &[[f64; 6]; 6]) -> [[f64; 6]; 6] {
    let mut perturbed = *gram;
    for i in 0..6 {
        for j in 0..6 {
            perturbed[i][j] += PERTURBATION * (((i + 1) * (j + 1)) as f64).cos();
        }
    }
    perturbed
}

/// Newton's method for a stationary centre. With `e_i = h_i^2 - s` and `s` the mean of `h_i^2`,
/// gradient and Hessian of the mean of `e_i^2` are, up to a factor of four,
///
/// ```text
///   g = mean(e_i h_i n_i),    H = mean((3 h_i^2 - s) n_i n_i^T) - 2 m m^T,    m = mean(h_i n_i)
/// ```
///
/// `None` if it does not converge: the start was not near a stationary point.
fn polish(lines: &[SectionLine], mut centre: Point2<f64>) -> Option<StationaryPoint> {
    let total: f64 = lines.iter().map(|line| line.weight).sum();
    let mean_square = |centre: &Point2<f64>| {
        lines.iter().map(|line| line.weight / total * line.line.distance(centre).powi(2)).sum::<f64>()
    };
    for _ in 0..NEWTON_STEPS {
        let square = mean_square(&centre);
        let (mut gradient, mut hessian, mut moment) = (Vector2::zeros(), Matrix2::zeros(), Vector2::zeros());
        for SectionLine { line, weight, .. } in lines {
            let (normal, distance, weight) = (line.normal, line.distance(&centre), weight / total);
            let squared = distance * distance;
            gradient += normal * ((squared - square) * distance * weight);
            hessian += normal * normal.transpose() * ((3.0 * squared - square) * weight);
            moment += normal * (distance * weight);
        }
        hessian -= moment * moment.transpose() * 2.0;
        let step = hessian.try_inverse()? * gradient;
        centre -= step;
        if step.norm() <= CONVERGED * centre.coords.norm().max(1.0) {
            let kind = match (hessian.determinant() > 0.0, hessian.trace() > 0.0) {
                (true, true) => Kind::Minimum,
                (true, false) => Kind::Maximum,
                (false, _) => Kind::Saddle,
            };
            let radius = mean_square(&centre).sqrt();
            return (radius.is_finite() && radius > 0.0)
                .then_some(StationaryPoint { circle: Circle { centre, radius }, kind });
        }
    }
    None
}

fn same(left: &Circle, right: &Circle) -> bool {
    (left.centre - right.centre).norm() <= SAME_CIRCLE * left.radius.max(1.0)
}
