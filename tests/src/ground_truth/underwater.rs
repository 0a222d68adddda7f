//! A camera above water that looks at points in it.

use std::array::from_fn;
use std::f64::consts::PI;

use eliminant_generator::algebra::Random;
use nalgebra::{Matrix3, Rotation3, Vector2, Vector3};

use super::cameras::in_ball;
use super::{View, uniform};

/// A camera that looks into water.
#[derive(Clone, Debug)]
pub struct Underwater {
    /// From the frame of the camera to that of the points, whose third axis points down.
    pub rotation: Matrix3<f64>,
    /// The camera, above the plane Z = 0.
    pub centre: Vector3<f64>,
    /// Rays in the camera, of any length.
    pub rays: [Vector3<f64>; 5],
    /// Points in the water.
    pub points: [Vector3<f64>; 5],
}

/// The index of refraction of water.
pub const WATER: f64 = 1.33;

impl Underwater {
    /// A camera 1 to 3 units above the water, turned in any way, that sees points up to 3 units
    /// deep, by Snell's law.
    pub fn draw(random: &mut Random, view: View) -> Self {
        let rotation = view.rotation(random).unwrap_or_else(|| Rotation3::new(PI * in_ball(random)).into_inner());
        let (foot, height) = (
            Vector2::from_fn(|_, _| if view == View::AtOrigin { 0.0 } else { random.symmetric_unit() }),
            uniform(random, 1.0, 3.0),
        );
        let flat = matches!(view, View::Plane | View::Frontal | View::Square | View::SquareHeadOn);
        let bottom = uniform(random, 0.5, 3.0);
        let seen: [(Vector3<f64>, Vector3<f64>); 5] = from_fn(|k| {
            let mut surface = Vector2::from_fn(|_, _| 2.0 * random.symmetric_unit());
            if view == View::Centred && k == 0 {
                surface = foot;
            }
            let direction = (surface - foot).push(height).normalize();
            let sine = direction.xy() / WATER;
            let refracted = sine / (1.0 - sine.norm_squared()).sqrt();
            let depth = if flat { bottom } else { uniform(random, 0.5, 3.0) };
            (uniform(random, 0.5, 2.0) * direction, (surface + depth * refracted).push(depth))
        });
        Self {
            rotation,
            centre: foot.push(-height),
            rays: seen.map(|(direction, _)| rotation.transpose() * direction),
            points: seen.map(|(_, point)| point),
        }
    }
}
