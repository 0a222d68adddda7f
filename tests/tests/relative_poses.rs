//! Solvers of two cameras, or of two systems of them, that return the motion: it is that of scenes.

use std::array::from_fn;

use eliminant_generator::algebra::Random;
use eliminant_solvers::{
    relpose_3pt_angle_zero_screw, relpose_3pt_upright, relpose_4pt_angle, relpose_5pt_generalized_angle,
    relpose_5pt_rays, relpose_6pt_focal_points, relpose_6pt_generalized, relpose_7pt_generalized_scale,
};
use eliminant_tests::ground_truth::{
    FOUND, Motion, in_ball, is_pose, is_rotation, two_cameras, uniform, upright_cameras,
};
use nalgebra::{Matrix3, Rotation3, Vector3};

const SCENES: u64 = 500;
/// The same for solvers that take a millisecond or more.
const SLOW_SCENES: u64 = 50;

/// As of all solvers, three of a thousand motions may be lost.
fn check(what: &str, scenes: u64, is_found: impl Fn(&mut Random) -> bool) {
    let lost: Vec<u64> = (0..scenes).filter(|&k| !is_found(&mut Random::new(66_000_000 + k))).collect();
    assert!(lost.len() as u64 <= scenes * 3 / 1000, "{what}: {lost:?}");
}

/// Rays of points in either camera, of any length.
struct Rays<const N: usize> {
    rotation: Matrix3<f64>,
    /// Of length 1.
    translation: Vector3<f64>,
    first: [[f64; 3]; N],
    second: [[f64; 3]; N],
}

impl<const N: usize> Rays<N> {
    fn of(
        random: &mut Random,
        (rotation, translation, points): (Matrix3<f64>, Vector3<f64>, Vec<Vector3<f64>>),
    ) -> Self {
        let points: [Vector3<f64>; N] = from_fn(|k| points[k]);
        let mut scaled = |x: Vector3<f64>| (x * uniform(random, 0.5, 2.0)).into();
        let first = points.map(&mut scaled);
        let second = points.map(|x| scaled(rotation * x + translation));
        Self { rotation, translation: translation.normalize(), first, second }
    }

    fn is_pose(&self, rotation: &[[f64; 3]; 3], translation: &[f64; 3]) -> bool {
        is_pose((&self.rotation, &self.translation), rotation, translation)
    }

    /// Cosine and sine of half the angle of the rotation.
    fn half_angle(&self) -> [f64; 2] {
        let half = 0.5 * Rotation3::from_matrix_unchecked(self.rotation).angle();
        [half.cos(), half.sin()]
    }
}

/// Also of special motions, along which entries of the essential matrix vanish.
#[test]
fn motions_come_from_five_points() {
    for motion in Motion::ALL {
        check(&format!("{motion:?}"), SCENES, |random| {
            let cameras = two_cameras((random, motion), 5);
            let scene = Rays::<5>::of(random, cameras);
            let found = relpose_5pt_rays::solve_for_relative_pose(&scene.first, &scene.second).unwrap_or_default();
            for pose in &found {
                assert!(is_rotation(&pose.rotation), "{pose:?}");
                assert!((Vector3::from(pose.translation).norm() - 1.0).abs() < FOUND, "{pose:?}");
            }
            found.iter().any(|pose| scene.is_pose(&pose.rotation, &pose.translation))
        });
    }
}

#[test]
fn upright_motions_come_from_three_points() {
    check("upright", SCENES, |random| {
        let cameras = upright_cameras((random, Motion::General), 3);
        let scene = Rays::<3>::of(random, cameras);
        let found = relpose_3pt_upright::solve_for_relative_pose(&scene.first, &scene.second).unwrap_or_default();
        found.iter().any(|pose| scene.is_pose(&pose.rotation, &pose.translation))
    });
}

#[test]
fn motions_come_from_a_known_angle() {
    check("four points", SCENES, |random| {
        let cameras = two_cameras((random, Motion::General), 4);
        let scene = Rays::<4>::of(random, cameras);
        let found = relpose_4pt_angle::solve_for_relative_pose(&scene.first, &scene.second, &scene.half_angle());
        let found = found.unwrap_or_default();
        assert!(found.iter().all(|pose| is_rotation(&pose.rotation)));
        found.iter().any(|pose| scene.is_pose(&pose.rotation, &pose.translation))
    });
    check("three points, no screw", SCENES, |random| {
        let (rotation, translation, points) = two_cameras((random, Motion::General), 3);
        // Without the part of the translation along the axis.
        let Some(axis) = Rotation3::from_matrix_unchecked(rotation).axis() else { return true };
        let cameras = (rotation, translation - axis.into_inner() * axis.dot(&translation), points);
        let scene = Rays::<3>::of(random, cameras);
        let half_angle = scene.half_angle();
        let found = relpose_3pt_angle_zero_screw::solve_for_relative_pose(&scene.first, &scene.second, &half_angle);
        found.unwrap_or_default().iter().any(|pose| scene.is_pose(&pose.rotation, &pose.translation))
    });
}

/// Rays of a system of cameras: a point of each and its direction.
type System<const N: usize> = [[[f64; 3]; 2]; N];

/// Rays through points in either system. Points of the second one are in a unit `scale` times as
/// long.
fn systems<const N: usize>(random: &mut Random, scale: f64) -> (Rays<0>, [System<N>; 2], Vector3<f64>) {
    let (rotation, translation, points) = two_cameras((random, Motion::General), N);
    let mut ray = |x: Vector3<f64>| {
        let centre = in_ball(random);
        [centre.into(), ((x - centre) * uniform(random, 0.5, 2.0)).into()]
    };
    let first = from_fn(|k| ray(points[k]));
    let second = from_fn(|k| ray((rotation * points[k] + translation) / scale));
    let scene = Rays { rotation, translation: translation.normalize(), first: [], second: [] };
    (scene, [first, second], translation)
}

#[test]
fn motions_of_systems_of_cameras_have_a_length() {
    check("known angle", SLOW_SCENES, |random| {
        let (scene, [first, second], translation) = systems::<5>(random, 1.0);
        let found = relpose_5pt_generalized_angle::solve_for_pose(&first, &second, &scene.half_angle());
        let known = (&scene.rotation, &translation);
        found.unwrap_or_default().iter().any(|pose| is_pose(known, &pose.rotation, &pose.translation))
    });
    check("six points", SLOW_SCENES, |random| {
        let (scene, [first, second], translation) = systems::<6>(random, 1.0);
        let found = relpose_6pt_generalized::solve_for_pose(&first, &second).unwrap_or_default();
        assert!(found.iter().all(|pose| is_rotation(&pose.rotation)));
        found.iter().any(|pose| is_pose((&scene.rotation, &translation), &pose.rotation, &pose.translation))
    });
    check("unknown scale", SLOW_SCENES, |random| {
        let scale = uniform(random, 0.5, 2.0);
        let (scene, [first, second], translation) = systems::<7>(random, scale);
        let found = relpose_7pt_generalized_scale::solve_for_scaled_pose(&first, &second).unwrap_or_default();
        let known = (&scene.rotation, &translation);
        let is_scale = |found: f64| (found / scale - 1.0).abs() < FOUND;
        found.iter().any(|pose| is_pose(known, &pose.rotation, &pose.translation) && is_scale(pose.scale))
    });
}

/// Images relative to the principal point, in pixels. Where the optical axes meet or are parallel
/// the focal length is hardly known, so special motions are left out.
#[test]
fn motions_and_focal_lengths_come_from_six_points() {
    check("six points", SCENES, |random| {
        let cameras = two_cameras((random, Motion::General), 6);
        let focal = uniform(random, 500.0, 3000.0);
        let scene = Rays::<6>::of(random, cameras);
        let in_pixels = |[x, y, z]: [f64; 3]| [focal * x / z, focal * y / z];
        let [first, second] = [scene.first, scene.second].map(|rays| rays.map(in_pixels));
        let found = relpose_6pt_focal_points::solve_for_focal_pose(&first, &second).unwrap_or_default();
        assert!(found.iter().all(|pose| is_rotation(&pose.rotation)));
        let is_focal = |found: f64| (found / focal - 1.0).abs() < FOUND;
        found.iter().any(|pose| scene.is_pose(&pose.rotation, &pose.translation) && is_focal(pose.focal))
    });
}
