//! Relative pose of two cameras from points in both images.

use eliminant_generator::algebra::Random;
use nalgebra::{Matrix3, Rotation3, Vector2, Vector3};

use super::cameras::{Motion, camera, distorted, image, in_ball, quaternion, two_cameras};
use super::{
    KnownInstance, Make, Maker, View, combination, coordinates, largest_relative_error, null_space, projective_error,
    relative_error, uniform, vector, weights,
};

pub(super) fn makers() -> Vec<Maker> {
    let focal_error = |data: &[f64], s: &[f64], truth: &[f64]| {
        let [solved, known] = [s, truth].map(|x| combination(data, &vector(&x[..2])));
        projective_error(&solved, &known).max(relative_error(&s[2..], &truth[2..]))
    };
    vec![
        Maker {
            name: "relpose_3pt_angle_zero_screw",
            make: Make::TwoCameras(three_points),
            error: |_, solution, truth| relative_error(solution, truth),
        },
        Maker {
            name: "relpose_4pt_angle",
            make: Make::TwoCameras(four_points),
            error: |_, solution, truth| relative_error(solution, truth),
        },
        Maker {
            name: "relpose_5pt_generalized_angle",
            make: Make::TwoCameras(five_points_generalized),
            error: |_, solution, truth| relative_error(solution, truth),
        },
        Maker {
            name: "relpose_5pt",
            make: Make::TwoCameras(five_points),
            error: |data, s, truth| {
                let [solved, known] = [s, truth].map(|x| combination(data, &vector(x)));
                projective_error(&solved, &known)
            },
        },
        Maker {
            name: "relpose_5pt_semi_generalized_focal",
            make: Make::Scene(five_points_and_a_known_one),
            error: |_, solution, truth| relative_error(solution, truth),
        },
        Maker {
            name: "relpose_6pt_generalized",
            make: Make::TwoCameras(six_points_generalized),
            error: |_, solution, truth| projective_error(&vector(solution), &vector(truth)),
        },
        Maker {
            name: "relpose_7pt_generalized_scale",
            make: Make::TwoCameras(seven_points_generalized),
            error: |_, solution, truth| projective_error(&vector(solution), &vector(truth)),
        },
        Maker {
            name: "relpose_7pt_angle_focal_centre",
            make: Make::TwoCameras(calibration_by_angle),
            error: |_, solution, truth| relative_error(solution, truth),
        },
        Maker { name: "relpose_6pt_focal", make: Make::TwoCameras(six_points), error: focal_error },
        Maker {
            name: "stitching_3pt_radial_focal",
            make: Make::KnownPoints(panorama),
            error: |_, solution, truth| largest_relative_error(solution, truth),
        },
    ]
}

/// x2^T M x1 = 0 as a row in the nine entries of M, row by row.
pub(super) fn epipolar_row(x1: &Vector3<f64>, x2: &Vector3<f64>) -> Vec<f64> {
    (0..9).map(|at| x2[at / 3] * x1[at % 3]).collect()
}

/// `count` points seen by two cameras with focal lengths `focal`: the null space of the epipolar
/// equations, and the fundamental matrix.
fn epipolar((random, motion): (&mut Random, Motion), count: usize, focal: [f64; 2]) -> (Vec<f64>, Vec<f64>) {
    let (rotation, translation, points) = two_cameras((random, motion), count);
    let row = |x: &Vector3<f64>| {
        let [x1, x2] = [image(x, focal[0]), image(&(rotation * x + translation), focal[1])];
        epipolar_row(&x1.push(1.0), &x2.push(1.0))
    };
    let rows: Vec<Vec<f64>> = points.iter().map(row).collect();
    let inverse = focal.map(|focal| Matrix3::from_diagonal(&Vector3::new(1.0 / focal, 1.0 / focal, 1.0)));
    let fundamental = inverse[1] * translation.cross_matrix() * rotation * inverse[0];
    (null_space(&rows).concat(), fundamental.transpose().as_slice().to_vec())
}

fn five_points(random: &mut Random, motion: Motion) -> KnownInstance {
    let (data, essential) = epipolar((random, motion), 5, [1.0; 2]);
    let truth = coordinates(&weights(&data, &essential));
    KnownInstance { data, truths: vec![truth] }
}

/// Focal lengths of 0.5 to 3 times the unit of the image coordinates, which reach up to about one
/// focal length.
fn six_points(random: &mut Random, motion: Motion) -> KnownInstance {
    let focal = uniform(random, 0.5, 3.0);
    let (data, fundamental) = epipolar((random, motion), 6, [focal; 2]);
    with_focal(data, &fundamental, focal)
}

fn with_focal(data: Vec<f64>, fundamental: &[f64], focal: f64) -> KnownInstance {
    let mut truth = coordinates(&weights(&data, fundamental));
    truth.push(1.0 / (focal * focal));
    KnownInstance { data, truths: vec![truth] }
}

/// Rays in both cameras, then cosine and sine of half the angle; the imaginary part of the
/// rotation's quaternion.
fn known_angle(rotation: &Matrix3<f64>, first: &[Vector3<f64>], second: &[Vector3<f64>]) -> KnownInstance {
    let rays = first.iter().chain(second).flat_map(|x| x.normalize().data.0[0]);
    let [w, x, y, z] = quaternion(rotation);
    let sine = Vector3::new(x, y, z).norm();
    KnownInstance { data: rays.chain([w, sine]).collect(), truths: vec![vec![x, y, z]] }
}

/// The rays to points from cameras that are up to half a unit from the origins of two systems: a
/// point of each, and its direction; and the rotation between the systems.
fn generalized((random, motion): (&mut Random, Motion), count: usize) -> (Vec<f64>, Matrix3<f64>) {
    let (rotation, translation, points) = two_cameras((random, motion), count);
    let second = points.iter().map(|x| rotation * x + translation);
    let seen: Vec<Vector3<f64>> = points.iter().copied().chain(second).collect();
    let rays = seen.iter().flat_map(|x| {
        let camera = 0.5 * in_ball(random);
        [camera, (x - camera).normalize()].into_iter().flat_map(|v| v.data.0[0])
    });
    (rays.collect(), rotation)
}

fn five_points_generalized(random: &mut Random, motion: Motion) -> KnownInstance {
    let (mut data, rotation) = generalized((random, motion), 5);
    let [w, x, y, z] = quaternion(&rotation);
    data.extend([w, Vector3::new(x, y, z).norm()]);
    KnownInstance { data, truths: vec![vec![x, y, z]] }
}

fn six_points_generalized(random: &mut Random, motion: Motion) -> KnownInstance {
    let (data, rotation) = generalized((random, motion), 6);
    KnownInstance { data, truths: vec![coordinates(&quaternion(&rotation))] }
}

/// The second system measures in a unit of 0.5 to 2 times that of the first.
fn seven_points_generalized(random: &mut Random, motion: Motion) -> KnownInstance {
    let (mut data, rotation) = generalized((random, motion), 7);
    let scale = uniform(random, 0.5, 2.0);
    let (_, second) = data.split_at_mut(7 * 6);
    second.chunks_mut(6).flat_map(|ray| &mut ray[..3]).for_each(|coordinate| *coordinate /= scale);
    KnownInstance { data, truths: vec![coordinates(&quaternion(&rotation))] }
}

/// A camera of focal length 0.5 to 3 that sees six points of the unit ball, the position of one of
/// them, and the rays from other cameras, 2 to 6 units from it, to the other five.
fn five_points_and_a_known_one(random: &mut Random) -> KnownInstance {
    let (rotation, translation) = camera(random);
    let (focal, origin) = (uniform(random, 0.5, 3.0), in_ball(random));
    let in_camera = rotation * origin + translation;
    let seen = image(&in_camera, focal);
    let (mut images, mut directions, mut centres) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..5 {
        let point = in_ball(random);
        let centre = origin + in_ball(random).normalize() * uniform(random, 2.0, 6.0);
        images.extend(image(&(rotation * point + translation), focal).data.0[0]);
        directions.extend((point - centre).normalize().data.0[0]);
        centres.extend(centre.data.0[0]);
    }
    // The turn of the image is one of the camera about its axis.
    let about_axis = Rotation3::from_axis_angle(&Vector3::z_axis(), -seen.y.atan2(seen.x));
    let [w, x, y, z] = quaternion(&(about_axis.into_inner() * rotation));
    // (w, x, y, z) = (cos, 0, 0, sin) (p, q, r, 0), angles halved.
    let (p, [cos, sin]) = (w.hypot(z), [w, z].map(|part| part / w.hypot(z)));
    let [q, r] = [cos * x + sin * y, cos * y - sin * x];
    let scaled_focal = focal / seen.norm();
    let truth = vec![q / p, r / p, scaled_focal * (cos * cos - sin * sin), scaled_focal * 2.0 * cos * sin, in_camera.z];
    let known = [&origin.data.0[0][..], &seen.data.0[0]].concat();
    KnownInstance { data: [known, images, centres, directions].concat(), truths: vec![truth] }
}

/// The fundamental matrix, of norm 1, of two cameras with focal length 0.7 to 2 and principal point
/// in \[-0.2, 0.2\]^2; cosine and sine of half the angle between them.
fn calibration_by_angle(random: &mut Random, motion: Motion) -> KnownInstance {
    let (rotation, translation, _) = two_cameras((random, motion), 0);
    let (focal, x, y) = (uniform(random, 0.7, 2.0), uniform(random, -0.2, 0.2), uniform(random, -0.2, 0.2));
    let inverse = Matrix3::new(1.0, 0.0, -x, 0.0, 1.0, -y, 0.0, 0.0, focal) / focal;
    let fundamental = (inverse.transpose() * translation.cross_matrix() * rotation * inverse).normalize();
    let [cosine, imaginary @ ..] = quaternion(&rotation);
    let by_rows = fundamental.transpose();
    let data = by_rows.iter().copied().chain([cosine, Vector3::from(imaginary).norm()]).collect();
    KnownInstance { data, truths: vec![vec![x, y, focal * focal]] }
}

fn four_points(random: &mut Random, motion: Motion) -> KnownInstance {
    let (rotation, translation, points) = two_cameras((random, motion), 4);
    let second: Vec<Vector3<f64>> = points.iter().map(|x| rotation * x + translation).collect();
    known_angle(&rotation, &points, &second)
}

/// The translation of two cameras without its part along the axis of the rotation, where the points
/// stay in front of the second.
fn three_points(random: &mut Random, motion: Motion) -> KnownInstance {
    loop {
        let (rotation, translation, points) = two_cameras((random, motion), 3);
        let [_, x, y, z] = quaternion(&rotation);
        // Zero without a rotation, which moves along no axis.
        let axis = Vector3::new(x, y, z).try_normalize(f64::EPSILON).unwrap_or_default();
        let translation = translation - axis * axis.dot(&translation);
        let second: Vec<Vector3<f64>> = points.iter().map(|x| rotation * x + translation).collect();
        if second.iter().all(|x| x.z > 0.1) {
            return known_angle(&rotation, &points, &second);
        }
    }
}

/// Three directions within 35 degrees of the optical axes of both cameras, focal length 1 to 2,
/// barrel distortion. The second camera is turned mostly sideways: a turn about the optical axis
/// changes no angle, and leaves equations 0 = 0.
fn panorama(random: &mut Random, view: View) -> KnownInstance {
    let (focal, mut radial) = (uniform(random, 1.0, 2.0), -uniform(random, 0.05, 0.5));
    let mut axis = in_ball(random).component_mul(&Vector3::new(1.0, 1.0, 0.2)).normalize();
    // A camera on a tripod pans or tilts.
    match view {
        View::Aligned => axis = Vector3::y(),
        View::HalfTurnX => axis = Vector3::x(),
        View::Ideal => radial = 0.0,
        _ => {}
    }
    // A point in the middle of the first image must be in the second one.
    let most = if view == View::Centred { 0.6 } else { 0.7 };
    let rotation = Rotation3::new(uniform(random, 0.3, most) * axis);
    let mut seen: Vec<[Vector2<f64>; 2]> = Vec::new();
    while seen.len() < 3 {
        let mut direction = (in_ball(random) + Vector3::new(0.0, 0.0, 1.0)).normalize();
        if view == View::Centred && seen.is_empty() {
            direction = Vector3::z();
        }
        let turned = rotation * direction;
        if direction.z.min(turned.z) > 35f64.to_radians().cos() {
            seen.push([direction, turned].map(|x| distorted(image(&x, focal), radial)));
        }
    }
    let data = (0..2).flat_map(|side| seen.iter().flat_map(move |images| images[side].data.0[0])).collect();
    KnownInstance { data, truths: vec![vec![radial, 1.0 / (focal * focal)]] }
}
