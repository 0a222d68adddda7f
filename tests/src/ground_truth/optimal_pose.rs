//! Poses of cameras as stationary points of least-squares costs.

use eliminant_generator::algebra::Random;
use nalgebra::{Matrix3, SVector, Vector3};

use super::cameras::{cayley, frame, image, quaternion};
use super::{KnownInstance, Make, Maker, View, coordinates, projective_error, relative_error, vector};

pub(super) fn makers() -> Vec<Maker> {
    vec![
        Maker {
            name: "pose_npt_direct_least_squares",
            make: Make::KnownPoints(|random, view| {
                let (data, rotation) = rays_and_points(random, view, &frame());
                KnownInstance { data, truths: vec![cayley(&rotation)] }
            }),
            error: |_, solution, truth| relative_error(solution, truth),
        },
        Maker {
            name: "pose_npt_least_squares_cayley",
            make: Make::KnownPoints(|random, view| {
                let (data, rotation) = rays_and_points(random, view, &Matrix3::identity());
                KnownInstance { data, truths: vec![coordinates(&quaternion(&rotation))] }
            }),
            error: |_, solution, truth| projective_error(&vector(solution), &vector(truth)),
        },
        Maker {
            name: "pose_npt_least_squares_quaternion",
            make: Make::KnownPoints(|random, view| {
                let (data, rotation) = images_and_points(random, view);
                KnownInstance { data, truths: vec![coordinates(&quaternion(&rotation))] }
            }),
            error: |_, solution, truth| projective_error(&vector(solution), &vector(truth)),
        },
        Maker {
            name: "pose_npt_weak_perspective",
            make: Make::KnownPoints(weak_perspective),
            error: |_, solution, truth| quaternion_error(solution, truth),
        },
    ]
}

/// (w, square, y, z) of a rotation times a scale, whose quaternion is root (w, 1, y, z).
fn ratios(rotation: &Matrix3<f64>, scale: f64) -> [f64; 4] {
    let [w, x, y, z] = quaternion(rotation);
    [w / x, scale * x * x, y / x, z / x]
}

/// The larger error of rotation and scale.
fn quaternion_error(solution: &[f64], truth: &[f64]) -> f64 {
    let direction = |s: &[f64]| [s[0], 1.0, s[2], s[3]];
    let scale = |s: &[f64]| s[1] * direction(s).iter().map(|x| x * x).sum::<f64>();
    let rotation = projective_error(&direction(solution), &direction(truth));
    rotation.max(relative_error(&[scale(solution)], &[scale(truth)]))
}

/// 6 to 12 points.
fn points(random: &mut Random, view: View, pose: &(Matrix3<f64>, Vector3<f64>)) -> Vec<Vector3<f64>> {
    let count = 6 + random.below(7) as usize;
    view.points(random, pose, count)
}

/// The products of the coordinates of a point and 1.
fn products(x: &Vector3<f64>) -> [f64; 10] {
    let [x, y, z]: [f64; 3] = (*x).into();
    [x * x, x * y, x * z, x, y * y, y * z, y, z * z, z, 1.0]
}

/// The mean of vectors.
fn mean<const N: usize>(terms: impl ExactSizeIterator<Item = [f64; N]>) -> Vec<f64> {
    let count = terms.len() as f64;
    (terms.map(SVector::<f64, N>::from).sum::<SVector<f64, N>>() / count).as_slice().to_vec()
}

/// Points, and the rays by which a camera sees them: the means from which the squared distances of
/// the points from the rays follow for all poses. The rotation. Points are turned to a frame.
fn rays_and_points(random: &mut Random, view: View, frame: &Matrix3<f64>) -> (Vec<f64>, Matrix3<f64>) {
    let (rotation, translation) = view.camera(random);
    let terms = points(random, view, &(rotation, translation)).into_iter().map(|point| {
        let ray = (rotation * point + translation).normalize();
        let across = Matrix3::identity() - ray * ray.transpose();
        let entries = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)].map(|at| across[at]);
        let mut summand = [0.0; 60];
        for (row, entry) in summand.chunks_mut(10).zip(entries) {
            row.iter_mut().zip(products(&(frame * point))).for_each(|(place, product)| *place = entry * product);
        }
        summand
    });
    (mean(terms), rotation * frame.transpose())
}

/// Points and their images: the means from which the differences of the images follow for all
/// poses.
fn images_and_points(random: &mut Random, view: View) -> (Vec<f64>, Matrix3<f64>) {
    let (rotation, translation) = view.camera(random);
    let terms = points(random, view, &(rotation, translation)).into_iter().map(|point| {
        let q = image(&(rotation * point + translation), 1.0);
        let mut summand = [0.0; 40];
        for (row, factor) in summand.chunks_mut(10).zip([1.0, q.x, q.y, q.norm_squared()]) {
            row.iter_mut().zip(products(&point)).for_each(|(place, product)| *place = factor * product);
        }
        summand
    });
    let mut means = mean(terms);
    // The mean of 1 is no datum.
    means.remove(9);
    (means, rotation)
}

/// Points far away from a camera, and their images: the means from which the differences of the
/// images follow for all scaled rotations.
fn weak_perspective(random: &mut Random, view: View) -> KnownInstance {
    let (rotation, translation) = view.camera(random);
    let (scale, frame) = (1.0 / translation.norm().max(1.0), frame());
    let terms = points(random, view, &(rotation, translation)).into_iter().map(|point| {
        let q = scale * (rotation * point + translation);
        let point = frame * point;
        let mut summand = [0.0; 18];
        summand[..10].copy_from_slice(&products(&point));
        for (row, factor) in summand[10..].chunks_mut(4).zip([q.x, q.y]) {
            row.copy_from_slice(&[factor * point.x, factor * point.y, factor * point.z, factor]);
        }
        summand
    });
    let mut data = mean(terms);
    // The mean of 1 is no datum.
    data.remove(9);
    KnownInstance { data, truths: vec![ratios(&(rotation * frame.transpose()), scale).to_vec()] }
}

#[cfg(test)]
mod tests {
    use nalgebra::SMatrix;

    use super::*;

    /// The null vector of a form in the entries of [R t]: that is what a true pose is up to scale.
    fn least_form(form: SMatrix<f64, 12, 12>) -> (f64, Matrix3<f64>) {
        let eigen = form.symmetric_eigen();
        let least = (0..12).min_by(|&a, &b| eigen.eigenvalues[a].total_cmp(&eigen.eigenvalues[b])).unwrap();
        let pose = SMatrix::<f64, 3, 4>::from_row_slice(eigen.eigenvectors.column(least).as_slice());
        let rotation = pose.fixed_view::<3, 3>(0, 0).into_owned();
        let scale = rotation.determinant().cbrt();
        (eigen.eigenvalues[least] / eigen.eigenvalues.max(), rotation / scale)
    }

    const SYMMETRIC_3: [[usize; 3]; 3] = [[0, 1, 2], [1, 3, 4], [2, 4, 5]];
    const SYMMETRIC_4: [[usize; 4]; 4] = [[0, 1, 2, 3], [1, 4, 5, 6], [2, 5, 7, 8], [3, 6, 8, 9]];

    /// Both means are a form of which the true pose is a null vector.
    #[test]
    fn true_poses_cost_nothing() {
        let mut random = Random::new(6);
        for _ in 0..1000 {
            let (means, rotation) = rays_and_points(&mut random, View::General, &frame());
            let of_rays = SMatrix::<f64, 12, 12>::from_fn(|at, to| {
                means[10 * SYMMETRIC_3[at / 4][to / 4] + SYMMETRIC_4[at % 4][to % 4]]
            });
            let (least, found) = least_form(of_rays);
            assert!(least.abs() < 1e-12, "{least}");
            assert!((found - rotation).norm() < 1e-4, "{found} {rotation}");

            // (u P3 - P1) X = (v P3 - P2) X = 0
            let (mut means, rotation) = images_and_points(&mut random, View::General);
            means.insert(9, 1.0);
            let of_images = SMatrix::<f64, 12, 12>::from_fn(|at, to| {
                let product = |factor: usize| means[10 * factor + SYMMETRIC_4[at % 4][to % 4]];
                match (at / 4, to / 4) {
                    (2, 2) => product(3),
                    (i, j) if i == j => product(0),
                    (i, 2) | (2, i) => -product(i + 1),
                    _ => 0.0,
                }
            });
            let (least, found) = least_form(of_images);
            assert!(least.abs() < 1e-12, "{least}");
            assert!((found - rotation).norm() < 1e-4, "{found} {rotation}");
        }
    }
}
