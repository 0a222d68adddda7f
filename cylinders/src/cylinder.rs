//! Step 4: the cylinder in space, its silhouettes in a camera, and how far a given line is from them.

use std::fmt;

use nalgebra::{Point3, Unit, Vector3};
use serde::Serialize;

use super::circle::Circle;
use super::rectify::Rectification;
use super::silhouette_distance::{SilhouetteDistance, lines_with_ends};
use super::view::{Camera, View, ViewingPlane};

/// A point counts as on the surface when it is within this part of the radius.
pub(super) const NEAR_SURFACE: f64 = 0.05;

/// An infinite circular cylinder.
///
/// ```text
///     | (X - A) - w w^T (X - A) | = r
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder {
    /// The point `A` of the axis that is nearest to the world's origin.
    pub axis_point: Point3<f64>,
    /// Unit direction `w` of the axis.
    pub direction: Unit<Vector3<f64>>,
    /// Radius `r`, world units.
    pub radius: f64,
}

/// A side of the axis as a camera sees it that looks at the axis from where it stands, the direction `w` pointing up. So the
/// left silhouettes of all cameras around a cylinder touch it in the same sense of rotation, however the cameras are rolled.
#[derive(Clone, Copy, Debug, Eq, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Side {
    /// Left of the axis.
    Left,
    /// Right of the axis.
    Right,
}

impl fmt::Display for Side {
    fn fmt(&self, text: &mut fmt::Formatter<'_>) -> fmt::Result {
        text.write_str(match self {
            Self::Left => "left",
            Self::Right => "right",
        })
    }
}

/// How far a silhouette line is from the silhouette of a cylinder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineResidual {
    /// Index of the view.
    pub view: usize,
    /// Index of the line in its view.
    pub line: usize,
    /// Side of the silhouette that is nearest to the line: to its end points, or without these by the angle.
    pub side: Side,
    /// Signed distance between viewing plane and cylinder, world units: distance of the axis from the plane, turned about
    /// its camera centre to be parallel to the axis, minus the radius. Negative where the plane cuts the cylinder.
    pub distance: f64,
    /// Angle between the viewing plane and the tangent plane of that silhouette, radians.
    pub angle: f64,
    /// Distance in pixels, when the camera has a calibration: root mean square distance of the end points of the given line
    /// from the silhouette, as RANSAC and refinement measure it; for a line without end points, the distance of its
    /// point that is nearest to the principal point.
    pub pixels: Option<f64>,
}

impl LineResidual {
    /// The angle with the sign of the distance: negative where the viewing plane cuts the cylinder, radians.
    pub fn signed_angle(&self) -> f64 {
        self.angle.copysign(self.distance)
    }
}

impl Cylinder {
    /// The cylinder through `point` along `direction`; `axis_point` becomes the point of the axis nearest to the origin.
    pub fn new(point: &Point3<f64>, direction: Unit<Vector3<f64>>, radius: f64) -> Self {
        let along = direction.into_inner() * direction.dot(&point.coords);
        Self { axis_point: point - along, direction, radius }
    }

    /// The cylinder over a circle of the cross-section: inverse of the rectification.
    pub fn from_circle(circle: &Circle, rectification: &Rectification, direction: Unit<Vector3<f64>>) -> Self {
        Self::new(&rectification.world_point(&circle.centre), direction, circle.radius)
    }

    /// The point of the axis at a height: a signed distance along it from `axis_point`, world units.
    pub fn axis_at(&self, height: f64) -> Point3<f64> {
        self.axis_point + self.direction.into_inner() * height
    }

    /// The height of a point: inverse of [`Cylinder::axis_at`] for the nearest point of the axis.
    pub fn height(&self, point: &Point3<f64>) -> f64 {
        self.direction.dot(&(point - self.axis_point))
    }

    /// Perpendicular from a point to the axis, pointing at the axis.
    pub(super) fn vector_to_axis(&self, point: &Point3<f64>) -> Vector3<f64> {
        let difference = self.axis_point - point;
        difference - self.direction.into_inner() * self.direction.dot(&difference)
    }

    /// Signed distance of a point from the surface: negative inside.
    pub fn distance(&self, point: &Point3<f64>) -> f64 {
        self.vector_to_axis(point).norm() - self.radius
    }

    /// Whether a point is on the surface, within 5 % of the radius.
    pub fn is_near(&self, point: &Point3<f64>) -> bool {
        self.distance(point).abs() <= NEAR_SURFACE * self.radius
    }

    /// The two silhouette lines in a camera, unit vectors in normalised image coordinates, or `None` when its centre is
    /// not outside the cylinder.
    ///
    /// With `m` the perpendicular from the centre `C` to the axis, `rho = |m|` and the frame `e1 = m / rho`,
    /// `e2 = w x e1`, the tangent planes through `C` have the normals `n = (r / rho) e1 +- sqrt(1 - (r / rho)^2) e2`,
    /// because `n^T m = r`; the lines are `l = R n`. The axis is on the positive side of both. The first is the right one, the
    /// second the left one: the plane touches at `A' - r n`, with `A'` the point of the axis beside the camera, and `-e2`
    /// points to the right.
    pub fn silhouette(&self, camera: &Camera) -> Option<[Vector3<f64>; 2]> {
        let to_axis = self.vector_to_axis(&camera.centre());
        let sine = self.radius / to_axis.norm();
        if sine.is_nan() || sine >= 1.0 {
            return None;
        }
        let first = to_axis.normalize();
        let second = self.direction.cross(&first);
        let cosine = ((1.0 - sine) * (1.0 + sine)).sqrt();
        Some([1.0, -1.0].map(|side| camera.rotation() * (first * sine + second * (side * cosine))))
    }

    /// Residuals of the lines of a view, or `None` when it has lines but its camera is not outside the cylinder. `view` is
    /// the index that the residuals carry.
    pub fn residuals(&self, view: usize, lines: &View) -> Option<Vec<LineResidual>> {
        if lines.lines().is_empty() {
            return Some(Vec::new());
        }
        let camera = lines.camera();
        let silhouette = self.silhouette(camera)?;
        let at_ends: Vec<_> =
            lines_with_ends(view, lines).iter().map(|measured| measured.as_ref()?.distance(self)).collect();
        let residual = |(index, (line, plane)): (usize, (&Vector3<f64>, ViewingPlane))| {
            // Lines have no sign: the angle is between 0 and pi / 2.
            let angle = |other: &Vector3<f64>| line.cross(other).norm().atan2(line.dot(other).abs());
            let [right, left] = &silhouette;
            let at_ends = at_ends[index].as_ref();
            let by_angle = if angle(left) < angle(right) { Side::Left } else { Side::Right };
            let side = at_ends.map_or(by_angle, SilhouetteDistance::side);
            let nearest = if side == Side::Left { left } else { right };
            let pixels = match at_ends {
                Some(distance) => camera.calibration().map(|_| distance.mean_square().sqrt()),
                None => pixel_distance(camera, line, nearest),
            };
            let distance = self.plane_distance(&plane);
            LineResidual { view, line: index, side, distance, angle: angle(nearest), pixels }
        };
        Some(lines.lines().iter().zip(lines.planes()).enumerate().map(residual).collect())
    }

    /// Distance of the axis from the plane, turned to be parallel to it, minus the radius.
    fn plane_distance(&self, plane: &ViewingPlane) -> f64 {
        let w = self.direction.into_inner();
        let normal = (plane.normal - w * w.dot(&plane.normal)).normalize();
        normal.dot(&self.vector_to_axis(&plane.centre)).abs() - self.radius
    }
}

/// Distance in pixels of `silhouette` from the point of `line` nearest to the principal point; both lines in normalised
/// coordinates. `None` without calibration, or when that point is far outside every image.
fn pixel_distance(camera: &Camera, line: &Vector3<f64>, silhouette: &Vector3<f64>) -> Option<f64> {
    let calibration = camera.calibration()?;
    let [line, silhouette] = [line, silhouette].map(|line| calibration.line_to_pixels(line)).map(|line| {
        let norm = line.xy().norm();
        line / norm
    });
    let principal = calibration.matrix().column(2).clone_owned();
    let foot = principal.xy() - line.xy() * line.dot(&principal);
    let distance = (silhouette.xy().dot(&foot) + silhouette.z).abs();
    distance.is_finite().then_some(distance)
}
