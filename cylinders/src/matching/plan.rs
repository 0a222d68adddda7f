//! The scene seen along the axis: cameras are points, lines are rays from them, cylinders are
//! circles.
//!
//! A ray has the unit direction `d`, away from the camera into the image, and the unit normal `n`,
//! on its left. For a circle with centre `p` and radius `r`, and `m = p - C` from the camera centre
//! at the distance `rho = |m|`:
//!
//! ```text
//!             ray d
//!            /  ____          n^T m = rho sin(alpha)    alpha: angle from the ray to the centre,
//!           /  /    \         d^T m = rho cos(alpha)           positive to the left
//!          /  |   p  |        r     = rho sin(beta)     beta: half of the angle of the circle
//!         /    \____/         left silhouette at alpha = -beta, right one at alpha = beta
//!        C
//! ```
//!
//! A line is within the threshold `t` if `| |alpha| - beta | <= t`. Sines grow with their angles,
//! so the test needs one root for each view, and no root or inverse function for a line:
//!
//! ```text
//!   r cos(t) - sqrt(rho^2 - r^2) sin(t)  <=  | n^T m |  <=  r cos(t) + sqrt(rho^2 - r^2) sin(t)
//!   d^T m > 0
//! ```

use std::ops::Range;

use nalgebra::{Point2, Point3, Unit, Vector2, Vector3};

use super::error::MatchError;
use super::options::MatchOptions;
use crate::cross_section::circle::Circle;
use crate::cross_section::rectify::{Rectification, TangentLine};
use crate::observations::scene::LineId;
use crate::observations::view::{Camera, View, ViewingPlane};
use crate::space::cylinder::{Cylinder, Side};
use crate::space::silhouette_distance::{DistanceUnit, MeasuredLine, Metric};

/// Largest sine of the angle between a viewing plane and the axis. It is far above the uncertainty
/// of a short line, and far below the value of lines across the axis.
const MAX_TILT: f64 = 0.05;

/// Lines beside a silhouette are counted up to so many thresholds from it.
const NEIGHBOURHOOD: f64 = 30.0;

/// Largest threshold, radians.
const MAX_THRESHOLD: f64 = 0.1;

/// The cameras count as standing at one place if, seen along the axis, their largest distance from
/// their mean, relative to their distance from the world's origin, is at most this.
const SINGLE_VIEWPOINT: f64 = 1e-9;

/// The support of a circle: more matches are better, then a smaller cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Support {
    /// Number of silhouettes with a line within the threshold, at most two in a view.
    pub(super) matches: usize,
    /// Sum of the squared sines of the angles between matches and silhouettes, in units of the
    /// thresholds.
    pub(super) cost: f64,
}

impl Support {
    pub(super) fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.matches.cmp(&other.matches).then(other.cost.total_cmp(&self.cost))
    }
}

/// A line that is a silhouette.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(super) struct PlanMatch {
    /// Index of the line in the plan.
    pub(super) line: usize,
    pub(super) side: Side,
}

/// An image seen along the axis.
#[derive(Clone, Debug)]
pub(super) struct PlanView {
    pub(super) centre: Point2<f64>,
    /// Threshold `t`, radians, its cosine and sine.
    pub(super) threshold: f64,
    pub(super) cosine: f64,
    pub(super) sine: f64,
    /// Indices of its lines in the plan.
    pub(super) lines: Range<usize>,
    /// Angle between its outermost rays, radians.
    pub(super) span: f64,
}

/// Cameras and rays seen along the axis. It contains only the lines along the axis.
#[derive(Clone)]
pub(super) struct Plan {
    rectification: Rectification,
    views: Vec<PlanView>,
    /// Normals `n` of the rays, one array for each coordinate: all lines of a view are tested in
    /// one sweep. The normal of a line that was taken is zero, so that it is in front of no camera.
    normals: [Vec<f64>; 2],
    lines: Vec<TangentLine>,
    ids: Vec<LineId>,
    extent: f64,
    tilt: Tilt,
}

/// What decides whether a line near a silhouette in the cross-section is near it in the image, too:
/// it may be tilted.
#[derive(Clone)]
struct Tilt {
    direction: Unit<Vector3<f64>>,
    /// The lines of the plan, empty if distances cannot be measured.
    measured: Vec<MeasuredLine>,
    square_threshold: f64,
}

impl Plan {
    pub(super) fn new(
        views: &[View],
        direction: &Unit<Vector3<f64>>,
        options: &MatchOptions,
    ) -> Result<Self, MatchError> {
        let centres = views.iter().map(|view| view.camera().centre());
        let magnitude = centres.clone().map(|centre| centre.coords.norm()).fold(0.0, f64::max);
        let origin =
            Point3::from(centres.map(|centre| centre.coords).sum::<Vector3<f64>>() / views.len().max(1) as f64);
        let mut plan = Self {
            rectification: Rectification::new(direction, origin),
            views: Vec::with_capacity(views.len()),
            normals: [Vec::new(), Vec::new()],
            lines: Vec::new(),
            ids: Vec::new(),
            extent: 0.0,
            tilt: Tilt { direction: *direction, measured: Vec::new(), square_threshold: options.threshold.powi(2) },
        };
        let mut first_lines = Vec::with_capacity(views.len());
        let mut lines = 0;
        for (index, view) in views.iter().enumerate() {
            plan.push(index, view, direction, threshold(index, view.camera(), options)?);
            first_lines.push(lines);
            lines += view.lines().len();
        }
        let metric = Metric { unit: options.unit, ..Metric::of(views) };
        if let Ok(measured) = metric.measured_lines(views) {
            plan.tilt.measured = plan.ids.iter().map(|id| measured[first_lines[id.view] + id.line]).collect();
        }
        let seeing = plan.views.iter().filter(|view| !view.lines.is_empty());
        let count = seeing.clone().count();
        if count < 2 {
            return Err(MatchError::TooFewViews { views: count });
        }
        plan.extent = seeing.map(|view| view.centre.coords.norm()).fold(0.0, f64::max);
        if plan.extent <= SINGLE_VIEWPOINT * magnitude {
            return Err(MatchError::SingleViewpoint);
        }
        Ok(plan)
    }

    fn push(&mut self, index: usize, view: &View, direction: &Unit<Vector3<f64>>, threshold: f64) {
        let camera = view.camera();
        let centre = self.rectification.point(&camera.centre());
        let forward = self.rectification.point(&(camera.centre() + camera.rotation().row(2).transpose())) - centre;
        let first = self.lines.len();
        let mut span = [f64::INFINITY, f64::NEG_INFINITY];
        for (line, plane) in view.planes().enumerate() {
            let Some(tangent) = self.rectification.line(&plane).filter(|_| is_along(&plane, direction)) else {
                continue;
            };
            // The ray is the one into the image: the point of the line nearest to the principal
            // point is on it.
            let normal = if ray(&tangent.normal).dot(&forward) < 0.0 { -tangent.normal } else { tangent.normal };
            let bearing = forward.perp(&ray(&normal)).atan2(forward.dot(&ray(&normal)));
            span = [span[0].min(bearing), span[1].max(bearing)];
            self.normals[0].push(normal.x);
            self.normals[1].push(normal.y);
            self.lines.push(tangent);
            self.ids.push(LineId { view: index, line });
        }
        let (sine, cosine) = threshold.sin_cos();
        let lines = first..self.lines.len();
        let span = (span[1] - span[0]).max(0.0);
        self.views.push(PlanView { centre, threshold, cosine, sine, lines, span });
    }

    /// The same with thresholds that are smaller by this factor. Lines may be as tilted as before:
    /// the tilt of a short line is less certain than its position.
    pub(super) fn narrowed(&self, factor: f64) -> Self {
        let mut narrowed = self.clone();
        for view in &mut narrowed.views {
            view.threshold *= factor;
            (view.sine, view.cosine) = view.threshold.sin_cos();
        }
        narrowed
    }

    /// Number of lines, with those that were taken away.
    pub(super) fn line_count(&self) -> usize {
        self.lines.len()
    }

    pub(super) fn rectification(&self) -> &Rectification {
        &self.rectification
    }

    pub(super) fn views(&self) -> &[PlanView] {
        &self.views
    }

    /// Normal of a ray.
    pub(super) fn normal(&self, line: usize) -> Vector2<f64> {
        Vector2::new(self.normals[0][line], self.normals[1][line])
    }

    /// Entries of the normals of some lines; zero for lines that were taken away.
    pub(super) fn normals(&self, lines: &Range<usize>) -> [&[f64]; 2] {
        [0, 1].map(|entry| &self.normals[entry][lines.clone()])
    }

    /// Whether a line has not been taken away.
    pub(super) fn is_free(&self, line: usize) -> bool {
        self.normal(line) != Vector2::zeros()
    }

    /// Number of lines of a view that have not been taken away.
    pub(super) fn free_lines(&self, view: &PlanView) -> usize {
        view.lines.clone().filter(|&line| self.is_free(line)).count()
    }

    pub(super) fn tangent_line(&self, line: usize) -> TangentLine {
        self.lines[line]
    }

    pub(super) fn id(&self, line: usize) -> LineId {
        self.ids[line]
    }

    /// Largest distance of a camera from the origin of the cross-section.
    pub(super) fn extent(&self) -> f64 {
        self.extent
    }

    /// Takes lines away, so that they match nothing any more.
    pub(super) fn take(&mut self, lines: impl Iterator<Item = usize>) {
        for line in lines {
            self.normals[0][line] = 0.0;
            self.normals[1][line] = 0.0;
        }
    }

    /// The support of a circle; `None` if it is less than `least`, or a camera is inside.
    pub(super) fn support(&self, circle: &Circle, least: usize) -> Option<Support> {
        let mut support = Support { matches: 0, cost: 0.0 };
        for (index, view) in self.views.iter().enumerate() {
            for (_, cost) in self.silhouettes(view, circle)?.into_iter().flatten() {
                support.matches += 1;
                support.cost += cost;
            }
            if support.matches + 2 * (self.views.len() - index - 1) < least {
                return None;
            }
        }
        Some(support)
    }

    /// The matches of a circle within a part of the threshold, in the order of the lines.
    pub(super) fn matches(&self, circle: &Circle, part: f64) -> Vec<PlanMatch> {
        let sides = [Side::Left, Side::Right];
        let of_view = |view| {
            let found = self.matched_silhouettes(view, circle).unwrap_or_default();
            let near = move |(line, cost): (usize, f64)| (cost <= part * part).then_some(line);
            let found = sides.into_iter().zip(found);
            found.filter_map(move |(side, found)| Some(PlanMatch { line: near(found?)?, side }))
        };
        let mut matches: Vec<_> = self.views.iter().flat_map(of_view).collect();
        matches.sort_by_key(|line| line.line);
        matches
    }

    /// Like [`Plan::silhouettes`], without lines that are too far from the silhouette in the image.
    pub(super) fn matched_silhouettes(&self, view: &PlanView, circle: &Circle) -> Option<[Option<(usize, f64)>; 2]> {
        let cylinder = Cylinder::from_circle(circle, &self.rectification, self.tilt.direction);
        let is_near = |&(line, _): &(usize, f64)| {
            let Some(measured) = self.tilt.measured.get(line) else { return true };
            let square = measured.silhouettes(&cylinder).map(|silhouettes| measured.square(&silhouettes));
            square.is_some_and(|square| square <= self.tilt.square_threshold)
        };
        Some(self.silhouettes(view, circle)?.map(|found| found.filter(is_near)))
    }

    /// Number of lines for each threshold beside the left and the right silhouette of a circle, on
    /// either side of it, without one line that matches.
    pub(super) fn densities(&self, view: &PlanView, circle: &Circle) -> [f64; 2] {
        let to_centre = circle.centre - view.centre;
        let square = to_centre.norm_squared();
        let tangent_length = (square - circle.radius * circle.radius).max(0.0).sqrt();
        let most = NEIGHBOURHOOD * view.sine * square;
        let [x, y] = &self.normals;
        let mut counts = [0_usize; 2];
        for line in view.lines.clone() {
            let across = x[line] * to_centre.x + y[line] * to_centre.y;
            let along = x[line] * to_centre.y - y[line] * to_centre.x;
            let is_near = |sign: f64| (sign * across * tangent_length - along * circle.radius).abs() <= most;
            counts[0] += usize::from(along > 0.0 && is_near(-1.0));
            counts[1] += usize::from(along > 0.0 && is_near(1.0));
        }
        counts.map(|count| count.saturating_sub(1) as f64 / (2.0 * NEIGHBOURHOOD))
    }

    /// The line nearest to the left silhouette of a circle and the line nearest to the right one,
    /// each with its part of the cost; `None` if the camera is inside.
    pub(super) fn silhouettes(&self, view: &PlanView, circle: &Circle) -> Option<[Option<(usize, f64)>; 2]> {
        let Circle { centre, radius } = *circle;
        let to_centre = centre - view.centre;
        let square = to_centre.norm_squared();
        let outside = square > radius * radius;
        if !outside {
            return None;
        }
        let tangent_length = (square - radius * radius).sqrt();
        let (middle, half) = (radius * view.cosine, tangent_length * view.sine);
        let nearly_half_turn = tangent_length * view.cosine <= radius * view.sine;
        let bounds = [middle - half, if nearly_half_turn { f64::INFINITY } else { middle + half }];
        let mut nearest = [None; 2];
        let [x, y] = &self.normals;
        for line in view.lines.clone() {
            let across = x[line] * to_centre.x + y[line] * to_centre.y;
            let along = x[line] * to_centre.y - y[line] * to_centre.x;
            if along > 0.0 && across.abs() >= bounds[0] && across.abs() <= bounds[1] {
                let sine = (across.abs() * tangent_length - along * radius) / square;
                let cost = (sine / view.sine).powi(2);
                let side: &mut Option<(usize, f64)> = &mut nearest[usize::from(across > 0.0)];
                if side.is_none_or(|(_, least)| cost < least) {
                    *side = Some((line, cost));
                }
            }
        }
        Some(nearest)
    }
}

/// The direction of a ray from its normal.
pub(super) fn ray(normal: &Vector2<f64>) -> Vector2<f64> {
    Vector2::new(-normal.y, normal.x)
}

/// Whether a line is along a direction.
pub(super) fn is_along(plane: &ViewingPlane, direction: &Unit<Vector3<f64>>) -> bool {
    plane.normal.dot(direction).abs() <= MAX_TILT
}

/// The threshold as an angle, radians.
pub(super) fn threshold(view: usize, camera: &Camera, options: &MatchOptions) -> Result<f64, MatchError> {
    let threshold = match options.unit {
        DistanceUnit::Radians => options.threshold,
        DistanceUnit::Pixels => {
            let k = camera.calibration().ok_or(MatchError::NoCalibration { view })?.matrix();
            options.threshold / (k[(0, 0)] * k[(1, 1)]).abs().sqrt()
        }
    };
    match threshold > 0.0 && threshold < MAX_THRESHOLD {
        true => Ok(threshold),
        false => Err(MatchError::Threshold { view, threshold }),
    }
}
