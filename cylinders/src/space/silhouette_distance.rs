//! The geometric residual: the distance of two points of an image line from the silhouette of a
//! cylinder, signed and smooth.
//!
//! ```text
//!              | silhouette
//!        p1  o--->|            p0, p1: support points of the given line: its end points or, if
//!           /  e1 |                    unknown, at +-h about its point nearest to the principal
//!          /      |                    point
//!     p0  o------>|            e0, e1: their distances from the silhouette line, pixels or
//!            e0                        radians, positive on the side of the axis
//! ```
//!
//! A line has two degrees of freedom, and both count: one point alone would not use the direction
//! of the line, and with cameras at one height would not determine the direction of the axis. The
//! half-length `h` stands for the length over which the line was seen. If end points are
//! independently off by `sigma`, then `e0` and `e1` are independent with deviation `sigma`, and
//! least squares is the maximum likelihood estimate.
//!
//! With `a` the perpendicular from the camera centre to the axis, `rho = |a|` and `b = w x a`, the
//! tangent planes have the unit normals `s = (r a +- sqrt(rho^2 - r^2) b) / rho^2`, and a support
//! point with the ray `d` (world frame) is at
//!
//! ```text
//!     e = s^T d / |B s|        pixels:  d = R^T K^-1 p,  B = (K^-T R) without its last row
//!                              radians: d = R^T p / |p|, B = R (the sine of the angle)
//! ```

use std::fmt;

use nalgebra::{Matrix3, Point2, Point3, Vector2, Vector3};
use serde::Serialize;
use thiserror::Error;

use super::cylinder::{Cylinder, Side};
use crate::observations::copies::IndependentLines;
use crate::observations::scene::LineId;
use crate::observations::view::{Camera, View};

/// Half-length `h` of a line without end points, relative to the focal length: 300 pixels at a
/// focal length of 3000.
const HALF_LENGTH: f64 = 0.1;

/// The unit of distances in an image.
#[derive(Clone, Copy, Debug, Eq, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum DistanceUnit {
    /// Pixels; every camera needs a calibration.
    Pixels,
    /// Angles between rays and tangent planes, radians (their sines).
    Radians,
}

impl fmt::Display for DistanceUnit {
    fn fmt(&self, text: &mut fmt::Formatter<'_>) -> fmt::Result {
        text.write_str(match self {
            Self::Pixels => "pixels",
            Self::Radians => "radians",
        })
    }
}

/// How distances between lines and silhouettes are measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Metric {
    /// Unit of the distances.
    pub unit: DistanceUnit,
    /// Half of the length over which a line without end points was seen, relative to the focal
    /// length.
    pub half_length: f64,
}

/// Why distances cannot be measured.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum MetricError {
    /// Distances in pixels without a calibration.
    #[error("views[{view}]: distances in pixels need the calibration of every camera; pass it, or measure in radians")]
    NoCalibration {
        /// Index of the view.
        view: usize,
    },
    /// The line is so far from the image that its points are out of range.
    #[error("views[{view}], line {line} is not in the image")]
    LineOutOfRange {
        /// Index of the view.
        view: usize,
        /// Index of the line in its view.
        line: usize,
    },
    /// The half-length is not positive and finite.
    #[error("the half-length of lines must be a positive number (found {half_length})")]
    HalfLength {
        /// The value.
        half_length: f64,
    },
}

impl Metric {
    /// Pixels if all cameras have a calibration, radians otherwise. The half-length is a tenth of
    /// the focal length.
    pub fn of(views: &[View]) -> Self {
        let calibrated = views.iter().all(|view| view.camera().calibration().is_some());
        let unit = if calibrated { DistanceUnit::Pixels } else { DistanceUnit::Radians };
        Self { unit, half_length: HALF_LENGTH }
    }

    /// Independent lines, in their order, prepared for measurement.
    pub(crate) fn measured(&self, lines: &IndependentLines) -> Result<Vec<MeasuredLine>, MetricError> {
        self.measured_lines(&lines.views).map_err(|error| match error {
            MetricError::LineOutOfRange { view, line } => {
                let before: usize = lines.views[..view].iter().map(|view| view.lines().len()).sum();
                let LineId { view, line } = lines.copies[before + line][0];
                MetricError::LineOutOfRange { view, line }
            }
            error => error,
        })
    }

    /// The lines of all views, in their order, prepared for measurement.
    pub(crate) fn measured_lines(&self, views: &[View]) -> Result<Vec<MeasuredLine>, MetricError> {
        if !(self.half_length > 0.0 && self.half_length.is_finite()) {
            return Err(MetricError::HalfLength { half_length: self.half_length });
        }
        let mut measured = Vec::new();
        for (index, view) in views.iter().enumerate() {
            let place = Place::new(view.camera(), self).ok_or(MetricError::NoCalibration { view: index })?;
            for (line, (coordinates, ends)) in view.lines().iter().zip(view.ends()).enumerate() {
                let points = ends.unwrap_or_else(|| place.support_points(coordinates));
                let out_of_range = MetricError::LineOutOfRange { view: index, line };
                let prepared = place.measured(index, &points).ok_or(out_of_range)?;
                measured.push(MeasuredLine { has_ends: ends.is_some(), ..prepared });
            }
        }
        Ok(measured)
    }
}

/// The lines of a view, in their order, prepared for measurement at their end points: in pixels
/// with a calibration, in radians without. `None` for a line without end points.
pub(crate) fn lines_with_ends(index: usize, view: &View) -> Vec<Option<MeasuredLine>> {
    let place = Place::new(view.camera(), &Metric::of(std::slice::from_ref(view)));
    view.ends().iter().map(|ends| place.as_ref()?.measured(index, ends.as_ref()?)).collect()
}

/// The lines of a view, in their order, prepared for measurement in pixels; `None` without
/// calibration, or if a line is out of range.
pub(crate) fn lines_in_pixels(index: usize, view: &View) -> Vec<Option<MeasuredLine>> {
    let metric = Metric { unit: DistanceUnit::Pixels, ..Metric::of(&[]) };
    let place = Place::new(view.camera(), &metric);
    let measured = |(line, ends): (&Vector3<f64>, &Option<[Point2<f64>; 2]>)| {
        let place = place.as_ref()?;
        place.measured(index, &ends.unwrap_or_else(|| place.support_points(line)))
    };
    view.lines().iter().zip(view.ends()).map(measured).collect()
}

/// The data of a camera for one metric.
struct Place {
    centre: Point3<f64>,
    /// `K^-1`; `K = I` for radians.
    inverse: Matrix3<f64>,
    rotation: Matrix3<f64>,
    /// `B`.
    scale: Matrix3<f64>,
    /// Principal point.
    principal: Vector2<f64>,
    /// Half-length, in the unit of image points.
    half_length: f64,
    unit: DistanceUnit,
}

impl Place {
    /// `None` without the calibration that the metric needs.
    fn new(camera: &Camera, metric: &Metric) -> Option<Self> {
        let calibration = match metric.unit {
            DistanceUnit::Radians => Matrix3::identity(),
            DistanceUnit::Pixels => *camera.calibration()?.matrix(),
        };
        let inverse = calibration.try_inverse()?;
        let mut scale = inverse.tr_mul(camera.rotation());
        if metric.unit == DistanceUnit::Pixels {
            scale.row_mut(2).fill(0.0);
        }
        Some(Self {
            centre: camera.centre(),
            inverse,
            rotation: *camera.rotation(),
            scale,
            principal: calibration.column(2).xy(),
            half_length: metric.half_length * (calibration[(0, 0)] * calibration[(1, 1)]).abs().sqrt(),
            unit: metric.unit,
        })
    }

    /// The support points of a line without end points, normalised coordinates.
    fn support_points(&self, line: &Vector3<f64>) -> [Point2<f64>; 2] {
        let line = self.inverse.tr_mul(line);
        let line = line / line.xy().norm();
        let foot = self.principal - line.xy() * line.dot(&self.principal.push(1.0));
        let along = Vector2::new(-line.y, line.x) * self.half_length;
        [foot - along, foot + along].map(|point| Point2::from((self.inverse * point.push(1.0)).xy()))
    }

    /// The line through two support points, normalised coordinates; `None` if they are out of
    /// range.
    fn measured(&self, view: usize, points: &[Point2<f64>; 2]) -> Option<MeasuredLine> {
        let rays = points.map(|point| {
            let ray = self.rotation.tr_mul(&point.to_homogeneous());
            match self.unit {
                DistanceUnit::Pixels => ray,
                DistanceUnit::Radians => ray.normalize(),
            }
        });
        let finite = rays.iter().all(|ray| ray.iter().all(|entry| entry.is_finite()));
        finite.then_some(MeasuredLine { view, centre: self.centre, rays, scale: self.scale, has_ends: true })
    }
}

/// A given line, prepared for measurement against silhouettes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MeasuredLine {
    /// Index of the view.
    pub(crate) view: usize,
    /// Camera centre `C`.
    pub(crate) centre: Point3<f64>,
    /// Rays `d` of the two support points, world frame.
    rays: [Vector3<f64>; 2],
    /// The matrix `B` of the metric.
    scale: Matrix3<f64>,
    /// Whether the support points are the end points of the line.
    pub(crate) has_ends: bool,
}

/// A given line measured against the nearer silhouette line of a cylinder.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SilhouetteDistance {
    /// Distances `e` of the two support points.
    pub(crate) distances: Vector2<f64>,
    /// Depth of the contact point that is seen at the middle of the given line, in units of the ray
    /// to it: negative behind the camera.
    pub(crate) depth: f64,
    /// Unit normal `s` of the tangent plane.
    normal: Vector3<f64>,
    /// `+1` or `-1`.
    side: f64,
}

/// A silhouette of a cylinder in a view.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Silhouette {
    /// Unit normal `s` of the tangent plane.
    normal: Vector3<f64>,
    /// `s / |B s|`: its products with rays are distances.
    scaled: Vector3<f64>,
    /// Perpendicular from the camera to the line of contact.
    to_contact_line: Vector3<f64>,
    /// `+1` or `-1`.
    side: f64,
}

/// Both silhouettes, the one with positive side first.
pub(crate) type Silhouettes = [Silhouette; 2];

/// A direction of change of a cylinder: `(dw, dA, dr)`.
pub(crate) type CylinderTangent = (Vector3<f64>, Vector3<f64>, f64);

impl SilhouetteDistance {
    /// Mean of the squares of the two distances.
    pub(crate) fn mean_square(&self) -> f64 {
        self.distances.norm_squared() / 2.0
    }

    /// The silhouette: planes with positive `side` are the first of [`Cylinder::silhouette`].
    pub(crate) fn side(&self) -> Side {
        if self.side > 0.0 { Side::Right } else { Side::Left }
    }
}

impl MeasuredLine {
    /// The same line in the coordinates `(X - origin) / unit`.
    pub(crate) fn in_frame(&self, origin: &Point3<f64>, unit: f64) -> Self {
        Self { centre: Point3::from((self.centre - origin) / unit), ..*self }
    }

    /// Whether the second support point is further along the axis than the first.
    pub(crate) fn is_along(&self, cylinder: &Cylinder) -> bool {
        (self.rays[1] - self.rays[0]).dot(&cylinder.direction) > 0.0
    }

    /// Ray to the middle of the support points.
    fn middle(&self) -> Vector3<f64> {
        (self.rays[0] + self.rays[1]) / 2.0
    }

    /// The point at which the ray to the middle of the line touches the cylinder or is nearest to
    /// the contact line.
    pub(crate) fn contact(&self, distance: &SilhouetteDistance) -> Point3<f64> {
        self.centre + self.middle() * distance.depth
    }

    /// The points on the rays to the two support points that are nearest to the contact line;
    /// `None` if one is behind the camera, or its ray runs along the axis.
    pub(crate) fn contacts(&self, cylinder: &Cylinder, distance: &SilhouetteDistance) -> Option<[Point3<f64>; 2]> {
        let to_contact_line = cylinder.vector_to_axis(&self.centre) - distance.normal * cylinder.radius;
        let depths = self.rays.map(|ray| depth(&ray, cylinder, &to_contact_line));
        let seen = depths.iter().all(|depth| *depth > 0.0 && depth.is_finite());
        seen.then(|| [0, 1].map(|end| self.centre + self.rays[end] * depths[end]))
    }

    /// The silhouettes of a cylinder in the view of the line; `None` if the camera is not outside
    /// the cylinder.
    #[inline]
    pub(crate) fn silhouettes(&self, cylinder: &Cylinder) -> Option<Silhouettes> {
        let to_axis = cylinder.vector_to_axis(&self.centre);
        let (square, radius) = (to_axis.norm_squared(), cylinder.radius);
        let norm = square.sqrt();
        let outside = norm > radius;
        if !outside {
            return None;
        }
        let tangent_length = ((norm - radius) * (norm + radius)).sqrt();
        let (across, inverse_square) = (cylinder.direction.cross(&to_axis), 1.0 / square);
        let silhouette = |side: f64| {
            let normal = (to_axis * radius + across * (side * tangent_length)) * inverse_square;
            let scaled = normal * (1.0 / (self.scale * normal).norm());
            Silhouette { normal, scaled, to_contact_line: to_axis - normal * radius, side }
        };
        Some([silhouette(1.0), silhouette(-1.0)])
    }

    /// Distances from a silhouette.
    #[inline]
    fn distances(&self, silhouette: &Silhouette) -> Vector2<f64> {
        Vector2::new(silhouette.scaled.dot(&self.rays[0]), silhouette.scaled.dot(&self.rays[1]))
    }

    /// The nearer silhouette, and the distances from it.
    #[inline]
    fn nearer<'a>(&self, [first, second]: &'a Silhouettes) -> (&'a Silhouette, Vector2<f64>) {
        let (of_first, of_second) = (self.distances(first), self.distances(second));
        match of_second.norm_squared() < of_first.norm_squared() {
            true => (second, of_second),
            false => (first, of_first),
        }
    }

    /// The mean square distance from the nearer silhouette of its view; infinite if the point of
    /// contact is behind the camera.
    #[inline]
    pub(crate) fn square(&self, silhouettes: &Silhouettes) -> f64 {
        let (silhouette, distances) = self.nearer(silhouettes);
        // The depth of the middle has the sign of this product.
        match (self.rays[0] + self.rays[1]).dot(&silhouette.to_contact_line) > 0.0 {
            true => distances.norm_squared() / 2.0,
            false => f64::INFINITY,
        }
    }

    /// Distance from the nearer silhouette line; `None` if the camera is not outside the cylinder.
    pub(crate) fn distance(&self, cylinder: &Cylinder) -> Option<SilhouetteDistance> {
        Some(self.distance_from(cylinder, &self.silhouettes(cylinder)?))
    }

    /// Distance from the nearer of the silhouettes of a cylinder in the view of the line.
    #[inline]
    pub(crate) fn distance_from(&self, cylinder: &Cylinder, silhouettes: &Silhouettes) -> SilhouetteDistance {
        let (&Silhouette { normal, to_contact_line, side, .. }, distances) = self.nearer(silhouettes);
        SilhouetteDistance { distances, depth: depth(&self.middle(), cylinder, &to_contact_line), normal, side }
    }

    /// Derivatives of the two distances along changes of the cylinder.
    ///
    /// With the perpendicular t from the camera to the axis, L^2 = t^2 - r^2 and the side +-1, the
    /// normal is s = (r t +- L w x t) / t^2. A distance is e = s.d / |B s|, and its derivative
    /// along ds is t^2 p.ds with p = (d - e B^T B s / |B s|) / (|B s| t^2). The change of t is
    /// dt = (I - w w^T) dA - (w.(A - C) I + w (A - C)^T) dw, so that
    ///
    /// ```text
    ///   de = g.dt +- L (t x p).dw + (p.t -+ p.(w x t) r / L) dr
    ///   g  = r p + (+-p.(w x t) / L - 2 p.s) t +- L p x w
    /// ```
    #[inline]
    pub(crate) fn derivatives<const N: usize>(
        &self,
        cylinder: &Cylinder,
        distance: &SilhouetteDistance,
        tangents: &[CylinderTangent; N],
    ) -> [Vector2<f64>; N] {
        let (w, radius, normal) = (cylinder.direction.into_inner(), cylinder.radius, distance.normal);
        let difference = cylinder.axis_point - self.centre;
        let along = w.dot(&difference);
        let to_axis = difference - w * along;
        let across = w.cross(&to_axis);
        let square = to_axis.norm_squared();
        let length = distance.side * (square - radius * radius).sqrt();
        let scaled = self.scale * normal;
        let scale_square = scaled.norm_squared();
        let slope = self.scale.tr_mul(&scaled) * (1.0 / scale_square);
        let (inverse_scale, inverse_square, inverse_length) = (1.0 / scale_square.sqrt(), 1.0 / square, 1.0 / length);

        let mut derivatives = [Vector2::zeros(); N];
        for end in 0..2 {
            let p = (self.rays[end] * inverse_scale - slope * distance.distances[end]) * inverse_square;
            let by_length = p.dot(&across) * inverse_length;
            let g = p * radius + to_axis * (by_length - 2.0 * p.dot(&normal)) + p.cross(&w) * length;
            let g_along = g.dot(&w);
            let by_direction = to_axis.cross(&p) * length - difference * g_along - g * along;
            let by_point = g - w * g_along;
            let by_radius = p.dot(&to_axis) - by_length * radius;
            for (derivative, (d_direction, d_point, d_radius)) in derivatives.iter_mut().zip(tangents) {
                derivative[end] = by_direction.dot(d_direction) + by_point.dot(d_point) + by_radius * d_radius;
            }
        }
        derivatives
    }
}

/// The depth at which a ray comes nearest to a line along the axis, in units of the ray. `to_line`
/// is the perpendicular from the start of the ray to that line.
fn depth(ray: &Vector3<f64>, cylinder: &Cylinder, to_line: &Vector3<f64>) -> f64 {
    let across = ray - cylinder.direction.into_inner() * cylinder.direction.dot(ray);
    ray.dot(to_line) / across.norm_squared()
}
