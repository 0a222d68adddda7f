//! Solvers that take measurements: what they return beside the unknowns, and what they refuse.

use eliminant::SolveError;
use eliminant_generator::algebra::Random;
use eliminant_solvers::{
    fundamental_7pt, fundamental_8pt, fundamental_8pt_radial, fundamental_8pt_radial_one_side,
    fundamental_9pt_two_radials, pose_2pt_upright, pose_3pt, pose_4pt_focal_radial, pose_4pt_focal_radial_cut,
    pose_4pt_generalized_scale, pose_5tdoa_two_receivers, pose_6pt_rolling_shutter, relpose_3pt_upright,
    relpose_5pt_rays, relpose_6pt_focal_one_side, relpose_6pt_focal_points, relpose_7pt_focal_radial_one_side,
    relpose_7pt_focal_radial_one_side_eliminated, stitching_3pt_radial_focal, triangulation_3view,
};
use eliminant_tests::ground_truth::{
    Motion, camera, distorted, image, in_ball, projective_error, uniform, upright, upright_cameras,
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

    /// Distorted images in the first camera.
    fn first(&self, focal: f64, radial: f64) -> [[f64; 2]; N] {
        self.first.map(|x| distorted(image(&x, focal), radial).into())
    }

    /// Distorted images in the second camera.
    fn second(&self, focal: f64, radial: f64) -> [[f64; 2]; N] {
        self.second.map(|x| distorted(image(&x, focal), radial).into())
    }

    /// The fundamental matrix for focal lengths of both cameras.
    fn fundamental(&self, first: f64, second: f64) -> Matrix3<f64> {
        let inverse = |focal: f64| Matrix3::from_diagonal(&Vector3::new(1.0 / focal, 1.0 / focal, 1.0));
        inverse(second) * self.essential() * inverse(first)
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
    let of_seven = lost(|random| {
        let pair = Pair::<7>::draw(random);
        let [first, second] = pair.images(1.0);
        let found = fundamental_7pt::solve_for_epipolar(&first, &second);
        found.is_ok_and(|found| found.iter().any(|x| distance(&x.fundamental, &pair.essential()) < FOUND))
    });
    let of_eight = lost(|random| {
        let pair = Pair::<8>::draw(random);
        let [first, second] = pair.images(1.0);
        let found = fundamental_8pt::solve_for_epipolar(&first, &second);
        found.is_ok_and(|found| matches!(&found[..], [x] if distance(&x.fundamental, &pair.essential()) < FOUND))
    });
    assert!(of_seven <= LOST && of_eight <= LOST, "{of_seven}, {of_eight}");
}

#[test]
fn scaled_poses_come_from_rays_and_points() {
    let lost = lost(|random| {
        let ((rotation, translation), scale) = (camera(random), uniform(random, 0.5, 2.0));
        let [points, centres]: [[Vector3<f64>; 4]; 2] =
            std::array::from_fn(|_| std::array::from_fn(|_| in_ball(random)));
        let seen = std::array::from_fn(|k| rotation * points[k] + translation - scale * centres[k]);
        let data = [&centres, &seen, &points].map(rays);
        let found = pose_4pt_generalized_scale::solve_for_scaled_pose(&data[0], &data[1], &data[2]);
        let is_near = |x: &pose_4pt_generalized_scale::ScaledPose| {
            let near = Vector3::from(x.translation).metric_distance(&translation) < FOUND;
            near && distance(&x.rotation, &rotation) < FOUND && (x.scale / scale - 1.0).abs() < FOUND
        };
        found.is_ok_and(|found| found.iter().any(is_near))
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

/// Focal lengths and distortions for which image points have a norm of about 1 at most.
fn lens(random: &mut Random) -> (f64, f64) {
    (uniform(random, 2.0, 4.0), -uniform(random, 0.05, 0.5))
}

fn close(found: f64, known: f64) -> bool {
    (found / known - 1.0).abs() < FOUND
}

#[test]
fn a_focal_length_of_one_side_comes_from_points_and_rays() {
    let lost = lost(|random| {
        let (pair, focal) = (Pair::<6>::draw(random), uniform(random, 0.5, 3.0));
        let second = pair.second.map(|x| <[f64; 3]>::from(uniform(random, 0.5, 2.0) * x));
        let found = relpose_6pt_focal_one_side::solve_for_focal_pose(&pair.first(focal, 0.0), &second);
        let known = pair.fundamental(focal, 1.0);
        let is_near = |x: &relpose_6pt_focal_one_side::FocalPose| {
            distance(&x.fundamental, &known) < FOUND && close(x.focal, focal)
        };
        found.is_ok_and(|found| found.iter().all(|x| x.focal > 0.0) && found.iter().any(is_near))
    });
    assert!(lost <= LOST, "{lost}");
}

#[test]
fn fundamental_matrices_and_distortions_come_from_points() {
    let common = lost(|random| {
        let (pair, (first, radial), second) = (Pair::<8>::draw(random), lens(random), lens(random).0);
        let found =
            fundamental_8pt_radial::solve_for_radial_epipolar(&pair.first(first, radial), &pair.second(second, radial));
        let known = pair.fundamental(first, second);
        found.is_ok_and(|found| {
            found.iter().any(|x| distance(&x.fundamental, &known) < FOUND && close(x.radial, radial))
        })
    });
    let one_side = lost(|random| {
        let (pair, first, (second, radial)) = (Pair::<8>::draw(random), lens(random).0, lens(random));
        let found = fundamental_8pt_radial_one_side::solve_for_radial_epipolar(
            &pair.first(first, 0.0),
            &pair.second(second, radial),
        );
        let known = pair.fundamental(first, second);
        found.is_ok_and(|found| {
            found.iter().any(|x| distance(&x.fundamental, &known) < FOUND && close(x.radial, radial))
        })
    });
    let different = lost(|random| {
        let (pair, (first, t), (second, s)) = (Pair::<9>::draw(random), lens(random), lens(random));
        let (x1, x2) = (pair.first(first, t), pair.second(second, s));
        let found = fundamental_9pt_two_radials::solve_for_radial_epipolar(&x1, &x2);
        let known = pair.fundamental(first, second);
        let is_near = |x: &fundamental_9pt_two_radials::RadialEpipolar| {
            distance(&x.fundamental, &known) < FOUND && close(x.radials[0], t) && close(x.radials[1], s)
        };
        found.is_ok_and(|found| found.iter().any(is_near))
    });
    println!("lost of {SCENES}: {common}, {one_side}, {different}");
    assert!(common <= LOST && one_side <= LOST && different <= LOST, "{common}, {one_side}, {different}");
}

#[test]
fn a_distorted_and_a_calibrated_camera() {
    let with_focal = lost(|random| {
        let (pair, (focal, radial)) = (Pair::<7>::draw(random), lens(random));
        let (first, second) = (pair.first(focal, radial), pair.second(1.0, 0.0));
        let found = relpose_7pt_focal_radial_one_side::solve_for_radial_focal_pose(&first, &second);
        let known = pair.fundamental(focal, 1.0);
        let is_near = |x: &relpose_7pt_focal_radial_one_side::RadialFocalPose| {
            distance(&x.fundamental, &known) < FOUND && close(x.focal, focal) && close(x.radial, radial)
        };
        found.is_ok_and(|found| found.iter().any(is_near))
    });
    let eliminated = lost(|random| {
        let (pair, (focal, radial)) = (Pair::<7>::draw(random), lens(random));
        let (first, second) = (pair.first(focal, radial), pair.second(1.0, 0.0));
        let found = relpose_7pt_focal_radial_one_side_eliminated::solve_for_radial_epipolar(&first, &second);
        let known = pair.fundamental(focal, 1.0);
        found.is_ok_and(|found| {
            found.iter().any(|x| distance(&x.fundamental, &known) < FOUND && close(x.radial, radial))
        })
    });
    println!("lost of {SCENES}: {with_focal}, {eliminated}");
    assert!(with_focal <= LOST && eliminated <= LOST, "{with_focal}, {eliminated}");
}

/// Points far from the origin and in other units.
#[test]
fn projections_of_distorted_cameras_come_from_four_points() {
    for (unit, shift) in [(1.0, 0.0), (1e3, 1e4)] {
        let near = |projection: &[[f64; 4]; 3], known: &[f64; 12]| {
            // In the units of the scene.
            let moved = projection.map(|[x, y, z, t]| {
                let shift = shift * (x + y + z);
                [x, y, z, (t + shift) / unit]
            });
            projective_error(moved.as_flattened(), known) < FOUND
        };
        let lost = lost(|random| {
            let (rotation, translation) = camera(random);
            let (focal, radial) = (uniform(random, 0.5, 3.0), -uniform(random, 0.05, 0.5) / 9.0);
            let points: [Vector3<f64>; 4] = std::array::from_fn(|_| in_ball(random));
            let images =
                points.map(|x| <[f64; 2]>::from(distorted(image(&(rotation * x + translation), focal), radial)));
            let points = points.map(|x| <[f64; 3]>::from((unit * x).add_scalar(shift)));
            let rows = [0, 1, 2].map(|i| {
                let weight = if i == 2 { 1.0 / focal } else { 1.0 };
                [rotation[(i, 0)], rotation[(i, 1)], rotation[(i, 2)], translation[i]].map(|x| weight * x)
            });
            let known = std::array::from_fn(|at| rows[at / 4][at % 4]);
            let found = pose_4pt_focal_radial::solve_for_radial_pose(&points, &images).unwrap_or_default();
            let cut = pose_4pt_focal_radial_cut::solve_for_radial_pose(&points, &images).unwrap_or_default();
            found.iter().any(|x| near(&x.projection, &known) && close(x.focal, focal) && close(x.radial, radial))
                && cut.iter().any(|x| near(&x.projection, &known) && close(x.focal, focal) && close(x.radial, radial))
        });
        println!("unit {unit:e}: {lost} of {SCENES} lost");
        assert!(lost <= LOST, "unit {unit:e}: {lost}");
    }
}

#[test]
fn panoramas_have_a_focal_length() {
    let lost = lost(|random| {
        let (focal, radial) = (uniform(random, 1.0, 2.0), -uniform(random, 0.05, 0.5));
        let rotation =
            nalgebra::Rotation3::new(Vector3::new(uniform(random, 0.3, 0.5), uniform(random, 0.3, 0.5), 0.1));
        let directions: [Vector3<f64>; 3] = std::array::from_fn(|_| 0.4 * in_ball(random) + Vector3::z());
        let seen = |x: Vector3<f64>| <[f64; 2]>::from(distorted(image(&x, focal), radial));
        let (first, second) = (directions.map(seen), directions.map(|x| seen(rotation.inverse() * x)));
        let found = stitching_3pt_radial_focal::solve_for_panorama(&first, &second).unwrap_or_default();
        found.iter().any(|x| close(x.focal, focal) && close(x.radial, radial))
    });
    // Of directions that are close to each other the equations are close to each other, too.
    println!("{lost} of {SCENES} lost");
    assert!(lost <= LOST, "{lost}");
}

/// Without errors of the images the best point is the point.
#[test]
fn points_come_from_three_views() {
    let scenes = 100;
    let lost = (0..scenes)
        .filter(|&k| {
            let random = &mut Random::new(67_000_000 + k);
            let (poses, point) = ([camera(random), camera(random), camera(random)], in_ball(random));
            let cameras = poses
                .map(|(rotation, t)| [0, 1, 2].map(|i| [rotation[(i, 0)], rotation[(i, 1)], rotation[(i, 2)], t[i]]));
            let images = poses.map(|(rotation, t)| {
                let error = 1e-4 * Vector2::from_fn(|_, _| random.symmetric_unit());
                <[f64; 2]>::from(image(&(rotation * point + t), 1.0) + error)
            });
            let found = triangulation_3view::solve_for_point(&cameras, &images).unwrap_or_default();
            !found.iter().any(|x| (Vector3::from(x.position) - point).norm() < 1e-2)
        })
        .count();
    assert_eq!(lost, 0);
}

#[test]
fn receivers_come_from_differences_of_ranges() {
    let lost = lost(|random| {
        let (centre, direction) = (in_ball(random), in_ball(random));
        let senders: [Vector3<f64>; 5] = std::array::from_fn(|_| in_ball(random));
        let differences = senders.map(|sender| direction.dot(&(sender - centre).normalize()));
        let found = pose_5tdoa_two_receivers::solve_for_receiver_pair(&rays(&senders), &differences, direction.norm());
        found.unwrap_or_default().iter().any(|pair| {
            projective_error(&pair.direction, direction.as_slice()) < FOUND
                && (Vector3::from(pair.centre) - centre).norm() < FOUND
        })
    });
    assert!(lost <= LOST, "{lost}");
}

#[test]
fn rolling_shutters_have_a_velocity() {
    let lost = lost(|random| {
        let [turn, spin, velocity] = [(); 3].map(|()| 0.3 * in_ball(random));
        let position = Vector3::new(random.symmetric_unit(), random.symmetric_unit(), uniform(random, 3.0, 5.0));
        let points: [Vector3<f64>; 6] = std::array::from_fn(|_| in_ball(random));
        let images = points.map(|point| {
            let turned = point + turn.cross(&point);
            let (still, moved) = (turned + position, spin.cross(&turned) + velocity);
            // The row in which the point is exposed, by iteration: motions are slow.
            let row = (0..200).fold(still.x / still.z, |row, _| {
                let seen = still + row * moved;
                seen.x / seen.z
            });
            let seen = still + row * moved;
            [row, seen.y / seen.z]
        });
        let found = pose_6pt_rolling_shutter::solve_for_rolling_pose(&rays(&points), &images).unwrap_or_default();
        found.iter().any(|x| {
            let known = Matrix3::identity() + turn.cross_matrix();
            (Matrix3::from(x.rotation).transpose() - known).norm() < FOUND
                && (Vector3::from(x.position) - position).norm() < FOUND * position.norm()
                && (Vector3::from(x.velocity) - velocity).norm() < FOUND
                && (Vector3::from(x.angular_velocity) - spin).norm() < FOUND
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

/// What only results are computed from has no part in the solve, however large it is: here the
/// inverse of the differences of points that are small or almost on a line. The rays are at right
/// angles, where the template has lost rank and solutions are followed from data nearby.
#[test]
fn results_are_those_of_the_solve() {
    let seen = [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]];
    let mut found = 0;
    for unit in [1.0, 1e-3, 1e-6, 1e-9] {
        for from_line in [1.0, 1e-6, 1e-10, 1e-13] {
            let points = [[0.0; 3], [1.0, 2.0, 3.0], [0.5 + 3.0 * from_line, 1.0, 1.5 - from_line]];
            let points = points.map(|point| point.map(|x| x * unit));
            let data = pose_3pt::Data { rays: seen, points };
            let mut results = [Err(SolveError::NoConvergence)];
            pose_3pt::solve_batch(&[data], &mut results);
            let solutions = results[0].as_ref().unwrap();
            let of_each = pose_3pt::pose_of_each(&seen, &points, solutions).unwrap();
            assert_eq!(pose_3pt::solve_for_pose(&seen, &points).unwrap(), of_each, "{unit} {from_line}");
            found += of_each.len();
        }
    }
    assert!(found > 0);
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
