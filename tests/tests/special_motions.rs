//! Motions of cameras as vehicles, robots and turntables make them: their data have structure, so
//! that entries of null vectors vanish or are equal. No solver may lose them.

use std::f64::consts::PI;

use eliminant_generator::algebra::Random;
use eliminant_solvers::relpose_5pt;
use eliminant_tests::ground_truth::{combination, in_ball, null_space, projective_error, uniform};
use nalgebra::{Matrix3, Rotation3, Vector3};
use rayon::prelude::*;

/// Scenes of each motion.
const SCENES: u64 = 1_000;
/// Scenes of which the true solution may be missing.
const LOST: usize = 3;
/// A truth counts as found if a solution is this close, up to scale.
const FOUND: f64 = 1e-6;

/// Rotation R and translation t: x2 = R x1 + t.
type Motion = (Matrix3<f64>, Vector3<f64>);

/// Draws a motion of one kind.
type Draw = fn(&mut Random) -> Motion;

/// The motions, by name.
const MOTIONS: [(&str, Draw); 8] = [
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
fn five_points(random: &mut Random, (rotation, translation): Motion) -> (Vec<f64>, Vec<f64>) {
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

/// Whether the essential matrix is among the solutions.
fn is_found(basis: &[f64], essential: &[f64]) -> bool {
    let matrices = std::array::from_fn(|k| std::array::from_fn(|i| std::array::from_fn(|j| basis[9 * k + 3 * i + j])));
    let Ok(found) = relpose_5pt::solve(&matrices) else { return false };
    found.iter().any(|s| projective_error(&combination(basis, &s.weights), essential) <= FOUND)
}

#[test]
fn five_points_of_special_motions() {
    let mut faults = Vec::new();
    for (name, motion) in MOTIONS {
        let is_lost = |k: &u64| {
            let random = &mut Random::new(31_000_000 + k);
            let motion = motion(random);
            let (basis, essential) = five_points(random, motion);
            !is_found(&basis, &essential)
        };
        let lost = (0..SCENES).into_par_iter().filter(is_lost).count();
        println!("{name}: the truth is missing in {lost} of {SCENES} scenes");
        if lost > LOST {
            faults.push((name, lost));
        }
    }
    assert!(faults.is_empty(), "{faults:?}");
}
