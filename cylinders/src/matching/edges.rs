//! Edges in space are no silhouettes.
//!
//! Seen along the axis, an edge that is fixed in space, as that of a tile or of a box, is a point:
//! the rays of its lines pass through it from all cameras. Contacts of a silhouette move around the
//! cylinder instead. Many edges at regular distances can pretend to be a cylinder, so that the
//! lines of edges are taken away before cylinders are looked for. A point is an edge if
//!
//! - chance gives less than one point through which so many rays pass, and
//! - its rays, as silhouettes of a cylinder on one side, or on the left from some cameras and
//!   on the right from those opposite, would say that its radius is smaller than one that can be
//!   told from 0. Rays from a narrow range of angles do not say so: there the silhouette of a
//!   cylinder passes through a point, too.
//!
//! With the ray normals `n_i` and camera centres `C_i`, the silhouettes on one side of a circle
//! have `n_i^T (p - C_i) = q`, where `q` is the radius or, on the other side, its negative: linear
//! equations for `p` and `q`.
//!
//! The edge seen by most cameras is taken first; then fewer lines are left, and fewer rays pass
//! through a point by chance.

use std::collections::{BinaryHeap, HashSet};

use nalgebra::{Matrix3, Point2, Unit, Vector2, Vector3};

use super::chance::tail;
use super::error::MatchError;
use super::options::{LEAST_WIDTH, MatchOptions};
use super::plan::{is_along, ray, threshold};
use super::selection::Selection;
use crate::observations::scene::LineId;
use crate::observations::view::{View, ViewingPlane};

/// Least number of views of an edge: two rays meet always, a third passes by chance.
const LEAST_VIEWS: usize = 4;

/// Least sine of the angle between two rays that determine a point.
const LEAST_ANGLE: f64 = 0.05;

/// The rays of a view are intersected with those of so many views after it.
const NEXT_VIEWS: usize = 2;

/// Largest distances between a line and its edge, in thresholds, one after the other: the narrower,
/// the fewer lines pass by chance. An edge is seen more precisely than the threshold asks.
const LEVELS: [f64; 3] = [0.125, 0.25, 0.5];

/// The lines of an edge are within so many times the distance at which it was found.
const TAKEN: f64 = 2.0;

/// Standard deviation of the lines of an edge, in thresholds, and how many of them its radius must
/// be less than what can be told from 0.
const DEVIATION: f64 = 1.0 / 6.0;
const DEVIATIONS: f64 = 2.0;

/// The lines along a direction that belong to no edge in space, up to the largest number of an
/// image, and the number of lines that do.
///
/// # Errors
/// [`MatchError::Threshold`] and [`MatchError::NoCalibration`].
pub(super) fn without_edges(
    views: &[View],
    direction: &Unit<Vector3<f64>>,
    options: &MatchOptions,
) -> Result<(Selection, usize), MatchError> {
    let angles = views.iter().enumerate().map(|(index, view)| threshold(index, view.camera(), options));
    let angles = angles.collect::<Result<Vec<_>, _>>()?;
    let mut rays = Rays::new(views, direction, &angles);
    let edges: HashSet<LineId> = LEVELS.iter().flat_map(|level| rays.take_edges(*level)).collect();
    let selection =
        Selection::new(views, options.lines, |id, plane| is_along(plane, direction) && !edges.contains(&id));
    Ok((selection, edges.len()))
}

/// A line seen along the direction: the ray from the camera centre.
struct Ray {
    id: LineId,
    /// Unit normal, on the left of the ray into the image.
    normal: Vector2<f64>,
    /// Angle from the viewing direction of the camera.
    bearing: f64,
}

/// The rays of a view that belong to no edge found so far.
struct RaysOfView {
    centre: Point2<f64>,
    forward: Vector2<f64>,
    /// The threshold, radians.
    threshold: f64,
    /// In the order of their bearings.
    free: Vec<Ray>,
}

/// The lines of some views, seen along a direction.
struct Rays {
    /// The views with lines.
    views: Vec<RaysOfView>,
    /// Sum of the angles between the outermost rays.
    span: f64,
}

/// For each view the place of a ray.
type Through = Vec<Option<usize>>;

impl Rays {
    fn new(views: &[View], direction: &Unit<Vector3<f64>>, angles: &[f64]) -> Self {
        let first = Unit::new_normalize(direction.cross(&Vector3::ith(direction.iamin(), 1.0)));
        let second = direction.cross(&first);
        let flat = |vector: &Vector3<f64>| Vector2::new(first.dot(vector), second.dot(vector));
        let of_view = |(index, (view, angle)): (usize, (&View, &f64))| {
            let along = view.planes().enumerate().filter(|(_, plane)| is_along(plane, direction));
            let ray_of = |(line, plane): (usize, ViewingPlane)| {
                let forward = flat(&plane.forward);
                let normal = match view.ends()[line] {
                    // The middle is known better than the tilt, of short lines in particular.
                    Some([one, other]) => {
                        let middle = view.camera().rotation().tr_mul(&nalgebra::center(&one, &other).to_homogeneous());
                        let [x, y] = flat(&middle).into();
                        Vector2::new(y, -x).normalize()
                    }
                    None => {
                        let normal = flat(&plane.normal).normalize();
                        if ray(&normal).dot(&forward) < 0.0 { -normal } else { normal }
                    }
                };
                Ray { id: LineId { view: index, line }, normal, bearing: bearing(&forward, &ray(&normal)) }
            };
            let mut free: Vec<_> = along.map(ray_of).collect();
            free.sort_by(|one, other| one.bearing.total_cmp(&other.bearing));
            let forward = flat(&view.camera().rotation().row(2).transpose());
            let centre = Point2::from(flat(&view.camera().centre().coords));
            RaysOfView { centre, forward, threshold: *angle, free }
        };
        let views: Vec<_> = views.iter().zip(angles).enumerate().map(of_view).collect();
        let views: Vec<_> = views.into_iter().filter(|view| !view.free.is_empty()).collect();
        let span = views.iter().filter_map(|view| Some(view.free.last()?.bearing - view.free.first()?.bearing)).sum();
        Self { views, span }
    }

    /// Takes the lines of edges away, with distances of so many thresholds.
    fn take_edges(&mut self, level: f64) -> Vec<LineId> {
        let points = self.points();
        let count = |rays: &Self, point: usize| rays.through(&points[point], level).iter().flatten().count();
        let mut queue: BinaryHeap<_> = (0..points.len())
            .map(|point| (count(self, point), point))
            .filter(|(views, _)| *views >= LEAST_VIEWS)
            .collect();
        let mut found = Vec::new();
        while let Some((views, point)) = queue.pop() {
            let through = self.through(&points[point], level);
            let now = through.iter().flatten().count();
            if now < LEAST_VIEWS {
                continue;
            }
            if now < views {
                queue.push((now, point));
                continue;
            }
            if self.false_alarms(points.len(), views, level) > 1.0 {
                break;
            }
            if self.is_thin(&points[point], &through) {
                found.extend(self.take(&self.through(&points[point], TAKEN * level)));
            }
        }
        found
    }

    /// The points where rays of near views meet.
    fn points(&self) -> Vec<Point2<f64>> {
        let count = self.views.len();
        let mut points = Vec::new();
        for (index, view) in self.views.iter().enumerate() {
            for next in (1..=NEXT_VIEWS.min(count.saturating_sub(1))).map(|step| (index + step) % count) {
                let other = &self.views[next];
                let meeting = |ray| other.free.iter().filter_map(move |second| meet((view, ray), (other, second)));
                points.extend(view.free.iter().flat_map(meeting));
            }
        }
        points
    }

    /// The nearest ray of each view that passes through a point.
    fn through(&self, point: &Point2<f64>, level: f64) -> Through {
        let of_view = |view: &RaysOfView| {
            let bearing = bearing(&view.forward, &(point - view.centre));
            let after = view.free.partition_point(|ray| ray.bearing < bearing);
            let near = after.saturating_sub(1)..view.free.len().min(after + 1);
            let near = near.map(|place| ((view.free[place].bearing - bearing).abs(), place));
            let near = near.filter(|(distance, _)| *distance <= level * view.threshold);
            near.min_by(|one, other| one.0.total_cmp(&other.0)).map(|(_, place)| place)
        };
        self.views.iter().map(of_view).collect()
    }

    /// Expected number of the points through which the rays of so many views pass by chance.
    fn false_alarms(&self, points: usize, views: usize, level: f64) -> f64 {
        let covered: f64 = self.views.iter().map(|view| 2.0 * level * view.threshold * view.free.len() as f64).sum();
        points as f64 * tail(self.views.len() - 2, views - 2, covered / self.span)
    }

    /// Whether a cylinder of which these rays are silhouettes is too thin for one: on one side, or
    /// on the left from here and on the right from opposite.
    fn is_thin(&self, point: &Point2<f64>, through: &Through) -> bool {
        let mut normals = self.views.iter().zip(through).filter_map(|(view, place)| Some(view.free[(*place)?].normal));
        let Some(first) = normals.next() else { return false };
        self.is_thin_with(point, through, |_| 1.0)
            && self.is_thin_with(point, through, |normal| normal.dot(&first).signum())
    }

    /// The same, with the signs of normals.
    fn is_thin_with(&self, point: &Point2<f64>, through: &Through, sign: impl Fn(&Vector2<f64>) -> f64) -> bool {
        let (mut matrix, mut vector, mut least) = (Matrix3::zeros(), Vector3::zeros(), 0.0);
        for (view, place) in self.views.iter().zip(through) {
            let Some(Ray { normal, .. }) = place.map(|place| &view.free[place]) else { continue };
            let to_point = point - view.centre;
            // What the threshold is at this distance.
            let unit = view.threshold * to_point.norm();
            let row = Vector3::new(normal.x, normal.y, -sign(normal)) / unit;
            matrix += row * row.transpose();
            vector -= row * (normal.dot(&to_point) / unit);
            least += LEAST_WIDTH * unit;
        }
        let least = least / through.iter().flatten().count() as f64;
        let Some(inverse) = matrix.try_inverse() else { return false };
        let radius = (inverse * vector).z;
        radius.abs() + DEVIATIONS * DEVIATION * inverse[(2, 2)].sqrt() <= least
    }

    /// Takes rays away.
    fn take(&mut self, through: &Through) -> Vec<LineId> {
        let places = self.views.iter_mut().zip(through);
        places.filter_map(|(view, place)| Some(view.free.remove((*place)?).id)).collect()
    }
}

/// Angle from the viewing direction.
fn bearing(forward: &Vector2<f64>, vector: &Vector2<f64>) -> f64 {
    forward.perp(vector).atan2(forward.dot(vector))
}

/// The point where two rays meet in front of their cameras.
fn meet((first, one): (&RaysOfView, &Ray), (second, other): (&RaysOfView, &Ray)) -> Option<Point2<f64>> {
    let sine = one.normal.perp(&other.normal);
    if sine.abs() < LEAST_ANGLE {
        return None;
    }
    let along = ray(&one.normal);
    // The angle is not small, so the denominator, which is the sine, is not either.
    let position = other.normal.dot(&(second.centre - first.centre)) / other.normal.dot(&along);
    let point = first.centre + along * position;
    let is_ahead = position > 0.0 && ray(&other.normal).dot(&(point - second.centre)) > 0.0;
    is_ahead.then_some(point)
}
