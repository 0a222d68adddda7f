//! Step 4: the cylinder in space, its silhouettes in a camera, and the distance of a given line
//! from them.

/// Given lines against the silhouettes of a cylinder.
mod residual;
/// Left and right of the axis.
mod side;

use nalgebra::{Point3, Unit, Vector3};

use crate::cross_section::circle::Circle;
use crate::cross_section::rectify::Rectification;
use crate::observations::view::Camera;

pub use residual::LineResidual;
pub use side::Side;

/// A point counts as on the surface if its distance is within this part of the radius.
pub(crate) const NEAR_SURFACE: f64 = 0.05;

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

impl Cylinder {
    /// The cylinder through `point` along `direction`; `axis_point` becomes the point of the axis
    /// nearest to the origin.
    pub fn new(point: &Point3<f64>, direction: Unit<Vector3<f64>>, radius: f64) -> Self {
        let along = direction.into_inner() * direction.dot(&point.coords);
        Self { axis_point: point - along, direction, radius }
    }

    /// The cylinder over a circle of the cross-section: inverse of the rectification.
    pub fn from_circle(circle: &Circle, rectification: &Rectification, direction: Unit<Vector3<f64>>) -> Self {
        Self::new(&rectification.world_point(&circle.centre), direction, circle.radius)
    }

    /// The same cylinder; the entry of largest magnitude of its direction is positive.
    pub fn with_canonical_sign(self) -> Self {
        let is_negative = self.direction[self.direction.iamax()] < 0.0;
        Self { direction: if is_negative { -self.direction } else { self.direction }, ..self }
    }

    /// The point of the axis at a height: a signed distance along it from `axis_point`, world
    /// units.
    pub fn axis_at(&self, height: f64) -> Point3<f64> {
        self.axis_point + self.direction.into_inner() * height
    }

    /// The height of a point: the inverse of [`Cylinder::axis_at`] for the nearest point of the
    /// axis.
    pub fn height(&self, point: &Point3<f64>) -> f64 {
        self.direction.dot(&(point - self.axis_point))
    }

    /// Perpendicular from a point to the axis, pointing at the axis.
    pub(crate) fn vector_to_axis(&self, point: &Point3<f64>) -> Vector3<f64> {
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

    /// The two silhouette lines in a camera, unit vectors in normalised image coordinates; `None`
    /// if the camera centre is not outside the cylinder.
    ///
    /// With `m` the perpendicular from the centre `C` to the axis, `rho = |m|` and the frame
    /// `e1 = m / rho`, `e2 = w x e1`, the tangent planes through `C` have the normals
    /// `n = (r / rho) e1 +- sqrt(1 - (r / rho)^2) e2`, because `n^T m = r`; the lines are
    /// `l = R n`. The axis is on the positive side of both. The first line is the right silhouette
    /// and the second the left one: the plane touches at `A' - r n`, where `A'` is the point of the
    /// axis beside the camera, and `-e2` points to the right.
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
}
