//! Motions of cameras as vehicles, robots and turntables make them, and five points seen by such.

use std::f64::consts::PI;

use eliminant_generator::algebra::Random;
use nalgebra::{Matrix3, Rotation3, Vector3};

use super::cameras::in_ball;
use super::linear::{null_space, uniform};

/// Rotation R and translation t: x2 = R x1 + t.
pub type Motion = (Matrix3<f64>, Vector3<f64>);

/// Draws a motion of one kind.
pub type Draw = fn(&mut Random) -> Motion;

/// The motions, by name.
pub const MOTIONS: [(&str, Draw); 8] = [
    ("general", |random| {
        let axis = in_ball(random).normalize();
        (turn(axis, uniform(random, 0.05, 0.6)), in_ball(random))
    }),
    ("planar", |random| {
        let (angle, way) = (uniform(random, -0.5, 0.5), uniform(random, 0.0, 2.0 * PI));
        (turn(Vector3::y(), angle), Vector3::new(way.sin(), 0.0, way.cos()))
    }),
    ("forward", |_| (Matrix3::identity(), Vector3::z())),
    ("sideways", |_| (Matrix3::identity(), Vector3::x())),
    ("translation", |random| (Matrix3::identity(), in_ball(random))),
    ("half turn about the optical axis", |random| (turn(Vector3::z(), PI), in_ball(random))),
    ("quarter turn about the optical axis", |random| (turn(Vector3::z(), 0.5 * PI), in_ball(random))),
    // Five units from the axis of the table.
    ("turntable", |random| {
        let rotation = turn(Vector3::y(), uniform(random, 0.1, 0.6));
        (rotation, DEPTH * (Vector3::z() - rotation * Vector3::z()))
    }),
];

/// The centre of the points, in front of the first camera.
const DEPTH: f64 = 5.0;

fn turn(axis: Vector3<f64>, angle: f64) -> Matrix3<f64> {
    Rotation3::new(axis * angle).into_inner()
}

/// The null space of the five epipolar equations, and the essential matrix, row by row.
pub fn five_points(random: &mut Random, (rotation, translation): Motion) -> (Vec<f64>, Vec<f64>) {
    let rows: Vec<Vec<f64>> = (0..5)
        .map(|_| {
            let x1 = in_ball(random) + DEPTH * Vector3::z();
            let x2 = rotation * x1 + translation;
            let [x1, x2] = [x1 / x1.z, x2 / x2.z];
            (0..9).map(|at| x2[at / 3] * x1[at % 3]).collect()
        })
        .collect();
    let essential = translation.cross_matrix() * rotation;
    (null_space(&rows).concat(), essential.transpose().as_slice().to_vec())
}
