//! Random cross-sections: a circle, cameras around it, and the two tangents from each.

use std::f64::consts::TAU;

use eliminant_cylinders::rectify::TangentLine;
use eliminant_cylinders::{Circle, SectionLine};
use nalgebra::{Point2, Vector2};

use crate::random::Random;

/// The two tangents of a circle from a camera outside it, turned about the camera by normal noise
/// (radians).
pub(crate) fn silhouettes(circle: &Circle, camera: &Point2<f64>, noise: f64, random: &mut Random) -> [TangentLine; 2] {
    let to_centre = circle.centre - camera;
    let sine = circle.radius / to_centre.norm();
    let towards = to_centre.normalize();
    let across = Vector2::new(-towards.y, towards.x);
    [1.0, -1.0].map(|side| {
        let exact = towards * sine + across * (side * ((1.0 - sine) * (1.0 + sine)).sqrt());
        if noise == 0.0 {
            return TangentLine { normal: exact, offset: circle.radius - exact.dot(&circle.centre.coords) };
        }
        let (sine, cosine) = (noise * random.normal()).sin_cos();
        let normal = Vector2::new(cosine * exact.x - sine * exact.y, sine * exact.x + cosine * exact.y);
        TangentLine { normal, offset: -normal.dot(&camera.coords) }
    })
}

/// A circle with its centre in `[0, 10]^2` and its radius in `[1, 2]`, and `views` cameras in all
/// directions at distances of 3 to 20 from the centre. The signs of the lines are random.
pub(crate) fn cross_section(cameras: usize, noise: f64, random: &mut Random) -> (Circle, Vec<SectionLine>) {
    let centre = Point2::new(random.uniform(0.0, 10.0), random.uniform(0.0, 10.0));
    let circle = Circle { centre, radius: random.uniform(1.0, 2.0) };
    let mut lines = Vec::with_capacity(2 * cameras);
    for view in 0..cameras {
        let (sine, cosine) = random.uniform(0.0, TAU).sin_cos();
        let camera = centre + Vector2::new(cosine, sine) * random.uniform(3.0, 20.0);
        for line in silhouettes(&circle, &camera, noise, random) {
            let sign = if random.uniform(0.0, 1.0) < 0.5 { -1.0 } else { 1.0 };
            let line = TangentLine { normal: line.normal * sign, offset: line.offset * sign };
            lines.push(SectionLine { line, weight: 1.0, view });
        }
    }
    (circle, lines)
}

/// Three lines of a cross-section, one from each of three views.
pub(crate) fn three_of_three(random: &mut Random) -> (Circle, Vec<SectionLine>) {
    let (circle, lines) = cross_section(3, 0.0, random);
    (circle, lines.into_iter().step_by(2).collect())
}

/// The larger of the distance between centres and the difference between radii, relative to the
/// true radius.
pub(crate) fn relative_error(found: &Circle, truth: &Circle) -> f64 {
    (found.centre - truth.centre).norm().max((found.radius - truth.radius).abs()) / truth.radius
}
