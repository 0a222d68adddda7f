//! Step 2: the cross-section. A rotation takes the axis direction to `(0, 1, 0)`; a tangent plane
//! is then a line in the plane of `x` and `z`, and the cylinder a circle that touches all these
//! lines.
//!
//! ```text
//!       [ u^T ]
//!   Q = [ w^T ]    Q w = (0, 1, 0),    X' = Q (X - O),    (x, z) = (X'_1, X'_3)
//!       [ v^T ]
//! ```
//!
//! The caller chooses the origin `O` near the scene, so that coordinates are small.

use nalgebra::{Matrix3, Point2, Point3, Unit, Vector2, Vector3};

use crate::observations::view::ViewingPlane;

/// Smallest cosine between a viewing plane and the axis direction. Noise cannot explain a plane at
/// more than 60 degrees to the axis.
const MIN_COSINE: f64 = 0.5;

/// The map between the world and the cross-section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rectification {
    rotation: Matrix3<f64>,
    origin: Point3<f64>,
}

/// A line `a x + b z + c = 0` of the cross-section, `(a, b)` of unit length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TangentLine {
    /// Unit normal `(a, b)`.
    pub normal: Vector2<f64>,
    /// Offset `c`: signed distance of the line from the origin of the cross-section.
    pub offset: f64,
}

impl TangentLine {
    /// Signed distance of a point from the line.
    pub fn distance(&self, point: &Point2<f64>) -> f64 {
        self.normal.dot(&point.coords) + self.offset
    }
}

impl Rectification {
    /// The rotation is built from an orthonormal frame, exact to rounding for every direction. (An
    /// angle from an arc cosine would lose half of the digits for a direction near `(0, 1, 0)`.)
    pub fn new(direction: &Unit<Vector3<f64>>, origin: Point3<f64>) -> Self {
        let w = direction.into_inner();
        let mut axis = Vector3::zeros();
        axis[w.iamin()] = 1.0;
        let u = (axis - w * w.dot(&axis)).normalize();
        let v = u.cross(&w);
        Self { rotation: Matrix3::from_rows(&[u.transpose(), w.transpose(), v.transpose()]), origin }
    }

    /// The line in which the plane cuts the cross-section; `None` if the plane is too steep to the
    /// axis.
    ///
    /// With noise a plane is not quite parallel to the axis, and the line in which it cuts the
    /// cross-section would depend on the choice of the world's origin. The plane is therefore
    /// turned about its camera centre until it is parallel: the normal loses its component along
    /// `w`, and the line passes through the projection of the camera centre.
    pub fn line(&self, plane: &ViewingPlane) -> Option<TangentLine> {
        let normal = self.rotation * plane.normal;
        let normal = Vector2::new(normal[0], normal[2]);
        let cosine = normal.norm();
        if cosine.is_nan() || cosine < MIN_COSINE {
            return None;
        }
        let normal = normal / cosine;
        Some(TangentLine { normal, offset: -normal.dot(&self.point(&plane.centre).coords) })
    }

    /// Projects a world point along the axis.
    pub fn point(&self, point: &Point3<f64>) -> Point2<f64> {
        let rotated = self.rotation * (point - self.origin);
        Point2::new(rotated[0], rotated[2])
    }

    /// The world point in the cross-section plane through the origin `O`: the inverse of
    /// [`Rectification::point`].
    pub fn world_point(&self, point: &Point2<f64>) -> Point3<f64> {
        self.origin + self.rotation.tr_mul(&Vector3::new(point.x, 0.0, point.y))
    }
}
