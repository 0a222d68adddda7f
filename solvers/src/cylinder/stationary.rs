//! Step 3a: all circles at which the least squares cost is stationary, from the Gram matrix by the emitted solver.
//!
//! For a centre at the distances `h_i` from the lines the best squared radius is the mean of `h_i^2`. What remains is a quartic
//! in the centre, and its nine stationary points are the intersections of two cubics. Where the directions of the lines
//! are *balanced* (the fourth-order mean of the normals has a symmetry: the sides of a regular polygon, cameras on a ring in
//! equal steps, two pairs of parallel lines), the leading forms of the cubics have a factor in common. Some of the
//! nine points are then at infinity and the elimination loses rank. That is a property of the nine, not of the minimum:
//!
//! ```text
//!   G balanced --> G + epsilon S generic --> nine points --> Newton's method on the lines --> points of G
//! ```
//!
//! with a fixed symmetric matrix `S`. Points that `G` has at infinity are far away and lose by their cost.

use eliminant::SolveError;
use nalgebra::{Matrix2, Point2, Vector2};

use super::circle::Circle;
use super::rectify::TangentLine;

/// Size `epsilon` of the entries added to a Gram matrix whose entries are of order one. Its square is below rounding,
/// so that Newton's method needs two steps; its inverse, the condition of the elimination, leaves ten digits to start from.
const PERTURBATION: f64 = 1e-6;

/// Limit on the steps of Newton's method.
const NEWTON_STEPS: usize = 6;

/// Distance of centres, relative to the radius or one, below which two circles found are the same.
const SAME_CIRCLE: f64 = 1e-7;

/// All real circles at which the cost is stationary. Coordinates must be normalised: the lines' distances from the
/// origin are of order one.
pub(super) fn stationary_circles(lines: &[TangentLine]) -> Result<Vec<Circle>, SolveError> {
    let gram = gram(lines);
    match solve(&gram) {
        Ok(circles) if !circles.is_empty() => Ok(circles),
        Ok(_) | Err(SolveError::Degenerate { .. }) => {
            let mut circles = Vec::new();
            for circle in solve(&perturbed(&gram))? {
                if let Some(circle) = polish(lines, circle.centre)
                    && !circles.iter().any(|other| same(other, &circle))
                {
                    circles.push(circle);
                }
            }
            Ok(circles)
        }
        Err(error) => Err(error),
    }
}

/// Mean over the lines of `row^T row` with `row = (a^2, a b, a c, b^2, b c, c^2)`.
fn gram(lines: &[TangentLine]) -> [[f64; 6]; 6] {
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

/// The stationary points that are circles of positive squared radius `d1 + d3^2`.
fn solve(gram: &[[f64; 6]; 6]) -> Result<Vec<Circle>, SolveError> {
    let circle = |point: crate::circle_least_squares::CircleLeastSquares| {
        let square = point.d1 + point.d3 * point.d3;
        (square > 0.0).then(|| Circle { centre: Point2::new(-point.d3, -point.d5), radius: square.sqrt() })
    };
    Ok(crate::circle_least_squares::solve(gram)?.into_iter().filter_map(circle).collect())
}

/// `G + epsilon S`, with a symmetric matrix `S` of no particular structure.
fn perturbed(gram: &[[f64; 6]; 6]) -> [[f64; 6]; 6] {
    let mut perturbed = *gram;
    for i in 0..6 {
        for j in 0..6 {
            perturbed[i][j] += PERTURBATION * (((i + 1) * (j + 1)) as f64).cos();
        }
    }
    perturbed
}

/// Newton's method for a stationary centre. With `e_i = h_i^2 - s` and `s` the mean of `h_i^2`, gradient and Hessian of the
/// mean of `e_i^2` are, but for a factor of four,
///
/// ```text
///   g = mean(e_i h_i n_i),    H = mean((3 h_i^2 - s) n_i n_i^T) - 2 m m^T,    m = mean(h_i n_i)
/// ```
///
/// `None` where it leaves the range of numbers.
fn polish(lines: &[TangentLine], mut centre: Point2<f64>) -> Option<Circle> {
    let count = lines.len() as f64;
    let mean_square =
        |centre: &Point2<f64>| lines.iter().map(|line| line.distance(centre).powi(2)).sum::<f64>() / count;
    for _ in 0..NEWTON_STEPS {
        let square = mean_square(&centre);
        let (mut gradient, mut hessian, mut moment) = (Vector2::zeros(), Matrix2::zeros(), Vector2::zeros());
        for line in lines {
            let (normal, distance) = (line.normal, line.distance(&centre));
            let squared = distance * distance;
            gradient += normal * ((squared - square) * distance / count);
            hessian += normal * normal.transpose() * ((3.0 * squared - square) / count);
            moment += normal * (distance / count);
        }
        hessian -= moment * moment.transpose() * 2.0;
        centre -= hessian.try_inverse()? * gradient;
    }
    let radius = mean_square(&centre).sqrt();
    (radius.is_finite() && radius > 0.0).then_some(Circle { centre, radius })
}

fn same(left: &Circle, right: &Circle) -> bool {
    (left.centre - right.centre).norm() <= SAME_CIRCLE * left.radius.max(1.0)
}
