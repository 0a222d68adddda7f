//! Poses of platforms from the lengths of their legs.

use std::array::from_fn;

use eliminant_generator::algebra::Random;
use nalgebra::{Matrix3, Vector3};

use super::cameras::{camera, cayley, in_ball};
use super::{KnownInstance, Make, Maker, derived_null_space, relative_error};

pub(super) fn makers() -> Vec<Maker> {
    vec![Maker {
        name: "platform_forward_kinematics",
        make: Make::Scene(known_pose),
        error: |_, solution, truth| relative_error(solution, truth),
    }]
}

/// Joints of the base in the unit ball, those of the platform in one of radius 0.4, one to two
/// units apart. The truth is the rotation between frames that the solver derives.
fn known_pose(random: &mut Random) -> KnownInstance {
    let base: [Vector3<f64>; 6] = from_fn(|_| in_ball(random));
    let platform: [Vector3<f64>; 6] = from_fn(|_| 0.4 * in_ball(random));
    let (rotation, position) = camera(random);
    let lengths = from_fn::<_, 6, _>(|k| (rotation * platform[k] + 0.5 * position - base[k]).norm());

    let row = |k: usize| {
        let [x, origin] = [platform[k] - platform[0], base[k] - base[0]];
        x.iter().copied().chain(origin.iter().map(|x| -x)).collect::<Vec<f64>>()
    };
    let mut rows: Vec<_> = (1..6).map(row).collect();
    // The unit of the solver: the sign of a null vector is not that of rows of another length.
    let unit = rows.iter().flatten().map(|x| x * x).sum::<f64>().sqrt();
    rows.iter_mut().flatten().for_each(|x| *x /= unit);
    let null = derived_null_space(&rows);
    let [of_platform, of_base] = [0, 3].map(|at| Vector3::from_column_slice(&null[at..at + 3]));
    let turned = frame(&of_base) * rotation * frame(&of_platform).transpose();
    // The base moves before the platform if its part of the null vector is the longer one.
    let turned = if of_platform.norm() < of_base.norm() { turned.transpose() } else { turned };
    let positions = base.iter().chain(&platform).flat_map(|joint| joint.iter().copied());
    KnownInstance { data: positions.chain(lengths).collect(), truths: vec![cayley(&turned)] }
}

/// Axes, a row each, of which the third is along v and the first across the coordinate axis that v
/// is farthest from.
fn frame(v: &Vector3<f64>) -> Matrix3<f64> {
    let third = v.normalize();
    let first = third.cross(&Vector3::ith(third.iamin(), 1.0)).normalize();
    Matrix3::from_rows(&[first.transpose(), third.cross(&first).transpose(), third.transpose()])
}
