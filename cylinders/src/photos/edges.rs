//! Edges in space are no silhouettes.
//!
//! Seen along the axis, an edge that is fixed in space, as that of a tile or of a box, is a point:
//! the rays of its lines pass through it from all cameras. Contacts of a silhouette move around the
//! cylinder instead. Edges at regular distances can pretend to be a cylinder, whose matches then
//! are lines of many edges, a few of each. A cylinder that cameras see from nearly the same
//! direction is different: its silhouettes pass nearly through a point, too, but all lines of this
//! point are its own.

use nalgebra::{Point2, Unit, Vector2, Vector3};

use crate::matching::MatchedCylinder;
use crate::observations::view::View;

/// An edge is seen in this part of all views that have lines.
const SHARE_OF_VIEWS: f64 = 0.6;

/// Least number of views of an edge: two rays meet always, a third passes by chance.
const LEAST_VIEWS: usize = 4;

/// Least sine of the angle between two rays that determine a point.
const LEAST_ANGLE: f64 = 0.05;

/// A line seen along the direction: the ray from the camera centre.
struct Ray {
    view: usize,
    line: usize,
    centre: Point2<f64>,
    normal: Vector2<f64>,
    /// Into the image.
    forward: Vector2<f64>,
}

/// The lines of some views, seen along a direction.
pub(super) struct Edges {
    rays: Vec<Ray>,
    /// Largest angle between a ray and its edge, for each view, radians.
    tolerances: Vec<f64>,
    least_views: usize,
}

impl Edges {
    /// `tolerances` are the largest angles between a line and its edge, for each view, radians.
    pub(super) fn new(views: &[View], direction: &Unit<Vector3<f64>>, tolerances: Vec<f64>) -> Self {
        let first = Unit::new_normalize(direction.cross(&Vector3::ith(direction.iamin(), 1.0)));
        let second = direction.cross(&first);
        let flat = |vector: &Vector3<f64>| Vector2::new(first.dot(vector), second.dot(vector));
        let mut rays = Vec::new();
        for (index, view) in views.iter().enumerate() {
            for (line, plane) in view.planes().enumerate() {
                rays.push(Ray {
                    view: index,
                    line,
                    centre: Point2::from(flat(&plane.centre.coords)),
                    normal: flat(&plane.normal).normalize(),
                    forward: flat(&plane.forward),
                });
            }
        }
        let seeing = views.iter().filter(|view| !view.lines().is_empty()).count();
        let least_views = LEAST_VIEWS.max((SHARE_OF_VIEWS * seeing as f64).ceil() as usize);
        Self { rays, tolerances, least_views }
    }

    /// Whether most matches of a cylinder are lines of edges most of whose lines it does not match.
    pub(super) fn explain(&self, found: &MatchedCylinder) -> bool {
        let own: Vec<_> = found.matches.iter().map(|residual| (residual.view, residual.line)).collect();
        let is_of_edge = |id: &&(usize, usize)| {
            let ray = self.rays.iter().find(|ray| (ray.view, ray.line) == **id);
            ray.and_then(|ray| self.edge(ray))
                .is_some_and(|edge| 2 * edge.iter().filter(|line| own.contains(line)).count() < edge.len())
        };
        2 * own.iter().filter(is_of_edge).count() > own.len()
    }

    /// The lines of the edge of a ray, one in a view, if it is seen in enough views.
    fn edge(&self, ray: &Ray) -> Option<Vec<(usize, usize)>> {
        let mut best = Vec::new();
        for other in self.rays.iter().filter(|other| other.view != ray.view) {
            let Some(point) = meet(ray, other) else { continue };
            let lines = self.through(&point);
            if lines.len() > best.len() {
                best = lines;
            }
        }
        (best.len() >= self.least_views).then_some(best)
    }

    /// The first line of each view whose ray passes through a point.
    fn through(&self, point: &Point2<f64>) -> Vec<(usize, usize)> {
        let mut lines: Vec<(usize, usize)> = Vec::new();
        for ray in &self.rays {
            let to_point = point - ray.centre;
            let near = ray.normal.dot(&to_point).abs() <= self.tolerances[ray.view] * to_point.norm();
            let is_new = lines.last().is_none_or(|line| line.0 != ray.view);
            if near && is_new && ray.forward.dot(&to_point) > 0.0 {
                lines.push((ray.view, ray.line));
            }
        }
        lines
    }
}

/// The point where two rays meet in front of their cameras.
fn meet(first: &Ray, second: &Ray) -> Option<Point2<f64>> {
    let sine = first.normal.perp(&second.normal);
    if sine.abs() < LEAST_ANGLE {
        return None;
    }
    let along = Vector2::new(-first.normal.y, first.normal.x);
    // The angle is not small, so the denominator, which is the sine, is not either.
    let position = second.normal.dot(&(second.centre - first.centre)) / second.normal.dot(&along);
    let point = first.centre + along * position;
    let in_front = |ray: &Ray| ray.forward.dot(&(point - ray.centre)) > 0.0;
    (in_front(first) && in_front(second)).then_some(point)
}
