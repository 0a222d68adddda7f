//! A flat band, as a tile or the side of a box, has two edges that are fixed in space. From a
//! narrow range of angles they look nearly like the silhouettes of a cylinder.
//!
//! ```text
//!   circle: the lines on both sides have the distance r from one point p      3 parameters
//!   band:   the lines on either side pass through a point of their own        4 parameters
//! ```
//!
//! `k` lines with a sum of squares `S` under normal noise of unknown size have a likelihood whose
//! logarithm is `-k/2 ln S`.

use nalgebra::{Matrix2, Unit, Vector2, Vector3};

use super::found::MatchedCylinder;
use super::plan::{Plan, PlanMatch};
use crate::cross_section::circle::Circle;
use crate::observations::view::View;
use crate::space::cylinder::Side;

/// Twice the logarithm of the likelihood ratio at which a circle is none, or a band is none.
const DECISIVE: f64 = 6.0;

/// One of so many lines may be that of something else.
const LEFT_OUT: usize = 4;

/// Root mean square distances are not taken as smaller, radians.
const LEAST_DISTANCE: f64 = 5e-5;

/// A line of the cross-section, as a silhouette.
struct Silhouette {
    side: Side,
    /// Unit normal.
    normal: Vector2<f64>,
    /// From the camera to the centre of the circle.
    to_centre: Vector2<f64>,
}

/// Whether two edges explain the matches of a circle much better than the circle does.
pub(super) fn is_band(plan: &Plan, circle: &Circle, matches: &[PlanMatch]) -> bool {
    let silhouette = |found: &PlanMatch| Silhouette {
        side: found.side,
        normal: plan.normal(found.line),
        to_centre: circle.centre - plan.views()[plan.id(found.line).view].centre,
    };
    let silhouettes: Vec<_> = matches.iter().map(silhouette).collect();
    ratio(&silhouettes, circle.radius) < -DECISIVE
}

impl MatchedCylinder {
    /// Whether its lines in the views of the search say that it is round, even if a quarter of them
    /// are left out. Otherwise a flat band in space could look like it.
    pub fn is_round(&self, views: &[View]) -> bool {
        let direction = &self.cylinder.direction;
        let first = Unit::new_normalize(direction.cross(&Vector3::ith(direction.iamin(), 1.0)));
        let second = direction.cross(&first);
        let flat = |vector: &Vector3<f64>| Vector2::new(first.dot(vector), second.dot(vector));
        let silhouettes = self.matches.iter().filter_map(|found| {
            let plane = views.get(found.view)?.planes().nth(found.line)?;
            let normal = flat(&plane.normal).normalize();
            Some(Silhouette { side: found.side, normal, to_centre: flat(&self.cylinder.vector_to_axis(&plane.centre)) })
        });
        least_ratio(silhouettes.collect(), self.cylinder.radius) > DECISIVE
    }
}

/// The ratio without those lines that make it the largest, as a line of another edge does.
fn least_ratio(mut silhouettes: Vec<Silhouette>, radius: f64) -> f64 {
    let mut least = ratio(&silhouettes, radius);
    for _ in 0..silhouettes.len() / LEFT_OUT {
        let last = silhouettes.len() - 1;
        let mut best = (f64::INFINITY, last);
        for place in 0..=last {
            silhouettes.swap(place, last);
            let without = ratio(&silhouettes[..last], radius);
            if without < best.0 {
                best = (without, place);
            }
            silhouettes.swap(place, last);
        }
        silhouettes.swap_remove(best.1);
        least = least.min(best.0);
    }
    least
}

/// Twice the logarithm of the likelihood ratio of a circle of this radius and of two edges.
fn ratio(silhouettes: &[Silhouette], radius: f64) -> f64 {
    let (mut of_circle, mut of_band) = (0.0, 0.0);
    for side in [Side::Left, Side::Right] {
        let (mut matrix, mut vector, mut square) = (Matrix2::zeros(), Vector2::zeros(), 0.0);
        for Silhouette { normal, to_centre, .. } in silhouettes.iter().filter(|line| line.side == side) {
            // Angles.
            let away = to_centre.norm();
            let (normal, distance) = (normal / away, normal.dot(to_centre) / away);
            of_circle += (distance.abs() - radius / away).powi(2);
            // The normals of one side may have either sign.
            matrix += normal * normal.transpose();
            vector -= normal * distance;
            square += distance * distance;
        }
        // The edge is at `inverse * vector` from the centre. One line or none has no distance.
        of_band += matrix.try_inverse().map_or(0.0, |inverse| (square - vector.dot(&(inverse * vector))).max(0.0));
    }
    let count = silhouettes.len() as f64;
    let least = count * LEAST_DISTANCE * LEAST_DISTANCE;
    count * ((of_band + least) / (of_circle + least)).ln()
}
