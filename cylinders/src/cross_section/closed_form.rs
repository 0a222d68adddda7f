//! The circles tangent to three lines in closed form: incircle and three excircles of their
//! triangle.
//!
//! A circle touches the lines `l_i = (n_i, c_i)` if its centre has the signed distances
//! `n_i^T p + c_i = s_i r` with `s_i = +-1`. For each choice of signs, up to a common factor, these
//! are three linear equations in `p` and `r`. With `D_1 = n_2 x n_3` (the sine of the angle at the
//! vertex `l_2 x l_3`), and `D_2`, `D_3` alike, Cramer's rule gives
//!
//! ```text
//!   (p, 1) ~ s_1 (l_2 x l_3) + s_2 (l_3 x l_1) + s_3 (l_1 x l_2)
//!   r = |det [l_1 l_2 l_3]| / |s_1 D_1 + s_2 D_2 + s_3 D_3|
//! ```
//!
//! With `s_i = sign D_i` the denominator is `|D_1| + |D_2| + |D_3|`, and the circle is the
//! incircle. With one sign reversed it is the excircle beside that line, and by the triangle
//! inequality the denominator is not negative. If two of the lines are parallel, two denominators
//! vanish and two circles remain.

use eliminant::Solutions;
use nalgebra::{Point2, Vector3};

use super::circle::{Circle, CircleError};
use super::rectify::TangentLine;
use super::section::{Section, SectionError, SectionLine, SectionSolver, three_lines};

/// All three lines count as parallel if the largest sine of their angles is at most this.
const PARALLEL: f64 = 1e-6;

/// The lines count as concurrent if their determinant, relative to the sum of its terms, is at most
/// this: rounding leaves only three digits.
const CONCURRENT: f64 = 1e-13;

/// A circle counts as infinite if its denominator, relative to that of the incircle, is at most
/// this: rounding leaves only four digits.
const INFINITE: f64 = 1e-12;

/// The four circles tangent to three lines, the incircle first; two circles if two of the lines are
/// parallel. Does not allocate.
///
/// # Errors
/// [`CircleError::Parallel`], [`CircleError::Concurrent`] (also if a line is repeated),
/// [`CircleError::OutOfRange`].
pub fn tangent_circles(lines: &[TangentLine; 3]) -> Result<Solutions<Circle, 4>, CircleError> {
    let [l1, l2, l3] = lines.map(|line| Vector3::new(line.normal.x, line.normal.y, line.offset));
    let mut vertices = [l2.cross(&l3), l3.cross(&l1), l1.cross(&l2)];
    let terms = [l1.z * vertices[0].z, l2.z * vertices[1].z, l3.z * vertices[2].z];
    let determinant = terms.iter().sum::<f64>().abs();
    if !determinant.is_finite() {
        return Err(CircleError::OutOfRange);
    }
    let sines = vertices.map(|vertex| vertex.z.abs());
    if sines.iter().all(|&sine| sine <= PARALLEL) {
        return Err(CircleError::Parallel);
    }
    if determinant <= CONCURRENT * terms.iter().map(|term| term.abs()).sum::<f64>() {
        return Err(CircleError::Concurrent);
    }
    for vertex in &mut vertices {
        *vertex *= vertex.z.signum();
    }
    let incentre = vertices[0] + vertices[1] + vertices[2];
    let mut circles = Solutions::new();
    let mut push = |centre: Vector3<f64>| {
        if centre.z > INFINITE * incentre.z {
            let radius = determinant / centre.z;
            circles.push(Circle { centre: Point2::new(centre.x / centre.z, centre.y / centre.z), radius });
        }
    };
    push(incentre);
    for vertex in vertices {
        push(incentre - vertex * 2.0);
    }
    Ok(circles)
}

/// The method `closed-form`: incircle and excircles of exactly three lines, by radius.
#[derive(Clone, Copy, Debug, Default)]
pub struct ClosedForm;

impl SectionSolver for ClosedForm {
    fn name(&self) -> &'static str {
        "closed-form"
    }

    fn least_lines(&self) -> usize {
        3
    }

    fn solve(&self, lines: &[SectionLine]) -> Result<Vec<Section>, SectionError> {
        let mut circles = tangent_circles(&three_lines(lines)?)?;
        circles.sort_by(|left, right| left.radius.total_cmp(&right.radius));
        Ok(circles.into_iter().map(|circle| Section::from_circle(circle, lines)).collect())
    }
}
