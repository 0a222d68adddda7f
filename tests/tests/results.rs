//! Solvers that take measurements: what they return beside the unknowns, and what they refuse.

use eliminant::SolveError;
use eliminant_generator::algebra::Random;
use eliminant_solvers::{
    fundamental_7pt, pose_2pt_upright, pose_3pt, relpose_3pt_upright, relpose_5pt_rays, relpose_6pt_focal_points,
};
use eliminant_tests::ground_truth::{
    Motion, camera, image, in_ball, projective_error, uniform, upright, upright_cameras,
};
use nalgebra::{Matrix3, Vector2, Vector3};

const SCENES: u64 = 1_000;
/// A result is the known one if it is this close.
const FOUND: f64 = 1e-6;
/// Scenes of a thousand on which it may be missing: those that are close to degenerate ones.
const LOST: usize = 1;

/// Two cameras and points that both see: the relative rotation and translation, and the points in
/// both cameras.
struct Pair<const N: usize> {
    rotation: Matrix3<f64>,
    translation: Vector3<f64>,
    first: [Vector3<f64>; N],
    second: [Vector3<f64>; N],
}

impl<const N: usize> Pair<N> {
    fn draw(random: &mut Random) -> Self {
        let ((r1, t1), (r2, t2)) = (camera(random), camera(random));
        let points: [Vector3<f64>; N] = std::array::from_fn(|_| in_ball(random));
        let rotation = r2 * r1.transpose();
        Self {
            rotation,
            translation: t2 - rotation * t1,
            first: points.map(|x| r1 * x + t1),
            second: points.map(|x| r2 * x + t2),
        }
    }

    fn essential(&self) -> Matrix3<f64> {
        self.translation.cross_matrix() * self.rotation
    }

    fn images(&self, focal: f64) -> [[[f64; 2]; N]; 2] {
        [&self.first, &self.second].map(|points| points.map(|x| <[f64; 2]>::from(image(&x, focal))))
    }
}

fn rays<const N: usize>(points: &[Vector3<f64>; N]) -> [[f64; 3]; N] {
    points.map(<[f64; 3]>::from)
}

/// The distance of matrices up to scale; rows are listed, nalgebra lists columns.
fn distance(rows: &[[f64; 3]; 3], known: &Matrix3<f64>) -> f64 {
    projective_error(rows.as_flattened(), known.transpose().as_slice())
}

/// Scenes on which no result is near the truth, of [`SCENES`].
fn lost(is_found: impl Fn(&mut Random) -> bool) -> usize {
    (0..SCENES).filter(|&k| !is_found(&mut Random::new(64_000_000 + k))).count()
}

#[test]
fn essential_matrices_come_from_rays() {
    let lost = lost(|random| {
        let pair = Pair::<5>::draw(random);
        let found = relpose_5pt_rays::solve_for_relative_pose(&rays(&pair.first), &rays(&pair.second));
        found.is_ok_and(|found| found.iter().any(|x| distance(&x.essential, &pair.essential()) < FOUND))
    });
    assert!(lost <= LOST, "{lost}");
}

#[test]
fn fundamental_matrices_come_from_points() {
    let lost = lost(|random| {
        let pair = Pair::<7>::draw(random);
        let [first, second] = pair.images(1.0);
        let found = fundamental_7pt::solve_for_epipolar(&first, &second);
        found.is_ok_and(|found| found.iter().any(|x| distance(&x.fundamental, &pair.essential()) < FOUND))
    });
    assert!(lost <= LOST, "{lost}");
}

#[test]
fn focal_lengths_come_from_points() {
    let lost = lost(|random| {
        let (pair, focal) = (Pair::<6>::draw(random), uniform(random, 0.5, 3.0));
        let [first, second] = pair.images(focal);
        let inverse = Matrix3::from_diagonal(&Vector3::new(1.0 / focal, 1.0 / focal, 1.0));
        let known = inverse * pair.essential() * inverse;
        let found = relpose_6pt_focal_points::solve_for_focal_pose(&first, &second).unwrap_or_default();
        assert!(found.iter().all(|x| x.focal > 0.0), "solutions without a focal length are dropped");
        let is_near = |x: &relpose_6pt_focal_points::FocalPose| {
            distance(&x.fundamental, &known) < FOUND && (x.focal / focal - 1.0).abs() < FOUND
        };
        found.iter().any(is_near)
    });
    assert!(lost <= LOST, "{lost}");
}

#[test]
fn poses_come_from_rays_and_points() {
    let lost = lost(|random| {
        let (rotation, translation) = camera(random);
        let points: [Vector3<f64>; 3] = std::array::from_fn(|_| in_ball(random));
        let seen = points.map(|x| (rotation * x + translation) * uniform(random, 0.5, 2.0));
        let found = pose_3pt::solve_for_pose(&rays(&seen), &rays(&points)).unwrap_or_default();
        let near = |pose: &pose_3pt::Pose| {
            let found = Matrix3::from(pose.rotation).transpose();
            (found - rotation).norm() < FOUND
                && (Vector3::from(pose.translation) - translation).norm() < FOUND * translation.norm()
        };
        let solutions = pose_3pt::solve(&rays(&seen), &rays(&points)).unwrap_or_default();
        assert!(solutions.iter().all(|solution| solution.distances.iter().all(|&d| d > 0.0)));
        found.len() == solutions.len() && found.iter().any(near)
    });
    assert!(lost <= LOST, "{lost}");
}

#[test]
fn poses_of_upright_cameras_come_from_two_points() {
    let lost = lost(|random| {
        let (rotation, (_, translation)) = (upright(random), camera(random));
        let points: [Vector3<f64>; 2] = std::array::from_fn(|_| in_ball(random));
        let seen = points.map(|x| (rotation * x + translation) * uniform(random, 0.5, 2.0));
        let found = pose_2pt_upright::solve_for_pose(&rays(&seen), &rays(&points)).unwrap_or_default();
        found.iter().any(|pose| {
            (Matrix3::from(pose.rotation).transpose() - rotation).norm() < FOUND
                && (Vector3::from(pose.translation) - translation).norm() < FOUND * translation.norm()
        })
    });
    assert!(lost <= LOST, "{lost}");
}

#[test]
fn relative_poses_of_upright_cameras_come_from_three_points() {
    let lost = lost(|random| {
        let (rotation, translation, points) = upright_cameras((random, Motion::General), 3);
        let first: [Vector3<f64>; 3] = std::array::from_fn(|k| points[k]);
        let second = first.map(|x| (rotation * x + translation) * uniform(random, 0.5, 2.0));
        let found = relpose_3pt_upright::solve_for_relative_pose(&rays(&first), &rays(&second)).unwrap_or_default();
        found.iter().any(|pose| {
            (Matrix3::from(pose.rotation).transpose() - rotation).norm() < FOUND
                && Vector3::from(pose.translation).normalize().cross(&translation.normalize()).norm() < FOUND
        })
    });
    assert!(lost <= LOST, "{lost}");
}

/// A result of one solution, also of a complex one, is that of the list.
#[test]
fn results_of_single_solutions() {
    let pair = Pair::<5>::draw(&mut Random::new(65_000_000));
    let (first, second) = (rays(&pair.first), rays(&pair.second));
    let solutions = relpose_5pt_rays::solve(&first, &second).unwrap();
    let results = relpose_5pt_rays::solve_for_relative_pose(&first, &second).unwrap();
    assert!(!solutions.is_empty());
    assert_eq!(relpose_5pt_rays::relative_pose_of_each(&first, &second, &solutions).unwrap(), results);
    for (solution, result) in solutions.iter().zip(&results) {
        assert_eq!(relpose_5pt_rays::relative_pose_of(&first, &second, solution).unwrap(), *result);
        // Of weights of length 1 on an orthonormal basis.
        let square: f64 = result.essential.as_flattened().iter().map(|x| x * x).sum();
        assert!((square - 1.0).abs() < 1e-14, "{square}");
    }
    for solution in &relpose_5pt_rays::solve_complex(&first, &second).unwrap() {
        let essential = relpose_5pt_rays::relative_pose_of(&first, &second, solution).unwrap().essential;
        let determinant = nalgebra::Matrix3::from(essential).determinant();
        assert!(determinant.norm() < 1e-12, "{determinant}");
    }
}

/// Points that say the same twice, and numbers that are none.
#[test]
fn dependent_measurements_are_refused() {
    let pair = Pair::<5>::draw(&mut Random::new(66_000_000));
    let (mut first, mut second) = (rays(&pair.first), rays(&pair.second));
    (first[4], second[4]) = (first[1].map(|x| 3.0 * x), second[1].map(|x| -0.5 * x));
    assert_eq!(relpose_5pt_rays::solve(&first, &second).unwrap_err(), SolveError::LostRank);
    let mut results = [Ok(relpose_5pt_rays::solve(&rays(&pair.first), &rays(&pair.second)).unwrap())];
    relpose_5pt_rays::solve_batch(&[relpose_5pt_rays::Data { first, second }], &mut results);
    assert_eq!(results[0].as_ref().unwrap_err(), &SolveError::LostRank);
    second[4] = [0.0; 3];
    assert_eq!(relpose_5pt_rays::solve(&first, &second).unwrap_err(), SolveError::LostRank);
    for bad in [f64::NAN, f64::INFINITY] {
        first[2][0] = bad;
        assert_eq!(relpose_5pt_rays::solve(&first, &second).unwrap_err(), SolveError::NonFiniteInput);
    }
    // Points on a line determine distances and no rotation, and a ray without a direction has no
    // length.
    let points = [[0.0; 3], [1.0, 2.0, 3.0], [2.0, 4.0, 6.0]];
    let seen = [[0.0, 0.0, 1.0], [0.1, 0.0, 1.0], [0.3, 0.0, 1.0]];
    assert!(pose_3pt::solve(&seen, &points).is_ok());
    assert_eq!(pose_3pt::solve_for_pose(&seen, &points).unwrap_err(), SolveError::LostRank);
    let points = [[0.0; 3], [1.0, 2.0, 3.0], [2.0, 4.0, 7.0]];
    assert_eq!(pose_3pt::solve(&[[0.0; 3], seen[1], seen[2]], &points).unwrap_err(), SolveError::Overflow);
}

/// The same scenes in pixels and in other units: null spaces of measurements do not depend on the
/// unit, and focal lengths scale with it.
#[test]
fn measurements_have_any_unit() {
    for unit in [1e-6, 1e-3, 1e3, 1e6] {
        let lost = lost(|random| {
            let (pair, focal) = (Pair::<6>::draw(random), uniform(random, 0.5, 3.0));
            let scaled = pair.images(focal).map(|points| points.map(|x| <[f64; 2]>::from(unit * Vector2::from(x))));
            let found = relpose_6pt_focal_points::solve_for_focal_pose(&scaled[0], &scaled[1]).unwrap_or_default();
            found.iter().any(|x| (x.focal / (unit * focal) - 1.0).abs() < FOUND)
        });
        println!("unit {unit:e}: {lost} of {SCENES} lost");
        assert!(lost <= LOST, "unit {unit:e}: {lost} of {SCENES}");
    }
}
