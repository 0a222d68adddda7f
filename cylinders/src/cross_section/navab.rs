//! The method of Navab & Appel, "Canonical Representation and Multi-View Geometry of Cylinders"
//! (International Journal of Computer Vision, 2006), in the plane of the cross-section: the second
//! baseline of Gummeson & Oskarsson, "Robust and Accurate Cylinder Triangulation".
//!
//! The canonical representation of a cylinder in a view is the plane through camera centre and
//! axis, with the angle `theta` between it and either silhouette plane. With both normals pointing
//! at the axis,
//!
//! ```text
//!   l_1, l_2 = sin(theta) e +- cos(theta) m   m: unit normal of the plane through centre and axis
//!                                               e: unit vector from the centre towards the axis
//! ```
//!
//! so that `l_1 - l_2 = 2 cos(theta) m` is a line through the centre of the circle, the bisector,
//! and `l_1 + l_2 = 2 sin(theta) e` has the value `2 r` there. The axis is triangulated from the
//! bisectors of all views by linear least squares, as a line is from its images. Every view then
//! gives a radius, and the result is their mean.
//!
//! The implementation departs from the paper in this: the direction of the axis is that of the
//! rectification, as for all methods here, whereas the original solves for direction and position
//! together. Lines carry no sign, so the bisector of the acute angle is taken, and a camera must be
//! further than `sqrt(2) r` from the axis. The weight of a view is `1 / (1 / w_1 + 1 / w_2)`, as
//! for the difference of independent measurements. A single line of a view is not used.
//!
//! Gummeson & Oskarsson report errors of the method that, with five images or more, contain a
//! constant which this implementation does not have. The experiment `table1` compares both.

use std::collections::BTreeMap;

use nalgebra::{Matrix2, Point2, Vector2, Vector3};

use super::circle::{Circle, CircleError};
use super::rectify::TangentLine;
use super::section::{Section, SectionError, SectionLine, SectionSolver, check_lines};

/// All bisectors count as parallel if the determinant of the mean of `m m^T` is at most this, the
/// square of an angle of 1e-6.
const PARALLEL: f64 = 1e-12;

/// The lines of all pairs count as equal if the radius, relative to the largest distance of a line
/// from the origin, is at most this.
const REPEATED: f64 = 1e-13;

/// The method `navab`: one circle.
#[derive(Clone, Copy, Debug, Default)]
pub struct Navab;

/// Bisector of the acute angle of a pair of lines, and the line `(l_1 + l_2) / 2`, whose value at
/// the centre is `+-r`.
struct Pair {
    bisector: TangentLine,
    half_sum: Vector3<f64>,
    weight: f64,
}

impl Pair {
    /// Fails if the weight is zero.
    fn new(first: &SectionLine, second: &SectionLine) -> Option<Self> {
        let [l1, l2] = [first, second].map(|line| line.line.normal.push(line.line.offset));
        // Normals that point at a circle inside the acute angle are more than 90 degrees apart.
        let l2 = if l1.xy().dot(&l2.xy()) > 0.0 { -l2 } else { l2 };
        let difference = l1 - l2;
        let norm = difference.xy().norm();
        let weight = first.weight * second.weight / (first.weight + second.weight);
        let bisector = TangentLine { normal: difference.xy() / norm, offset: difference.z / norm };
        (weight > 0.0).then(|| Self { bisector, half_sum: (l1 + l2) / 2.0, weight })
    }
}

impl SectionSolver for Navab {
    fn name(&self) -> &'static str {
        "navab"
    }

    fn least_lines(&self) -> usize {
        4
    }

    fn solve(&self, lines: &[SectionLine]) -> Result<Vec<Section>, SectionError> {
        check_lines(lines, self.least_lines())?;
        let mut views: BTreeMap<usize, Vec<&SectionLine>> = BTreeMap::new();
        for line in lines {
            views.entry(line.view).or_default().push(line);
        }
        let mut pairs = Vec::new();
        for (view, lines) in views {
            match lines.as_slice() {
                [_] => {}
                [first, second] => pairs.extend(Pair::new(first, second)),
                lines => return Err(SectionError::NotAPair { view, lines: lines.len() }),
            }
        }
        if pairs.len() < 2 {
            return Err(SectionError::TooFewPairs { pairs: pairs.len() });
        }
        let circle = circle(&pairs)?;
        let extent = lines.iter().map(|line| line.line.offset.abs()).fold(0.0, f64::max);
        if circle.radius <= REPEATED * extent {
            return Err(CircleError::Concurrent.into());
        }
        Ok(vec![Section::from_circle(circle, lines)])
    }
}

/// The point nearest to all bisectors, with the mean of the radii there.
fn circle(pairs: &[Pair]) -> Result<Circle, CircleError> {
    let total: f64 = pairs.iter().map(|pair| pair.weight).sum();
    let mut matrix = Matrix2::zeros();
    let mut right = Vector2::zeros();
    for Pair { bisector, weight, .. } in pairs {
        matrix += bisector.normal * bisector.normal.transpose() * (weight / total);
        right -= bisector.normal * (bisector.offset * weight / total);
    }
    if matrix.determinant() <= PARALLEL {
        return Err(CircleError::Parallel);
    }
    let centre = Point2::from(matrix.try_inverse().ok_or(CircleError::OutOfRange)? * right);
    let radius = |pair: &Pair| pair.weight / total * pair.half_sum.dot(&centre.to_homogeneous()).abs();
    let circle = Circle { centre, radius: pairs.iter().map(radius).sum() };
    if circle.radius.is_finite() { Ok(circle) } else { Err(CircleError::OutOfRange) }
}
