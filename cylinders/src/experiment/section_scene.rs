//! Circles and their tangents in the plane of the cross-section.

use nalgebra::{Point2, Vector2};

use crate::cross_section::sight;
use crate::random::Random;
use crate::rectify::TangentLine;
use crate::{Circle, SectionLine};

/// The tangent that touches the circle in this direction from its centre.
pub(super) fn tangent(circle: &Circle, angle: f64, view: usize) -> SectionLine {
    let normal = Vector2::new(angle.cos(), angle.sin());
    let line = TangentLine { normal, offset: -circle.radius - normal.dot(&circle.centre.coords) };
    SectionLine { line, weight: 1.0, view }
}

/// A camera and the noise of the two lines that it sees.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sight {
    pub(super) camera: Point2<f64>,
    pub(super) view: usize,
    /// Deviations of the two lines, in units of the noise.
    pub(super) deviations: [f64; 2],
}

impl Sight {
    /// A camera with the deviations of its lines drawn from the standard normal distribution.
    pub(super) fn new(camera: Point2<f64>, view: usize, random: &mut Random) -> Self {
        Self { camera, view, deviations: [random.normal(), random.normal()] }
    }

    /// The camera as triangulation knows it; it looks at the circle.
    pub(super) fn seen(&self, circle: &Circle) -> sight::Sight {
        let towards = circle.centre - self.camera;
        sight::Sight { camera: self.camera, ray: Some(towards.normalize()) }
    }

    /// The two silhouettes of a circle, turned about the camera by the deviations times `noise`,
    /// radians.
    pub(super) fn lines(&self, circle: &Circle, noise: f64) -> [SectionLine; 2] {
        let to_centre = circle.centre - self.camera;
        let sine = circle.radius / to_centre.norm();
        let towards = to_centre.normalize();
        let across = Vector2::new(-towards.y, towards.x);
        [0, 1].map(|side| {
            let sign = [1.0, -1.0][side];
            let exact = towards * sine + across * (sign * ((1.0 - sine) * (1.0 + sine)).sqrt());
            let (sine, cosine) = (noise * self.deviations[side]).sin_cos();
            let normal = Vector2::new(cosine * exact.x - sine * exact.y, sine * exact.x + cosine * exact.y);
            let line = TangentLine { normal, offset: -normal.dot(&self.camera.coords) };
            SectionLine { line, weight: 1.0, view: self.view }
        })
    }
}

/// Distance between the centres, and between the radii.
pub(super) fn errors(found: &Circle, truth: &Circle) -> [f64; 2] {
    [(found.centre - truth.centre).norm(), (found.radius - truth.radius).abs()]
}

/// Errors of the circle that is nearest to the truth, centre and radius together; infinite if there
/// is no circle.
pub(super) fn least_errors(found: impl IntoIterator<Item = Circle>, truth: &Circle) -> [f64; 2] {
    let errors = found.into_iter().map(|circle| errors(&circle, truth));
    errors.min_by(|left, right| left[0].max(left[1]).total_cmp(&right[0].max(right[1]))).unwrap_or([f64::INFINITY; 2])
}
