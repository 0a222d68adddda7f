//! The camera that saw a tangent line of the cross-section, and whether a circle is in front of it.
//!
//! ```text
//!               ray d, into the image
//!        C ---------------------------->     a circle (p, r) is in front:
//!                   (  p  )                  d^T (p - C) > 0,  |p - C| > r
//! ```

use nalgebra::{Point2, Unit, Vector2, Vector3};

use super::circle::Circle;
use super::rectify::Rectification;
use crate::observations::view::ViewingPlane;

/// Sine of the angle between a camera's optical axis and the cross-section. Above it the vanishing
/// point of the cylinder's axis may lie in the image, and a line through that point shows both
/// rays.
const STEEP: f64 = 0.7;

/// A camera in the cross-section, and the part of a tangent line that it sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sight {
    /// Camera centre, world units.
    pub camera: Point2<f64>,
    /// Unit direction of the ray into the image; `None` if the camera looks too steeply along the
    /// axis to decide.
    pub ray: Option<Vector2<f64>>,
}

impl Sight {
    /// The camera and the ray of the line of this plane.
    pub fn of(plane: &ViewingPlane, direction: &Unit<Vector3<f64>>, rectification: &Rectification) -> Self {
        let camera = rectification.point(&plane.centre);
        let forward = rectification.point(&(plane.centre + plane.forward)) - camera;
        let along = plane.normal.cross(direction);
        let along = rectification.point(&(plane.centre + along)) - camera;
        let is_clear = plane.forward.dot(direction).abs() < STEEP;
        let ray = along.try_normalize(0.0).map(|ray| if ray.dot(&forward) < 0.0 { -ray } else { ray });
        Self { camera, ray: ray.filter(|_| is_clear) }
    }

    /// Whether the circle is in front of the camera and does not contain it.
    pub fn has_in_front(&self, circle: &Circle) -> bool {
        let to_centre = circle.centre - self.camera;
        let outside = to_centre.norm() > circle.radius;
        outside && self.ray.is_none_or(|ray| ray.dot(&to_centre) > 0.0)
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{Matrix3x4, Point3};

    use super::*;
    use crate::{Camera, View};

    /// A camera at (0, 0, -10) that looks along z, or upwards by an angle, at a cylinder upright in
    /// the origin.
    #[test]
    fn circles_in_front_are_told_from_those_behind_and_around() {
        let direction = Vector3::y_axis();
        for (elevation, clear) in [(0.0_f64, true), (0.5, true), (1.0, false)] {
            let (sine, cosine) = elevation.sin_cos();
            let centre = Point3::new(0.0, 0.0, -10.0);
            let rotation = nalgebra::Matrix3::new(1.0, 0.0, 0.0, 0.0, cosine, -sine, 0.0, sine, cosine);
            let mut matrix = Matrix3x4::zeros();
            matrix.fixed_view_mut::<3, 3>(0, 0).copy_from(&rotation);
            matrix.set_column(3, &-(rotation * centre.coords));
            let camera = Camera::from_normalised(&matrix).expect("a camera");
            // The image of the line (1, t, 0).
            let [low, high] = [-1.0, 1.0].map(|t| rotation * (Point3::new(1.0, t, 0.0) - centre));
            let view = View::from_normalised_lines(camera, &[low.cross(&high)]).expect("a view");
            let plane = view.planes().next().expect("a plane");
            let rectification = Rectification::new(&direction, Point3::origin());
            let sight = Sight::of(&plane, &direction, &rectification);
            assert_eq!(sight.ray.is_some(), clear, "{elevation}");
            let at = |z: f64, radius| Circle { centre: rectification.point(&Point3::new(0.0, 0.0, z)), radius };
            assert!(sight.has_in_front(&at(0.0, 1.0)));
            assert_eq!(sight.has_in_front(&at(-20.0, 1.0)), !clear);
            assert!(!sight.has_in_front(&at(0.0, 11.0)));
        }
    }
}
