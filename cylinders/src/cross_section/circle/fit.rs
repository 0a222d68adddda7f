//! The circle of the cross-section by constrained least squares on its dual conic.
//!
//! The tangents of a circle with centre `(x, y)` and radius `r` are the lines `l = (a, b, c)` with
//! `l^T C* l = 0`. Its dual conic, scaled so that `d6 = -1`, is
//!
//! ```text
//!        [ d1 d2 d3 ]   [ r^2 - x^2    -x y     -x ]
//!   C* = [ d2 d4 d5 ] = [   -x y    r^2 - y^2   -y ]     d3 d5 - d2 d6 = 0
//!        [ d3 d5 d6 ]   [    -x         -y      -1 ]     d5^2 - d3^2 + d1 d6 - d4 d6 = 0
//! ```
//!
//! For a line of unit normal at distance `h` from the centre, `l^T C* l = r^2 - h^2`. The circle
//! minimises the sum of its squares, `d^T G d` with `d = (d1, 2 d2, 2 d3, d4, 2 d5, d6)` and the
//! Gram matrix `G` of the rows `(a^2, a b, a c, b^2, b c, c^2)`, subject to the two constraints.
//! The emitted solver `circle_least_squares` returns every stationary point of the Lagrangian,
//! hence the global minimum (Gummeson & Oskarsson, "Robust and Accurate Cylinder Triangulation",
//! eq. (23)-(26)).
//!
//! The method `LeastSquares` returns all stationary points and also weighs the lines. `fit_circle`
//! takes the best one, and returns an error if several circles fit exactly.
//!
//! With few views the best circle can be one that the cameras cannot have seen. Seen from two
//! cameras that stand opposite each other, the lines are nearly parallel in pairs, and a very large
//! circle behind one of the cameras touches all four almost as well as the small circle between
//! them. With noise it can fit better. `fit_circle_in_front` takes the best minimum in front of the
//! cameras instead.

use super::{Circle, CircleError};
use crate::cross_section::least_squares::StationaryCircles;
use crate::cross_section::rectify::TangentLine;
use crate::cross_section::section::SectionLine;
use crate::cross_section::sight::Sight;

/// The lines count as concurrent if their root mean square distance from one point, relative to the
/// extent of the scene, is at most this. It is far below the precision of lines marked in an image,
/// and above rounding.
const CONCURRENT: f64 = 1e-9;

/// The least squares circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CircleFit {
    /// The circle.
    pub circle: Circle,
    /// Root mean square of `(r^2 - h^2) / (2 r)`, to first order the distance `r - h`; world units.
    pub rms: f64,
    /// Number of stationary circles among which this one was chosen.
    pub stationary_points: usize,
}

/// The circle of least cost from at least three tangent lines. `extent` is the size of the scene in
/// world units: the distances of the lines from a common point are compared with it.
///
/// # Errors
/// [`CircleError`].
pub fn fit_circle(lines: &[TangentLine], extent: f64) -> Result<CircleFit, CircleError> {
    fit_circle_in_front(lines, &[], extent)
}

/// Like [`fit_circle`], but returns the best local minimum in front of all cameras, or the global
/// minimum if no local minimum is in front of them. A circle that touches all lines exactly is
/// returned wherever it lies.
///
/// # Errors
/// [`CircleError`].
pub fn fit_circle_in_front(lines: &[TangentLine], sights: &[Sight], extent: f64) -> Result<CircleFit, CircleError> {
    let lines: Vec<_> = lines.iter().map(|&line| SectionLine { line, weight: 1.0, view: 0 }).collect();
    let stationary = StationaryCircles::of(&lines)?;
    if stationary.scale() <= CONCURRENT * extent {
        return Err(CircleError::Concurrent);
    }
    let exact = stationary.exact();
    if exact > 1 {
        return Err(CircleError::Ambiguous { circles: exact });
    }
    let (circle, mean_square) =
        stationary.best(|circle| sights.iter().all(|sight| sight.has_in_front(circle))).ok_or(CircleError::NoCircle)?;
    Ok(CircleFit { circle, rms: mean_square.sqrt() / (2.0 * circle.radius), stationary_points: stationary.len() })
}
