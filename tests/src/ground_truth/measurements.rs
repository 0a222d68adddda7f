//! Problems that take measurements: rays and points.

use std::array::from_fn;

use eliminant_generator::algebra::Random;
use nalgebra::{Matrix3, Vector2, Vector3};

use super::cameras::{Motion, image, two_cameras, upright_cameras};
use super::relative_pose::epipolar_row;
use super::{
    KnownInstance, Make, Maker, View, combination, coordinates, derived_null_space, projective_error, relative_error,
    uniform, vector, weights,
};
use crate::statistics::worst;

pub(super) fn makers() -> Vec<Maker> {
    [weights_of_matrices(), others()].into_iter().flatten().collect()
}

/// The unknowns are weights of matrices that span a null space.
fn weights_of_matrices() -> Vec<Maker> {
    vec![
        Maker {
            name: "relpose_5pt_rays",
            make: Make::TwoCameras(five_rays),
            error: |data, s, truth| {
                let rows: Vec<Vec<f64>> = rays(data, 5).map(|[x1, x2]| epipolar_row(&x1, &x2)).collect();
                epipolar_error(&derived_null_space(&rows), s, truth)
            },
        },
        Maker {
            name: "fundamental_7pt",
            make: Make::TwoCameras(seven_points),
            error: |data, s, truth| epipolar_error(&null_space_of_points(data, 7), s, truth),
        },
        Maker {
            name: "fundamental_8pt",
            make: Make::TwoCameras(eight_points),
            error: |data, s, truth| epipolar_error(&null_space_of_points(data, 8), s, truth),
        },
        Maker {
            name: "relpose_6pt_focal_points",
            make: Make::TwoCameras(six_measured_points),
            error: |data, s, truth| {
                let basis = null_space_of_points(data, 6);
                epipolar_error(&basis, &s[..2], &truth[..2]).max(relative_error(&s[2..], &truth[2..]))
            },
        },
        Maker {
            name: "relpose_6pt_focal_one_side",
            make: Make::TwoCameras(six_points_and_rays),
            error: |data, s, truth| {
                let basis = null_space_of_points_and_rays(data);
                epipolar_error(&basis, &s[..2], &truth[..2]).max(relative_error(&s[2..], &truth[2..]))
            },
        },
    ]
}

fn others() -> Vec<Maker> {
    vec![
        Maker {
            name: "pose_3pt",
            make: Make::KnownPoints(three_points),
            error: |_, solution, truth| relative_error(solution, truth),
        },
        Maker {
            name: "pose_4pt_focal",
            make: Make::KnownPoints(four_points),
            error: |_, solution, truth| projective_error(&vector(solution), &vector(truth)),
        },
        Maker {
            name: "homography_4pt",
            make: Make::TwoCameras(four_points_of_a_plane),
            error: |_, solution, truth| projective_error(&vector(solution), &vector(truth)),
        },
        Maker {
            name: "relpose_3pt_depths",
            make: Make::TwoCameras(three_estimated_depths),
            // Of the depths in the second camera.
            error: |data, solution, truth| {
                let errors = data[15..].iter().map(|depth| ((solution[0] - truth[0]) / (depth + truth[0])).abs());
                worst(errors)
            },
        },
        Maker {
            name: "pose_2pt_upright",
            make: Make::KnownPoints(two_points_upright),
            error: |_, solution, truth| relative_error(solution, truth),
        },
        Maker {
            name: "relpose_3pt_upright",
            make: Make::TwoCameras(three_rays_upright),
            error: |_, solution, truth| relative_error(solution, truth),
        },
    ]
}

/// The rays of points in two cameras, those in the first before those in the second.
fn rays(data: &[f64], count: usize) -> impl Iterator<Item = [Vector3<f64>; 2]> + '_ {
    (0..count).map(move |k| [0, count].map(|first| Vector3::from_column_slice(&data[3 * (first + k)..][..3])))
}

/// The unit in which the problems with points compute: the length of all of them.
fn unit_of(data: &[f64]) -> f64 {
    data.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// The null space of the equations of all points, of at most the first seven.
fn null_space_of_points(data: &[f64], count: usize) -> Vec<f64> {
    let unit = unit_of(data);
    let point = |k: usize| Vector3::new(data[2 * k], data[2 * k + 1], unit);
    let rows: Vec<Vec<f64>> = (0..count.min(7)).map(|k| epipolar_row(&point(k), &point(count + k))).collect();
    derived_null_space(&rows)
}

/// The error of the matrix that such weights stand for.
fn epipolar_error(basis: &[f64], solution: &[f64], truth: &[f64]) -> f64 {
    let [solved, known] = [solution, truth].map(|x| combination(basis, &vector(x)));
    projective_error(&solved, &known)
}

/// Points in the coordinates of two cameras, and the fundamental matrix for focal lengths.
fn measured((random, motion): (&mut Random, Motion), count: usize, focal: f64) -> ([Vec<Vector3<f64>>; 2], Vec<f64>) {
    let (rotation, translation, points) = two_cameras((random, motion), count);
    let seen = points.iter().map(|x| rotation * x + translation).collect();
    let inverse = Matrix3::from_diagonal(&Vector3::new(1.0 / focal, 1.0 / focal, 1.0));
    let fundamental = inverse * translation.cross_matrix() * rotation * inverse;
    ([points, seen], fundamental.transpose().as_slice().to_vec())
}

/// Rays of any length.
fn five_rays(random: &mut Random, motion: Motion) -> KnownInstance {
    let (points, essential) = measured((random, motion), 5, 1.0);
    let data: Vec<f64> = points.iter().flatten().flat_map(|x| x.data.0[0]).collect();
    let rows: Vec<Vec<f64>> = rays(&data, 5).map(|[x1, x2]| epipolar_row(&x1, &x2)).collect();
    let truth = coordinates(&weights(&derived_null_space(&rows), &essential));
    KnownInstance { data, truths: vec![truth] }
}

/// Images in cameras of this focal length, and the weights of the fundamental matrix.
fn image_points(seed: (&mut Random, Motion), count: usize, focal: f64) -> (Vec<f64>, Vec<f64>) {
    let (points, fundamental) = measured(seed, count, focal);
    let data: Vec<f64> = points.iter().flatten().flat_map(|x| image(x, focal).data.0[0]).collect();
    let unit = unit_of(&data);
    let to_unit = |at: usize| if at == 2 { unit } else { 1.0 };
    let in_units: Vec<f64> =
        fundamental.iter().enumerate().map(|(at, f)| f / (to_unit(at / 3) * to_unit(at % 3))).collect();
    let truth = coordinates(&weights(&null_space_of_points(&data, count), &in_units));
    (data, truth)
}

fn seven_points(random: &mut Random, motion: Motion) -> KnownInstance {
    let (data, truth) = image_points((random, motion), 7, 1.0);
    KnownInstance { data, truths: vec![truth] }
}

fn eight_points(random: &mut Random, motion: Motion) -> KnownInstance {
    let (data, truth) = image_points((random, motion), 8, 1.0);
    KnownInstance { data, truths: vec![truth] }
}

fn six_measured_points(random: &mut Random, motion: Motion) -> KnownInstance {
    let focal = uniform(random, 0.5, 3.0);
    let (data, mut truth) = image_points((random, motion), 6, focal);
    let unit = unit_of(&data);
    truth.push(unit * unit / (focal * focal));
    KnownInstance { data, truths: vec![truth] }
}

/// The null space of six images in the first camera and rays in the second.
fn null_space_of_points_and_rays(data: &[f64]) -> Vec<f64> {
    let (images, rays) = data.split_at(12);
    let unit = unit_of(images);
    let row = |(x, y): (&[f64], &[f64])| epipolar_row(&Vector3::new(x[0], x[1], unit), &Vector3::from_column_slice(y));
    derived_null_space(&images.chunks(2).zip(rays.chunks(3)).map(row).collect::<Vec<_>>())
}

/// Images in a camera of unknown focal length, and rays of any length in a calibrated one.
fn six_points_and_rays(random: &mut Random, motion: Motion) -> KnownInstance {
    let focal = uniform(random, 0.5, 3.0);
    let (rotation, translation, points) = two_cameras((random, motion), 6);
    let images: Vec<f64> = points.iter().flat_map(|x| image(x, focal).data.0[0]).collect();
    let unit = unit_of(&images);
    let rays = points.iter().flat_map(|x| (rotation * x + translation).data.0[0]);
    let data: Vec<f64> = images.iter().copied().chain(rays).collect();
    let inverse = Matrix3::from_diagonal(&Vector3::new(1.0 / focal, 1.0 / focal, 1.0 / unit));
    let fundamental = translation.cross_matrix() * rotation * inverse;
    let weights = weights(&null_space_of_points_and_rays(&data), fundamental.transpose().as_slice());
    let truth = [coordinates(&weights), vec![unit * unit / (focal * focal)]].concat();
    KnownInstance { data, truths: vec![truth] }
}

/// Rays of any length, and points in the unit ball.
fn three_points(random: &mut Random, view: View) -> KnownInstance {
    let pose = view.camera(random);
    let points: [Vector3<f64>; 3] = from_fn(|k| view.point(random, &pose, k));
    let (rotation, translation) = pose;
    let seen = points.map(|x| rotation * x + translation);
    let data = seen.iter().map(|x| x * uniform(random, 0.5, 2.0)).chain(points).flat_map(|x| x.data.0[0]).collect();
    KnownInstance { data, truths: vec![seen.map(|x| x.norm()).to_vec()] }
}

/// Points in the unit ball and their images for a focal length of 0.5 to 3; the weights of the null
/// vectors in the camera diag(f, f, 1) [R t].
fn four_points(random: &mut Random, view: View) -> KnownInstance {
    let pose = view.camera(random);
    let focal = uniform(random, 0.5, 3.0);
    let points: [Vector3<f64>; 4] = from_fn(|k| view.point(random, &pose, k));
    let (rotation, translation) = pose;
    let images = points.map(|x| image(&(rotation * x + translation), focal));
    let offsets = points.map(|x| x - points[0]);
    let unit = offsets.iter().map(Vector3::norm_squared).sum::<f64>().sqrt();
    let image_unit = images.iter().map(Vector2::norm_squared).sum::<f64>().sqrt();
    let mut rows = Vec::new();
    for (x, q) in offsets.iter().zip(&images) {
        let x = (x / unit).push(1.0);
        for i in 0..2 {
            let entry = |at: usize| match at / 4 {
                2 => -q[i] * x[at % 4] + 0.0,
                row if row == i => image_unit * x[at % 4] + 0.0,
                _ => 0.0,
            };
            rows.push((0..12).map(entry).collect::<Vec<f64>>());
        }
    }
    let first = (rotation * points[0] + translation) / unit;
    let scales = [focal / image_unit, focal / image_unit, 1.0];
    let row = |i: usize| [rotation[(i, 0)], rotation[(i, 1)], rotation[(i, 2)], first[i]].map(|x| scales[i] * x);
    let truth = coordinates(&weights(&derived_null_space(&rows), [row(0), row(1), row(2)].as_flattened()));
    let data = points.iter().flat_map(|x| x.data.0[0]).chain(images.iter().flat_map(|q| q.data.0[0])).collect();
    KnownInstance { data, truths: vec![truth] }
}

/// Images of four points of a triangle whose corners are among the points; the ratios of the depths
/// of three of them.
fn four_points_of_a_plane(random: &mut Random, motion: Motion) -> KnownInstance {
    let (rotation, translation, corners) = two_cameras((random, motion), 3);
    let mut inside = || {
        let shares: [f64; 3] = from_fn(|_| uniform(random, 0.0, 1.0));
        let whole: f64 = shares.iter().sum();
        corners.iter().zip(shares).map(|(corner, share)| corner * (share / whole)).sum::<Vector3<f64>>()
    };
    let first: [Vector3<f64>; 4] = from_fn(|_| inside());
    let second = first.map(|x| rotation * x + translation);
    let ratios: [f64; 3] = from_fn(|k| second[k].z / first[k].z);
    let data = first.iter().chain(&second).flat_map(|x| image(x, 1.0).data.0[0]).collect();
    KnownInstance { data, truths: vec![coordinates(&ratios)] }
}

/// Images of three points, and their depths but for shifts of up to half a unit, in units of the
/// second camera that are 0.5 to 2 times those of the first.
fn three_estimated_depths(random: &mut Random, motion: Motion) -> KnownInstance {
    let (rotation, translation, points) = two_cameras((random, motion), 3);
    let scale = uniform(random, 0.5, 2.0);
    let [u, v] = from_fn(|_| uniform(random, -0.5, 0.5));
    let seen: Vec<Vector3<f64>> = points.iter().map(|x| rotation * x + translation).collect();
    let images = [&points, &seen].map(|points| points.iter().flat_map(|x| image(x, 1.0).data.0[0]).collect::<Vec<_>>());
    let depths: [Vec<f64>; 2] = [(&points, 1.0, u), (&seen, scale, v)]
        .map(|(points, scale, shift)| points.iter().map(|x| x.z / scale - shift).collect());
    let data = images.iter().zip(&depths).flat_map(|(images, depths)| images.iter().chain(depths).copied()).collect();
    KnownInstance { data, truths: vec![vec![v]] }
}

/// Rays of any length of an upright camera, and points in the unit ball.
fn two_points_upright(random: &mut Random, view: View) -> KnownInstance {
    let (sin, cos) = view.turn(random);
    let rotation = Matrix3::new(cos, 0.0, sin, 0.0, 1.0, 0.0, -sin, 0.0, cos);
    let pose = (rotation, view.camera(random).1);
    let points: [Vector3<f64>; 2] = from_fn(|k| view.point(random, &pose, k));
    let translation = pose.1;
    let depths: [f64; 2] = from_fn(|_| uniform(random, 0.5, 2.0));
    let rays = (0..2).map(|k| (rotation * points[k] + translation) / depths[k]);
    let data = rays.chain(points).flat_map(|x| x.data.0[0]).collect();
    KnownInstance { data, truths: vec![depths.to_vec()] }
}

/// Rays of any length.
fn three_rays_upright(random: &mut Random, motion: Motion) -> KnownInstance {
    let (rotation, translation, points) = upright_cameras((random, motion), 3);
    let seen = points.iter().map(|x| rotation * x + translation);
    let data = points.iter().copied().chain(seen).flat_map(|x| (x * uniform(random, 0.5, 2.0)).data.0[0]).collect();
    KnownInstance { data, truths: vec![vec![rotation.m11, rotation.m13]] }
}
