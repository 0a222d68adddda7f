//! Solvers that return rotations and translations: these are those of scenes.

use std::array::from_fn;
use std::f64::consts::{PI, TAU};

use eliminant_generator::algebra::Random;
use eliminant_solvers::{
    calibration_6_receivers_4_senders, homography_4pt, orbit_5_lines_of_sight, platform_forward_kinematics,
    pose_1pt_2line, pose_2pt_1line, pose_3line, pose_4pt_focal, pose_4pt_upright_error_bound, pose_5pt_refraction,
    pose_35pt_focal, pose_npt_direct_least_squares, pose_npt_least_squares_cayley, pose_npt_least_squares_quaternion,
    pose_npt_weak_perspective, relpose_3pt_depths, relpose_5pt_semi_generalized_focal, relpose_6pt_radial,
    relpose_7pt_focal_radial,
};
use eliminant_tests::ground_truth::{
    FOUND, Motion, Underwater, WATER, camera, distorted, image, in_ball, is_pose, is_rotation, projective_error,
    two_cameras, uniform,
};
use nalgebra::{Matrix3, Rotation3, Vector2, Vector3};

const SCENES: u64 = 1_000;
/// The same for a solver that takes a tenth of a second.
const SLOW_SCENES: u64 = 50;
/// Scenes of a thousand on which it may be missing: those that are close to degenerate ones.
const LOST: usize = 1;

/// Checks that a result is near the truth on nearly all scenes.
fn check(is_found: impl Fn(&mut Random) -> bool) {
    check_but_for(LOST, is_found);
}

/// As [`check`], where so many scenes of a thousand are close to degenerate ones.
fn check_but_for(most: usize, is_found: impl Fn(&mut Random) -> bool) {
    check_some(SCENES, most, is_found);
}

/// As [`check`], on fewer scenes.
fn check_some(scenes: u64, most: usize, is_found: impl Fn(&mut Random) -> bool) {
    let lost: Vec<u64> = (0..scenes).filter(|&k| !is_found(&mut Random::new(65_000_000 + k))).collect();
    assert!(lost.len() <= most, "{lost:?}");
}

/// A camera, and points of the unit ball in the world and in the camera.
struct View<const N: usize> {
    rotation: Matrix3<f64>,
    translation: Vector3<f64>,
    points: [Vector3<f64>; N],
    seen: [Vector3<f64>; N],
}

impl<const N: usize> View<N> {
    fn draw(random: &mut Random) -> Self {
        let (rotation, translation) = camera(random);
        let points: [Vector3<f64>; N] = from_fn(|_| in_ball(random));
        Self { rotation, translation, points, seen: points.map(|x| rotation * x + translation) }
    }

    fn is_pose(&self, rotation: &[[f64; 3]; 3], translation: &[f64; 3]) -> bool {
        is_pose((&self.rotation, &self.translation), rotation, translation)
    }

    /// The line through the points from this one on, and the normal of the plane in which it is
    /// seen.
    fn line(&self, first: usize) -> ([[f64; 3]; 2], [f64; 3]) {
        let normal = self.seen[first].cross(&self.seen[first + 1]);
        ([self.points[first], self.points[first + 1]].map(<[f64; 3]>::from), normal.into())
    }
}

fn rays<const N: usize>(points: &[Vector3<f64>; N]) -> [[f64; 3]; N] {
    points.map(<[f64; 3]>::from)
}

#[test]
fn poses_and_focal_lengths_come_from_three_and_a_half_points() {
    check(|random| {
        let (view, focal) = (View::<4>::draw(random), uniform(random, 0.5, 3.0));
        let images = view.seen.map(|x| image(&x, focal));
        let (horizontal, vertical) = (images.map(|q| q.x), from_fn(|k| images[k].y));
        let found = pose_35pt_focal::solve_for_pose(&rays(&view.points), &horizontal, &vertical).unwrap_or_default();
        assert!(found.iter().all(|pose| pose.focal > 0.0 && is_rotation(&pose.rotation)));
        found
            .iter()
            .any(|pose| view.is_pose(&pose.rotation, &pose.translation) && (pose.focal / focal - 1.0).abs() < FOUND)
    });
}

#[test]
fn poses_and_focal_lengths_come_from_four_points() {
    check(|random| {
        let (view, focal) = (View::<4>::draw(random), uniform(random, 0.5, 3.0));
        let images = view.seen.map(|x| <[f64; 2]>::from(image(&x, focal)));
        let found = pose_4pt_focal::solve_for_focal_pose(&rays(&view.points), &images).unwrap_or_default();
        // All points are in front, of whatever solution.
        for pose in &found {
            let depth = |x: &Vector3<f64>| Vector3::from(pose.rotation[2]).dot(x) + pose.translation[2];
            assert!(view.points.iter().all(|x| depth(x) > 0.0) && is_rotation(&pose.rotation));
        }
        let is_focal = |found: f64| (found / focal - 1.0).abs() < FOUND;
        found.iter().any(|pose| view.is_pose(&pose.rotation, &pose.translation) && pose.focal.into_iter().all(is_focal))
    });
}

/// A square pattern in front of a camera, at which all equations of it have special values.
#[test]
fn poses_and_focal_lengths_come_from_a_square() {
    check(|random| {
        let mut view = View::<4>::draw(random);
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        view.points = corners.map(|[x, y]| Vector3::new(0.5 * x, 0.5 * y, 0.0));
        view.seen = view.points.map(|x| view.rotation * x + view.translation);
        let focal = uniform(random, 0.5, 3.0);
        let images = view.seen.map(|x| <[f64; 2]>::from(image(&x, focal)));
        let found = pose_4pt_focal::solve_for_focal_pose(&rays(&view.points), &images).unwrap_or_default();
        found.iter().any(|pose| view.is_pose(&pose.rotation, &pose.translation))
    });
}

/// A camera that is turned about its first axis, which is vertical, and sees N points with errors
/// of the length of a bound.
fn view_with_errors<const N: usize>(random: &mut Random) -> (View<N>, [[f64; 2]; N], f64) {
    let (angle, bound) = (uniform(random, 0.0, TAU), uniform(random, 0.005, 0.02));
    let rotation = Rotation3::from_axis_angle(&Vector3::x_axis(), angle).into_inner();
    let [right, down] = [(); 2].map(|()| 0.5 * random.symmetric_unit());
    let translation = Vector3::new(right, down, uniform(random, 2.0, 6.0));
    let points: [Vector3<f64>; N] = from_fn(|_| in_ball(random));
    let seen = points.map(|x| rotation * x + translation);
    let images = seen.map(|x| {
        let (sine, cosine) = uniform(random, 0.0, TAU).sin_cos();
        (image(&x, 1.0) + bound * Vector2::new(cosine, sine)).into()
    });
    (View { rotation, translation, points, seen }, images, bound)
}

/// That all errors equal the bound is tested for each pose that is found.
#[test]
fn poses_come_from_four_points_with_errors_at_their_bound() {
    check(|random| {
        let (view, images, bound) = view_with_errors::<4>(random);
        let points = rays(&view.points);
        let found = pose_4pt_upright_error_bound::solve_for_pose(&points, &images, bound).unwrap_or_default();
        for pose in &found {
            assert!(is_rotation(&pose.rotation) && pose.rotation[0] == [1.0, 0.0, 0.0]);
            for (point, seen) in view.points.iter().zip(images) {
                let x = Matrix3::from(pose.rotation).transpose() * point + Vector3::from(pose.translation);
                let error = (image(&x, 1.0) - Vector2::from(seen)).norm();
                assert!((error / bound - 1.0).abs() < FOUND, "{error} is not {bound}");
            }
        }
        found.iter().any(|pose| view.is_pose(&pose.rotation, &pose.translation))
    });
}

#[test]
fn poses_and_focal_lengths_come_from_rays_and_a_known_point() {
    check_some(SLOW_SCENES, 0, |random| {
        let (view, focal) = (View::<6>::draw(random), uniform(random, 0.5, 3.0));
        let images = view.seen.map(|x| <[f64; 2]>::from(image(&x, focal)));
        let centres: [Vector3<f64>; 5] = from_fn(|_| view.points[5] + 4.0 * in_ball(random).normalize());
        let directions: [[f64; 3]; 5] = from_fn(|k| (view.points[k] - centres[k]).into());
        let found = relpose_5pt_semi_generalized_focal::solve_for_focal_pose(
            &view.points[5].into(),
            &images[5],
            &from_fn(|k| images[k]),
            &centres.map(Into::into),
            &directions,
        );
        let found = found.unwrap_or_default();
        assert!(found.iter().all(|pose| pose.focal > 0.0 && is_rotation(&pose.rotation)));
        let is_focal = |found: f64| (found / focal - 1.0).abs() < FOUND;
        found.iter().any(|pose| view.is_pose(&pose.rotation, &pose.translation) && is_focal(pose.focal))
    });
}

#[test]
fn poses_come_from_three_lines() {
    check(|random| {
        let view = View::<6>::draw(random);
        let seen = [0, 2, 4].map(|first| view.line(first));
        let (lines, normals) = (seen.map(|(line, _)| line), seen.map(|(_, normal)| normal));
        let found = pose_3line::solve_for_pose(&normals, &lines).unwrap_or_default();
        assert!(found.iter().all(|pose| is_rotation(&pose.rotation)));
        found.iter().any(|pose| view.is_pose(&pose.rotation, &pose.translation))
    });
}

#[test]
fn poses_come_from_a_point_and_two_lines() {
    check(|random| {
        let view = View::<5>::draw(random);
        let seen = [1, 3].map(|first| view.line(first));
        let (lines, normals) = (seen.map(|(line, _)| line), seen.map(|(_, normal)| normal));
        let ray = view.seen[0] * uniform(random, 0.5, 2.0);
        let found = pose_1pt_2line::solve_for_pose(&ray.into(), &view.points[0].into(), &normals, &lines);
        let found = found.unwrap_or_default();
        assert!(found.iter().all(|pose| is_rotation(&pose.rotation)));
        found.iter().any(|pose| view.is_pose(&pose.rotation, &pose.translation))
    });
}

#[test]
fn poses_come_from_two_points_and_a_line() {
    check(|random| {
        let view = View::<4>::draw(random);
        let (line, normal) = view.line(2);
        let (points, seen): ([_; 2], [_; 2]) = (from_fn(|k| view.points[k]), from_fn(|k| view.seen[k]));
        let seen = seen.map(|x| x * uniform(random, 0.5, 2.0));
        let found = pose_2pt_1line::solve_for_pose(&rays(&seen), &rays(&points), &normal, &line).unwrap_or_default();
        assert!(found.iter().all(|pose| is_rotation(&pose.rotation)));
        found.iter().any(|pose| view.is_pose(&pose.rotation, &pose.translation))
    });
}

/// A point that is not among the four is taken to its image.
#[test]
fn homographies_come_from_four_points() {
    check(|random| {
        let (rotation, translation, corners) = two_cameras((random, Motion::General), 3);
        let mut images = || {
            let shares: [f64; 3] = from_fn(|_| uniform(random, 0.0, 1.0));
            let point = corners.iter().zip(shares).map(|(x, share)| x * share).sum::<Vector3<f64>>();
            let point = point / shares.iter().sum::<f64>();
            [image(&point, 1000.0), image(&(rotation * point + translation), 1000.0)]
        };
        let seen: [_; 5] = from_fn(|_| images());
        let [first, second]: [[[f64; 2]; 4]; 2] = from_fn(|side| from_fn(|k| seen[k][side].into()));
        let found = homography_4pt::solve_for_homography(&first, &second).unwrap_or_default();
        found.iter().any(|found| {
            let taken = Matrix3::from(found.homography).transpose() * seen[4][0].push(1.0);
            projective_error(taken.as_slice(), seen[4][1].push(1.0).as_slice()) < FOUND
        })
    });
}

/// The true orbit, which each line of sight meets at the true distance, and its shape.
#[test]
fn orbits_come_from_lines_of_sight() {
    check(|random| {
        let normal = in_ball(random).normalize();
        let (h, eccentricity) = (uniform(random, 0.5, 2.0), uniform(random, 0.0, 0.6));
        let pericentre = normal.cross(&in_ball(random)).normalize();
        let across = normal.cross(&pericentre);
        let sights = from_fn(|_| {
            let anomaly = uniform(random, -PI, PI);
            let direction = pericentre * anomaly.cos() + across * anomaly.sin();
            let body = direction * (h / (1.0 + eccentricity * anomaly.cos()));
            let observer = in_ball(random);
            [observer.into(), (body - observer).into()]
        });
        let found = orbit_5_lines_of_sight::solve_for_orbit(&sights).unwrap_or_default();
        found.iter().any(|orbit| {
            let of_sun = Vector3::from(orbit.eccentricity) - eccentricity * pericentre;
            let plane = Vector3::from(orbit.normal);
            of_sun.norm() < FOUND && plane.cross(&normal).norm() < FOUND && (orbit.semi_latus_rectum - h).abs() < FOUND
        })
    });
}

#[test]
fn relative_poses_come_from_depths() {
    check(|random| {
        let (rotation, translation, points) = two_cameras((random, Motion::General), 3);
        let (first, scale): ([_; 3], _) = (from_fn(|k| points[k]), uniform(random, 0.5, 2.0));
        let second = first.map(|x| rotation * x + translation);
        let shifts: [f64; 2] = from_fn(|_| uniform(random, -0.5, 0.5));
        let [images, in_second] = [first, second].map(|x| x.map(|x| <[f64; 2]>::from(image(&x, 1.0))));
        let depths = [first.map(|x| x.z - shifts[0]), second.map(|x| x.z / scale - shifts[1])];
        let found = relpose_3pt_depths::solve_for_depth_pose(&images, &depths[0], &in_second, &depths[1]);
        found.unwrap_or_default().iter().any(|pose| {
            is_pose((&rotation, &translation), &pose.rotation, &pose.translation)
                && (pose.scale / scale - 1.0).abs() < FOUND
                && (0..2).all(|k| (pose.shifts[k] - shifts[k]).abs() < FOUND)
        })
    });
}

#[test]
fn poses_above_water_come_from_five_points() {
    check(|random| {
        let scene = Underwater::draw(random, eliminant_tests::ground_truth::View::General);
        let known = (&scene.rotation, &scene.centre);
        let found = pose_5pt_refraction::solve_for_refracted_pose(&rays(&scene.rays), &rays(&scene.points), WATER)
            .unwrap_or_default();
        // Turned by a half about the normal, a camera would see the points behind it.
        assert!(found.iter().all(|pose| is_rotation(&pose.rotation)) && found.len() <= 8);
        found.iter().any(|pose| is_pose(known, &pose.rotation, &pose.centre))
    });
}

/// The best of all stationary points is the true pose, whatever the number of points is.
#[test]
fn poses_come_from_any_number_of_points() {
    check(|random| {
        let view = View::<50>::draw(random);
        let count = 6 + random.below(45) as usize;
        let (points, seen) = (&rays(&view.points)[..count], &rays(&view.seen)[..count]);
        let images = seen.iter().map(|[x, y, z]| [x / z, y / z]).collect::<Vec<_>>();
        let of_turned = pose_npt_direct_least_squares::mean_of_point(seen.iter().zip(points));
        let of_rays = pose_npt_least_squares_cayley::mean_of_point(seen.iter().zip(points));
        let of_images = pose_npt_least_squares_quaternion::mean_of_point(images.iter().zip(points));

        let by_cayley = pose_npt_direct_least_squares::solve_for_pose(&of_turned).unwrap_or_default();
        let by_direction = pose_npt_least_squares_cayley::solve_for_pose(&of_rays).unwrap_or_default();
        let by_depth = pose_npt_least_squares_quaternion::solve_for_pose(&of_images).unwrap_or_default();
        by_cayley.iter().any(|pose| view.is_pose(&pose.rotation, &pose.translation))
            && by_direction.iter().any(|pose| view.is_pose(&pose.rotation, &pose.translation))
            && by_depth.iter().any(|pose| view.is_pose(&pose.rotation, &pose.translation))
    });
}

/// With a scale of 1 over the depth of all points.
#[test]
fn scaled_poses_come_from_any_number_of_points() {
    check(|random| {
        let view = View::<50>::draw(random);
        let points = &rays(&view.points)[..6 + random.below(45) as usize];
        let scale = 1.0 / view.translation.norm();
        let images = view.seen.iter().map(|seen| [scale * seen.x, scale * seen.y]);
        let means = pose_npt_weak_perspective::mean_of_point(images.zip(points.iter().copied()));
        let found = pose_npt_weak_perspective::solve_for_weak_pose(&means).unwrap_or_default();
        let translation = scale * view.translation;
        found.iter().any(|pose| {
            let [x, y] = pose.translation;
            is_pose((&view.rotation, &translation), &pose.rotation, &[x, y, translation.z])
                && (pose.scale - scale).abs() < FOUND * scale
        })
    });
}

/// Images of six points, or seven, by cameras of this focal length with barrel distortion: those of
/// the first and the second camera, the distortion, and the fundamental matrix, of length 1.
fn distorted_images<const N: usize>(random: &mut Random, focal: f64) -> ([[[f64; 2]; N]; 2], f64, Matrix3<f64>) {
    let (rotation, translation, points) = two_cameras((random, Motion::General), N);
    let radial = -uniform(random, 0.05, 0.5);
    let points: [Vector3<f64>; N] = points.try_into().expect("so many points");
    let first = points.map(|x| distorted(image(&x, focal), radial).into());
    let second = points.map(|x| distorted(image(&(rotation * x + translation), focal), radial).into());
    let inverse = Matrix3::from_diagonal(&Vector3::new(1.0 / focal, 1.0 / focal, 1.0));
    ([first, second], radial, (inverse * translation.cross_matrix() * rotation * inverse).normalize())
}

fn is_same_up_to_scale(rows: &[[f64; 3]; 3], known: &Matrix3<f64>) -> bool {
    projective_error(rows.as_flattened(), known.transpose().as_slice()) < FOUND
}

#[test]
fn essential_matrices_and_distortion_come_from_six_points() {
    check(|random| {
        let ([first, second], radial, essential) = distorted_images::<6>(random, 1.0);
        let found = relpose_6pt_radial::solve_for_radial_pose(&first, &second).unwrap_or_default();
        let is_known = |radial_of: f64| (radial_of - radial).abs() < FOUND * radial.abs();
        found.iter().any(|pose| is_known(pose.radial) && is_same_up_to_scale(&pose.essential, &essential))
    });
}

#[test]
fn focal_lengths_and_distortion_come_from_seven_points() {
    check(|random| {
        let focal = uniform(random, 2.0, 4.0);
        let ([first, second], radial, fundamental) = distorted_images::<7>(random, focal);
        let found = relpose_7pt_focal_radial::solve_for_radial_focal_pose(&first, &second).unwrap_or_default();
        found.iter().any(|pose| {
            (pose.radial - radial).abs() < FOUND * radial.abs()
                && (pose.focal - focal).abs() < FOUND * focal
                && is_same_up_to_scale(&pose.fundamental, &fundamental)
        })
    });
}

/// Positions are known up to a motion, and a mirror: those with the known distances. On 1 of 100
/// scenes the linear equations of the receivers are close to dependent.
#[test]
fn positions_come_from_ranges() {
    check_but_for(10, |random| {
        let (senders, receivers): ([_; 4], [_; 6]) = (from_fn(|_| in_ball(random)), from_fn(|_| in_ball(random)));
        let ranges = receivers.map(|receiver| senders.map(|sender: Vector3<f64>| (receiver - sender).norm()));
        let found = calibration_6_receivers_4_senders::solve_for_positions(&ranges).unwrap_or_default();
        let known = [&senders[..], &receivers[..]].concat();
        found.iter().any(|positions| {
            let own: Vec<Vector3<f64>> =
                positions.senders.iter().chain(&positions.receivers).map(|&p| Vector3::from(p)).collect();
            let pairs = (0..10).flat_map(|i| (0..i).map(move |j| (i, j)));
            let errors = pairs.map(|(i, j)| ((own[i] - own[j]).norm() - (known[i] - known[j]).norm()).abs());
            errors.fold(0.0, f64::max) < FOUND
        })
    });
}

/// A platform above a base, both in a unit ball, with heights of their joints times these factors.
struct Legs {
    base: [Vector3<f64>; 6],
    platform: [Vector3<f64>; 6],
    rotation: Matrix3<f64>,
    translation: Vector3<f64>,
}

impl Legs {
    fn draw(random: &mut Random, [of_base, of_platform]: [f64; 2]) -> Self {
        let mut joints = |height: f64| from_fn(|_| in_ball(random).component_mul(&Vector3::new(1.0, 1.0, height)));
        let (base, platform) = (joints(of_base), joints(of_platform));
        let (rotation, translation) = camera(random);
        Self { base, platform, rotation, translation }
    }

    fn solve(&self) -> Result<Vec<platform_forward_kinematics::Pose>, String> {
        let leg = |k: usize| (self.rotation * self.platform[k] + self.translation - self.base[k]).norm();
        platform_forward_kinematics::solve_for_pose(&rays(&self.base), &rays(&self.platform), &from_fn(leg))
            .map(|found| found.to_vec())
            .map_err(|error| error.to_string())
    }
}

/// Either may be flat, as usual ones are; if both are, the lengths are no equations of the kind
/// that the solver derives.
#[test]
fn platforms_come_from_the_lengths_of_legs() {
    for heights in [[1.0, 1.0], [0.0, 1.0], [1.0, 0.0]] {
        check_some(200, LOST, |random| {
            let legs = Legs::draw(random, heights);
            let found = legs.solve().unwrap_or_default();
            assert!(found.iter().all(|pose| is_rotation(&pose.rotation)));
            found.iter().any(|pose| is_pose((&legs.rotation, &legs.translation), &pose.rotation, &pose.translation))
        });
    }
    assert!((0..20).all(|k| Legs::draw(&mut Random::new(k), [0.0, 0.0]).solve().is_err()));
}
