//! Pose of a camera from points and lines.

use std::array::from_fn;

use eliminant_generator::algebra::Random;
use nalgebra::{Matrix3, Vector3};

use super::cameras::quaternion;
use super::{
    KnownInstance, Make, Maker, View, coordinates, derived_null_space, projective_error, uniform, vector, weights,
};

pub(super) fn makers() -> Vec<Maker> {
    let error = |_: &[f64], solution: &[f64], truth: &[f64]| projective_error(&vector(solution), &vector(truth));
    vec![
        Maker { name: "pose_1pt_2line", make: Make::KnownPoints(|random, view| seen::<1, 2>(random, view).0), error },
        Maker { name: "pose_2pt_1line", make: Make::KnownPoints(two_points_and_a_line), error },
        Maker { name: "pose_3line", make: Make::KnownPoints(|random, view| seen::<0, 3>(random, view).0), error },
    ]
}

/// Rays of any length and positions of points; normals of any length of the planes in which lines
/// are seen, and two points of each line in the unit ball. The quaternion of the rotation, and the
/// rotation.
fn seen<const POINTS: usize, const LINES: usize>(random: &mut Random, view: View) -> (KnownInstance, Matrix3<f64>) {
    let pose = view.camera(random);
    let points: [Vector3<f64>; POINTS] = from_fn(|k| view.point(random, &pose, k));
    let (rotation, translation) = pose;
    let rays = points.map(|x| (rotation * x + translation) * uniform(random, 0.5, 2.0));
    let lines: [[Vector3<f64>; 2]; LINES] =
        from_fn(|line| from_fn(|end| view.point(random, &pose, POINTS + line + end)));
    let normals = lines.map(|line| normal((&rotation, &translation), line, random));
    let vectors = rays.iter().chain(&points).chain(&normals).chain(lines.as_flattened());
    let data = vectors.flat_map(|v| v.data.0[0]).collect();
    (KnownInstance { data, truths: vec![coordinates(&quaternion(&rotation))] }, rotation)
}

/// The weights of the normal in the frame of the points.
fn two_points_and_a_line(random: &mut Random, view: View) -> KnownInstance {
    let (mut instance, rotation) = seen::<2, 1>(random, view);
    let vector = |at: usize| Vector3::from_column_slice(&instance.data[3 * at..][..3]);
    let direction = vector(6) - vector(5);
    let known = rotation.transpose() * vector(4);
    let basis = derived_null_space(&[direction.as_slice().to_vec()]);
    instance.truths = vec![coordinates(&weights(&basis, known.as_slice()))];
    instance
}

/// The image of a line, from the rays of two points of it, which are others than those that are
/// given.
fn normal(
    (rotation, translation): (&Matrix3<f64>, &Vector3<f64>),
    [p, q]: [Vector3<f64>; 2],
    random: &mut Random,
) -> Vector3<f64> {
    let rays: [Vector3<f64>; 2] =
        from_fn(|k| rotation * (p + (q - p) * (k as f64 + uniform(random, -0.25, 0.25))) + translation);
    rays[0].normalize().cross(&rays[1].normalize()) * uniform(random, 0.5, 2.0)
}
