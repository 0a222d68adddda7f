//! Edges in space are no silhouettes.
//!
//! Seen along the axis, an edge that is fixed in space, as that of a tile or of a box, is a point:
//! the rays of its lines pass through it from all cameras. Contacts of a silhouette move around the
//! cylinder instead. Many edges at regular distances can pretend to be a cylinder, so that the
//! lines of edges are taken away before cylinders are looked for. A point is an edge if chance
//! gives less than one point through which so many rays pass. The edge seen by most cameras is
//! taken first; then fewer lines are left, and fewer rays pass through a point by chance.

use std::collections::BinaryHeap;

use nalgebra::{Point2, Unit, Vector2, Vector3};

use crate::matching::tail;
use crate::observations::scene::LineId;
use crate::observations::view::{View, ViewingPlane};

/// Least number of views of an edge: two rays meet always, a third passes by chance.
const LEAST_VIEWS: usize = 4;

/// Least sine of the angle between two rays that determine a point.
const LEAST_ANGLE: f64 = 0.05;

/// The rays of a view are intersected with those of so many views after it.
const NEXT_VIEWS: usize = 2;

/// A line seen along the direction: the ray from the camera centre.
struct Ray {
    id: LineId,
    centre: Point2<f64>,
    normal: Vector2<f64>,
    /// Into the image.
    forward: Vector2<f64>,
}

/// The lines of some views, seen along a direction.
struct Rays {
    /// For each view with lines, those that belong to no edge found so far.
    free: Vec<Vec<Ray>>,
    /// Largest angle between a ray and its edge, for each of these views, radians.
    tolerances: Vec<f64>,
    /// Sum of the angles between the outermost rays.
    span: f64,
}

/// The lines of edges. `tolerances` are the largest angles between a line and its edge, for each
/// view, radians.
pub(super) fn edge_lines(views: &[View], direction: &Unit<Vector3<f64>>, tolerances: &[f64]) -> Vec<LineId> {
    let mut rays = Rays::new(views, direction, tolerances);
    let points = rays.points();
    let count = |rays: &Rays, point: usize| rays.through(&points[point]).iter().flatten().count();
    let mut queue: BinaryHeap<_> = (0..points.len())
        .map(|point| (count(&rays, point), point))
        .filter(|(views, _)| *views >= LEAST_VIEWS)
        .collect();
    let mut found = Vec::new();
    while let Some((views, point)) = queue.pop() {
        let now = count(&rays, point);
        if now < LEAST_VIEWS {
            continue;
        }
        if now < views {
            queue.push((now, point));
            continue;
        }
        if rays.false_alarms(points.len(), views) > 1.0 {
            break;
        }
        found.extend(rays.take(&points[point]));
    }
    found
}

impl Rays {
    fn new(views: &[View], direction: &Unit<Vector3<f64>>, tolerances: &[f64]) -> Self {
        let first = Unit::new_normalize(direction.cross(&Vector3::ith(direction.iamin(), 1.0)));
        let second = direction.cross(&first);
        let flat = |vector: &Vector3<f64>| Vector2::new(first.dot(vector), second.dot(vector));
        let mut rays = Self { free: Vec::new(), tolerances: Vec::new(), span: 0.0 };
        for (index, view) in views.iter().enumerate().filter(|(_, view)| !view.lines().is_empty()) {
            let ray = |(line, plane): (usize, ViewingPlane)| Ray {
                id: LineId { view: index, line },
                centre: Point2::from(flat(&plane.centre.coords)),
                normal: flat(&plane.normal).normalize(),
                forward: flat(&plane.forward),
            };
            let of_view: Vec<_> = view.planes().enumerate().map(ray).collect();
            let mut span = [f64::INFINITY, f64::NEG_INFINITY];
            for Ray { normal, forward, .. } in &of_view {
                let along = Vector2::new(-normal.y, normal.x);
                let along = along * along.dot(forward).signum();
                let bearing = forward.perp(&along).atan2(forward.dot(&along));
                span = [span[0].min(bearing), span[1].max(bearing)];
            }
            rays.span += span[1] - span[0];
            rays.free.push(of_view);
            rays.tolerances.push(tolerances[index]);
        }
        rays
    }

    /// The points where rays of near views meet.
    fn points(&self) -> Vec<Point2<f64>> {
        let views = self.free.len();
        let mut points = Vec::new();
        for (index, rays) in self.free.iter().enumerate() {
            for next in (1..=NEXT_VIEWS.min(views.saturating_sub(1))).map(|step| (index + step) % views) {
                let others = &self.free[next];
                points.extend(rays.iter().flat_map(|ray| others.iter().filter_map(move |other| meet(ray, other))));
            }
        }
        points
    }

    /// The place of the nearest ray of each view that passes through a point.
    fn through(&self, point: &Point2<f64>) -> Vec<Option<usize>> {
        let of_view = |(rays, tolerance): (&Vec<Ray>, &f64)| {
            let centre = rays.first()?.centre;
            let to_point = point - centre;
            let limit = tolerance * to_point.norm();
            let distance = |ray: &Ray| ray.normal.dot(&to_point).abs();
            let near = rays.iter().enumerate().map(|(place, ray)| (distance(ray), place));
            let near = near.filter(|(distance, place)| *distance <= limit && rays[*place].forward.dot(&to_point) > 0.0);
            near.min_by(|one, other| one.0.total_cmp(&other.0)).map(|(_, place)| place)
        };
        self.free.iter().zip(&self.tolerances).map(of_view).collect()
    }

    /// Expected number of the points through which the rays of so many views pass by chance.
    fn false_alarms(&self, points: usize, views: usize) -> f64 {
        let covered: f64 =
            self.free.iter().zip(&self.tolerances).map(|(rays, tolerance)| 2.0 * tolerance * rays.len() as f64).sum();
        points as f64 * tail(self.free.len() - 2, views - 2, covered / self.span)
    }

    /// Takes the lines of an edge away.
    fn take(&mut self, point: &Point2<f64>) -> Vec<LineId> {
        let through = self.through(point);
        let places = self.free.iter_mut().zip(through);
        places.filter_map(|(rays, place)| Some(rays.swap_remove(place?).id)).collect()
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
