//! Poses of cameras as stationary points of least-squares costs.

use eliminant_generator::algebra::Random;
use nalgebra::{DMatrix, Matrix3, SMatrix, Vector3};

use super::cameras::{camera, cayley, image, in_ball, quaternion};
use super::{KnownInstance, Make, Maker, coordinates, projective_error, relative_error, vector};

pub(super) fn makers() -> Vec<Maker> {
    vec![
        Maker {
            name: "pose_npt_direct_least_squares",
            make: Make::Scene(|random| {
                let (cost, rotation) = object_space_cost(random);
                KnownInstance { data: quartic(&cost)[1..].to_vec(), truths: vec![cayley(&rotation)] }
            }),
            error: |_, solution, truth| relative_error(solution, truth),
        },
        Maker {
            name: "pose_npt_least_squares_cayley",
            make: Make::Scene(|random| {
                let (cost, rotation) = object_space_cost(random);
                let truth = coordinates(&quaternion(&rotation));
                KnownInstance { data: cost.as_slice().to_vec(), truths: vec![truth] }
            }),
            error: |_, solution, truth| projective_error(&vector(solution), &vector(truth)),
        },
        Maker {
            name: "pose_npt_least_squares_quaternion",
            make: Make::Scene(relative_depths),
            error: |_, solution, truth| projective_error(&vector(solution), &vector(truth)),
        },
        Maker {
            name: "pose_npt_weak_perspective",
            make: Make::Scene(weak_perspective),
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

/// The entries of a rotation, row by row, on the products (w w, w x, w y, w z, x x, x y, x z, y y,
/// y z, z z) of its quaternion.
#[rustfmt::skip]
pub(super) const ENTRIES: [[f64; 10]; 9] = [
    [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 0.0, -1.0],
    [0.0, 0.0, 0.0, -2.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 2.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, -1.0],
    [0.0, -2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0],
    [0.0, 0.0, -2.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0],
    [0.0, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0],
    [1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, -1.0, 0.0, 1.0],
];

/// 6 to 12 points of the unit ball.
fn points(random: &mut Random) -> Vec<Vector3<f64>> {
    (0..6 + random.below(7)).map(|_| in_ball(random)).collect()
}

/// The mean squared distance of points from the rays by which a camera sees them, with the best
/// translation, as a quadratic form in the entries of the rotation, row by row; and the rotation,
/// which costs nothing.
fn object_space_cost(random: &mut Random) -> (SMatrix<f64, 9, 9>, Matrix3<f64>) {
    let (rotation, translation) = camera(random);
    let points = points(random);
    // The projection across the ray of a point, and the matrix that takes the entries of R to R X.
    let across = |point: &Vector3<f64>| {
        let ray = (rotation * point + translation).normalize();
        Matrix3::identity() - ray * ray.transpose()
    };
    let turn = |x: &Vector3<f64>| SMatrix::<f64, 3, 9>::from_fn(|i, j| if j / 3 == i { x[j % 3] } else { 0.0 });
    let all: Matrix3<f64> = points.iter().map(across).sum();
    let turned: SMatrix<f64, 3, 9> = points.iter().map(|x| across(x) * turn(x)).sum();
    let best = -all.try_inverse().expect("the rays are not parallel") * turned;
    let cost = |x: &Vector3<f64>| {
        let distance = across(x) * (turn(x) + best);
        distance.transpose() * distance
    };
    (points.iter().map(cost).sum::<SMatrix<f64, 9, 9>>() / points.len() as f64, rotation)
}

/// Exponents of (x, y, z), by degree, those of one degree in lexicographic order.
fn exponents(max_degree: usize) -> Vec<[usize; 3]> {
    let of_degree = |d: usize| (0..=d).rev().flat_map(move |x| (0..=d - x).rev().map(move |y| [x, y, d - x - y]));
    (0..=max_degree).flat_map(of_degree).collect()
}

/// The coefficients of a cost in the Cayley parameters, times (1 + x^2 + y^2 + z^2)^2, in the order
/// of [`exponents`].
fn quartic(cost: &SMatrix<f64, 9, 9>) -> Vec<f64> {
    let entries = SMatrix::<f64, 9, 10>::from_fn(|i, j| ENTRIES[i][j]);
    let gram = entries.transpose() * cost * entries;
    let (quadratics, quartics) = (exponents(2), exponents(4));
    let mut coefficients = vec![0.0; quartics.len()];
    for (i, a) in quadratics.iter().enumerate() {
        for (j, b) in quadratics.iter().enumerate() {
            let product = [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
            let at = quartics.iter().position(|m| *m == product).expect("of degree four at most");
            coefficients[at] += gram[(i, j)];
        }
    }
    coefficients
}

/// Points and their images. With depths relative to their mean, and P the rotation over the mean
/// depth, the image (u, v) of X satisfies (u, v) (1 + P3 X) = (P1 X, P2 X) + constants, X relative
/// to the mean of the points.
fn relative_depths(random: &mut Random) -> KnownInstance {
    let (rotation, translation) = camera(random);
    let points = points(random);
    let n = points.len();
    let mean = points.iter().sum::<Vector3<f64>>() / n as f64;
    // On 1 and the entries of P; all u, then all v.
    let mut rows = DMatrix::from_fn(2 * n, 10, |at, j| {
        let (i, x) = (at / n, points[at % n] - mean);
        let q = image(&(rotation * points[at % n] + translation), 1.0)[i];
        match j.checked_sub(1) {
            None => q,
            Some(j) if j / 3 == 2 => q * x[j % 3],
            Some(j) if j / 3 == i => -x[j % 3],
            Some(_) => 0.0,
        }
    });
    // The best constants are means.
    for i in 0..2 {
        let mut half = rows.rows_mut(i * n, n);
        let means = half.row_mean();
        half.row_iter_mut().for_each(|mut row| row -= &means);
    }
    let products = DMatrix::from_fn(10, 11, |i, j| match (i, j) {
        (0, 0) => 1.0,
        (0, _) | (_, 0) => 0.0,
        _ => ENTRIES[i - 1][j - 1],
    });
    let root = (rows * products / (n as f64).sqrt()).qr().unpack_r();
    let truth = coordinates(&quaternion(&rotation));
    KnownInstance { data: root.resize_vertically(20, 0.0).transpose().as_slice().to_vec(), truths: vec![truth] }
}

/// Points far away from a camera, in their principal axes: their standard deviations, and their
/// image times whitened points, on average.
fn weak_perspective(random: &mut Random) -> KnownInstance {
    let (rotation, translation) = camera(random);
    let scale = 1.0 / translation.norm();
    let points = points(random);
    let n = points.len() as f64;
    let mean = points.iter().sum::<Vector3<f64>>() / n;
    let covariance = points.iter().map(|x| (x - mean) * (x - mean).transpose()).sum::<Matrix3<f64>>() / n;
    let principal = covariance.symmetric_eigen();
    let mut axes = principal.eigenvectors;
    if axes.determinant() < 0.0 {
        axes.column_mut(0).neg_mut();
    }
    let spread = principal.eigenvalues.map(f64::sqrt);
    let image = points.iter().map(|x| {
        let whitened = (axes.transpose() * (x - mean)).component_div(&spread);
        scale * (rotation * (x - mean)).xy() * whitened.transpose() / n
    });
    let image: SMatrix<f64, 2, 3> = image.sum();
    let data = spread.iter().copied().chain((0..6).map(|at| image[(at / 3, at % 3)])).collect();
    KnownInstance { data, truths: vec![ratios(&(rotation * axes), scale).to_vec()] }
}

#[cfg(test)]
mod tests {
    use nalgebra::SVector;

    use super::*;

    /// x^T M x.
    fn form(matrix: &[f64], x: &[f64]) -> f64 {
        let n = x.len();
        (0..n * n).map(|at| matrix[at] * x[at / n] * x[at % n]).sum()
    }

    #[test]
    fn true_poses_cost_nothing() {
        let mut random = Random::new(6);
        for _ in 0..1000 {
            let (cost, rotation) = object_space_cost(&mut random);
            assert!(form(cost.as_slice(), rotation.transpose().as_slice()).abs() < 1e-12);

            let x = cayley(&rotation);
            let powers = exponents(4).into_iter().map(|m| (0..3).map(|i| x[i].powi(m[i] as i32)).product::<f64>());
            let value: f64 = quartic(&cost).iter().zip(powers).map(|(c, m)| c * m).sum();
            let norm = 1.0 + x.iter().map(|x| x * x).sum::<f64>();
            assert!(value.abs() < 1e-12 * norm * norm);

            let instance = relative_depths(&mut random);
            let [w, x, y, z] = vector(&instance.truths[0])[..] else { panic!("a quaternion") };
            let products = [0.0, w * w, w * x, w * y, w * z, x * x, x * y, x * z, y * y, y * z, z * z];
            let root = SMatrix::<f64, 20, 11>::from_row_slice(&instance.data);
            let (constant, slope) = (root.column(0), root * SVector::from(products));
            let cost = constant - slope * (slope.dot(&constant) / slope.norm_squared());
            assert!(cost.norm() < 1e-12 * constant.norm(), "{}", cost.norm());
        }
    }
}
