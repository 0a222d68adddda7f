//! Step 4a: the cylinder as a quadric of points and as a dual quadric of planes, and its outline as
//! a dual conic of lines.
//!
//! With `N = I - w w^T` the projection across the axis, `A` the point of the axis nearest to the
//! origin (`N A = A`) and homogeneous points `X~ = (X, 1)` and planes `pi = (n, d)`,
//! `n^T X + d = 0`, the definition `| N (X - A) |^2 = r^2` of a cylinder and the tangency
//! `(n^T A + d)^2 = r^2 |n|^2` of a plane along its axis read
//!
//! ```text
//!       [  N       -A      ]
//!   C = [ -A^T  A^T A - r^2]        X~^T C X~ = 0
//!
//!       [ r^2 N - A A^T  -A ]
//!   D = [     -A^T       -1 ]       pi^T D pi = 0  and  n^T w = 0
//! ```
//!
//! Both have rank three and are inverse to each other except along the axis: `C D C = r^2 C` and
//! `D C D = r^2 D`. Among the matrices that agree on all planes with `n^T w = 0`, `D` is the one
//! with `D (w, 0) = 0`. For other planes `pi^T D pi = 0` holds if they touch the circle around `A`.
//!
//! A camera `P = [R t]` sees the plane `P^T l` as the line `l`, so the lines of the outline satisfy
//!
//! ```text
//!   l^T (P D P^T) l = 0   and   l^T R w = 0
//! ```
//!
//! (Hartley & Zisserman, "Multiple View Geometry", section 8.3, for the dual conic of an outline;
//! Gummeson & Oskarsson, "Robust and Accurate Cylinder Triangulation", for a cylinder). In an
//! orthonormal basis `E` (3x2) of the lines through the vanishing point `R w` this is a quadratic
//! form in two unknowns. It has two lines, which are real if the camera centre is outside.

use nalgebra::{Matrix4, Unit, Vector2, Vector3, Vector4};

use super::cylinder::Cylinder;
use crate::observations::view::Camera;

impl Cylinder {
    /// The quadric `C`, 4x4, squared world units: `X~^T C X~` is the squared distance of `X` from
    /// the axis minus `r^2`.
    pub fn quadric(&self) -> Matrix4<f64> {
        let (w, a) = (self.direction.into_inner(), self.axis_point.coords);
        let mut quadric = Matrix4::zeros();
        quadric.fixed_view_mut::<3, 3>(0, 0).copy_from(&across(&w));
        quadric.fixed_view_mut::<3, 1>(0, 3).copy_from(&-a);
        quadric.fixed_view_mut::<1, 3>(3, 0).copy_from(&-a.transpose());
        quadric[(3, 3)] = a.norm_squared() - self.radius * self.radius;
        quadric
    }

    /// The dual quadric `D`, 4x4, squared world units. For a plane with a normal of unit length
    /// along the axis, `pi^T D pi` is `r^2` minus its squared distance from the axis.
    pub fn dual_quadric(&self) -> Matrix4<f64> {
        let centre = self.axis_point.to_homogeneous();
        let mut dual = -centre * centre.transpose();
        let mut upper = dual.fixed_view_mut::<3, 3>(0, 0);
        upper += across(&self.direction) * (self.radius * self.radius);
        dual
    }
}

/// The two silhouette lines in a camera of a cylinder along `direction` with the dual quadric
/// `dual` (any non-zero multiple), in the order and with the signs of [`Cylinder::silhouette`].
/// `None` if the outline has no real lines: the camera is inside, or the dual conic of the
/// cross-section is not an ellipse.
pub fn silhouette_of_dual_quadric(
    dual: &Matrix4<f64>,
    direction: &Unit<Vector3<f64>>,
    camera: &Camera,
) -> Option<[Vector3<f64>; 2]> {
    let vanishing_point = camera.rotation() * direction.into_inner();
    let first = vanishing_point.cross(&Vector3::ith(vanishing_point.iamin(), 1.0)).normalize();
    let basis = [first, vanishing_point.cross(&first)];

    // The pole of the plane at infinity is the centre of the cross-section.
    let centre = dual.column(3) / dual[(3, 3)];
    // Planes through the camera centre: `P^T l`, in the basis.
    let planes = basis.map(|line| {
        let normal = camera.rotation().tr_mul(&line);
        Vector4::new(normal.x, normal.y, normal.z, line.dot(camera.translation()))
    });
    let form = |i: usize, j: usize| planes[i].dot(&(dual * planes[j]));
    let (a, b, c) = (form(0, 0), form(0, 1), form(1, 1));

    // Eigenvectors at the angles `turn` and `turn + pi / 2`: in them the form is
    // `high p^2 + low q^2`.
    let (mean, difference) = ((a + c) / 2.0, (a - c) / 2.0);
    let (spread, turn) = (difference.hypot(b), b.atan2(difference) / 2.0);
    let (high, low) = (mean + spread, mean - spread);
    let real = high > 0.0 && low < 0.0;
    if !real {
        return None;
    }
    let eigenvectors = [Vector2::new(turn.cos(), turn.sin()), Vector2::new(-turn.sin(), turn.cos())];
    let (p, q) = ((-low / (high - low)).sqrt(), (high / (high - low)).sqrt());
    let lines = [q, -q].map(|q| {
        let coordinates = eigenvectors[0] * p + eigenvectors[1] * q;
        let distance = planes[0].dot(&centre) * coordinates.x + planes[1].dot(&centre) * coordinates.y;
        (basis[0] * coordinates.x + basis[1] * coordinates.y) * distance.signum()
    });
    let in_order = lines[0].cross(&lines[1]).dot(&vanishing_point) < 0.0;
    Some(if in_order { lines } else { [lines[1], lines[0]] })
}

/// `I - w w^T`.
fn across(w: &Vector3<f64>) -> nalgebra::Matrix3<f64> {
    nalgebra::Matrix3::identity() - w * w.transpose()
}
