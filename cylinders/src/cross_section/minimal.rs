//! The circles tangent to three lines by the emitted solver `circle_minimal` (Gummeson & Oskarsson,
//! "Robust and Accurate Cylinder Triangulation", the minimal solver).
//!
//! Each line is one linear equation in the dual conic. The null space of three equations has
//! dimension three:
//!
//! ```text
//!   [ a1^2  2 a1 b1  2 a1 c1  b1^2  2 b1 c1  c1^2 ]
//!   [ a2^2  2 a2 b2  2 a2 c2  b2^2  2 b2 c2  c2^2 ] d = 0,    d = a d_alpha + b d_beta + d_gamma
//!   [ a3^2  2 a3 b3  2 a3 c3  b3^2  2 b3 c3  c3^2 ]
//! ```
//!
//! The paper leaves the choice of the basis open. Here `d6 = 0` in `d_alpha` and `d_beta`, so that
//! the coefficient of `d_gamma` is not zero for any circle with a finite centre.
//!
//! A circle much larger than the triangle is a solution near infinity: `a` and `b` grow with its
//! squared radius, and their products of degree two cancel. With a radius of 10^5 only six digits
//! are left in the equations above. The circle is therefore polished on the lines, where nothing
//! cancels. If the sides on which it touches the lines are given, Newton's method for
//!
//! ```text
//!   n_i^T p + c_i = s_i r,      s_i = sign(n_i^T p + c_i)
//! ```
//!
//! is one linear step. The four circles differ in their sides, so a circle that was found twice is
//! recognised by them.

use eliminant::{Solutions, SolveError};
use nalgebra::{Matrix3, Matrix6, Matrix6x3, Point2, RowVector3, Vector3};

use super::circle::{Circle, CircleError};
use super::normalise::{Normalisation, generic_motion, moved_line};
use super::rectify::TangentLine;
use super::section::{Section, SectionError, SectionLine, SectionSolver, three_lines};

/// Angles by which the coordinates are turned, one after the other, until all four circles are
/// found, radians.
const TURNS: [f64; 4] = [1.0, 1.9, 2.5, 0.4];

/// The circles tangent to three lines, in no particular order; two circles if two of the lines are
/// parallel. Does not allocate.
///
/// If the circles differ in size by many orders of magnitude, eigenvalues nearly coincide and some
/// circles may be missing. [`tangent_circles`](super::closed_form::tangent_circles) finds all of
/// them, and is faster.
///
/// # Errors
/// [`CircleError::Parallel`], [`CircleError::Concurrent`] (also if a line is repeated),
/// [`CircleError::OutOfRange`], [`CircleError::Solver`].
pub fn minimal_circles(lines: &[TangentLine; 3]) -> Result<Solutions<Circle, 4>, CircleError> {
    let normalisation = Normalisation::of(&lines.map(|line| SectionLine { line, weight: 1.0, view: 0 }))?;
    let normalised = lines.map(|line| normalisation.line(&line));
    let mut found = Solutions::<(Circle, Vector3<f64>), 4>::new();
    let mut failure = None;
    for turn in TURNS {
        match circles_turned(&normalised, turn) {
            Ok(circles) => {
                for (circle, sides) in circles.iter().filter_map(|circle| polish(&normalised, circle)) {
                    if found.iter().all(|(_, others)| *others != sides) {
                        found.push((circle, sides));
                    }
                }
            }
            Err(error) => failure = Some(error),
        }
        if found.len() == 4 {
            break;
        }
    }
    match failure {
        Some(error) if found.is_empty() => Err(error.into()),
        _ => Ok(found.map(|(circle, _)| normalisation.circle(&circle))),
    }
}

/// The circles in normalised coordinates, computed in turned coordinates.
fn circles_turned(lines: &[TangentLine; 3], turn: f64) -> Result<Solutions<Circle, 4>, SolveError> {
    let motion = generic_motion(turn);
    let [d_alpha, d_beta, d_gamma] = null_space(&lines.map(|line| moved_line(&motion, &line)));
    let back = motion.inverse();
    let circle = |solution: eliminant_solvers::circle_minimal::Solution| {
        let entry = |index: usize| solution.a * d_alpha[index] + solution.b * d_beta[index] + d_gamma[index];
        let scale = -1.0 / d_gamma[5];
        let [d1, d3, d4, d5] = [0, 2, 3, 4].map(|index| entry(index) * scale);
        // The two values are equal up to rounding.
        let square = (d1 + d3 * d3 + d4 + d5 * d5) / 2.0;
        (square > 0.0).then(|| Circle { centre: back * Point2::new(-d3, -d5), radius: square.sqrt() })
    };
    Ok(eliminant_solvers::circle_minimal::solve(&d_alpha, &d_beta, &d_gamma)?.filter_map(circle))
}

/// The circle that touches the lines on the same sides as the given one, and these sides; `None` if
/// there is no such circle.
fn polish(lines: &[TangentLine; 3], circle: &Circle) -> Option<(Circle, Vector3<f64>)> {
    let distances = Vector3::from(lines.map(|line| line.distance(&circle.centre)));
    let sides = distances.map(f64::signum);
    let row = |index: usize| RowVector3::new(lines[index].normal.x, lines[index].normal.y, -sides[index]);
    let step = Matrix3::from_rows(&[row(0), row(1), row(2)]).lu().solve(&(distances - sides * circle.radius))?;
    let polished = Circle { centre: circle.centre - step.xy(), radius: circle.radius - step.z };
    (polished.radius > 0.0 && step.iter().all(|entry| entry.is_finite())).then_some((polished, sides))
}

/// Orthonormal basis of the null space of the three rows. The last entry of its first two vectors
/// is zero.
fn null_space(lines: &[TangentLine; 3]) -> [[f64; 6]; 3] {
    // The null space is spanned by the last three columns of the orthogonal factor of the
    // transposed rows, which are padded with zeros.
    let mut transposed = Matrix6::zeros();
    for (index, line) in lines.iter().enumerate() {
        let (a, b, c) = (line.normal.x, line.normal.y, line.offset);
        transposed.set_column(index, &[a * a, 2.0 * a * b, 2.0 * a * c, b * b, 2.0 * b * c, c * c].into());
    }
    let basis: Matrix6x3<f64> = transposed.qr().q().fixed_columns::<3>(3).into_owned();
    // A Householder reflection of the basis takes its last row to (0, 0, -+norm).
    let last = basis.row(5).transpose();
    let mut axis = last;
    axis.z += last.norm().copysign(last.z);
    let reflected = basis - basis * axis * axis.transpose() * (2.0 / axis.norm_squared());
    let column = |index: usize| std::array::from_fn(|row| reflected[(row, index)]);
    let mut null_space: [[f64; 6]; 3] = [column(0), column(1), column(2)];
    null_space[0][5] = 0.0;
    null_space[1][5] = 0.0;
    null_space
}

/// The method `minimal`: the circles that touch exactly three lines, by radius.
#[derive(Clone, Copy, Debug, Default)]
pub struct Minimal;

impl SectionSolver for Minimal {
    fn name(&self) -> &'static str {
        "minimal"
    }

    fn least_lines(&self) -> usize {
        3
    }

    fn solve(&self, lines: &[SectionLine]) -> Result<Vec<Section>, SectionError> {
        let mut circles = minimal_circles(&three_lines(lines)?)?;
        if circles.is_empty() {
            return Err(CircleError::NoCircle.into());
        }
        circles.sort_by(|left, right| left.radius.total_cmp(&right.radius));
        Ok(circles.into_iter().map(|circle| Section::from_circle(circle, lines)).collect())
    }
}
