//! Points on conics and quadrics, at known distances, and fixed by a quadratic map.

use eliminant_generator::algebra::Random;
use nalgebra::{Matrix3, Vector3};

use super::cameras::in_ball;
use super::{KnownInstance, Make, Maker, null_space, relative_error, uniform};

pub(super) fn makers() -> Vec<Maker> {
    vec![
        Maker {
            name: "tensor_eigenvectors",
            make: Make::Scene(orthogonal_tensor),
            // One of them is zero.
            error: |_, solution, truth| distance(solution, truth) / (1.0 + distance(truth, &[0.0; 3])),
        },
        Maker {
            name: "three_quadrics",
            make: Make::Scene(quadrics_through_points),
            error: |_, solution, truth| relative_error(solution, truth),
        },
        Maker {
            name: "trilateration",
            make: Make::Scene(distances_to_points),
            error: |_, solution, truth| relative_error(solution, truth),
        },
        Maker {
            name: "two_conics",
            make: Make::Scene(conics_through_points),
            error: |_, solution, truth| relative_error(solution, truth),
        },
    ]
}

/// Two conics of the pencil through four points in [-1, 1)^2: they meet in these points and nowhere
/// else.
fn conics_through_points(random: &mut Random) -> KnownInstance {
    let points: Vec<Vec<f64>> = (0..4).map(|_| (0..2).map(|_| random.symmetric_unit()).collect()).collect();
    let rows: Vec<Vec<f64>> =
        points.iter().map(|p| vec![p[0] * p[0], p[0] * p[1], p[1] * p[1], p[0], p[1], 1.0]).collect();
    KnownInstance { data: null_space(&rows).concat(), truths: points }
}

/// Three quadrics through seven points in [-1, 1)^3. All quadrics through these have an eighth
/// point in common, which is not listed.
fn quadrics_through_points(random: &mut Random) -> KnownInstance {
    let points: Vec<Vec<f64>> = (0..7).map(|_| (0..3).map(|_| random.symmetric_unit()).collect()).collect();
    let rows: Vec<Vec<f64>> = points
        .iter()
        .map(|p| {
            let [x, y, z] = [p[0], p[1], p[2]];
            vec![x * x, x * y, x * z, y * y, y * z, z * z, x, y, z, 1.0]
        })
        .collect();
    KnownInstance { data: null_space(&rows).concat(), truths: points }
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    (Vector3::from_column_slice(a) - Vector3::from_column_slice(b)).norm()
}

/// The sum of s v x v x v over three orthonormal v with weights s: x is the sum of v / s over any
/// of them, or none.
fn orthogonal_tensor(random: &mut Random) -> KnownInstance {
    let vectors = Matrix3::from_fn(|_, _| random.symmetric_unit()).qr().q();
    let parts = [0, 1, 2].map(|k| (vectors.column(k).into_owned(), uniform(random, 0.5, 1.5)));
    let entry = |i: usize, j: usize, k: usize| parts.iter().map(|(v, s)| s * v[i] * v[j] * v[k]).sum::<f64>();
    let data = (0..27).map(|at| entry(at / 9, at / 3 % 3, at % 3)).collect();
    let truths = (0..8).map(|subset| {
        let chosen = parts.iter().enumerate().filter(|(k, _)| subset >> k & 1 == 1);
        chosen.map(|(_, (v, s))| v / *s).sum::<Vector3<f64>>().as_slice().to_vec()
    });
    KnownInstance { data, truths: truths.collect() }
}

/// Distances of a point of the unit ball from three others of it: the point and its mirror image.
fn distances_to_points(random: &mut Random) -> KnownInstance {
    let centres: Vec<Vector3<f64>> = (0..3).map(|_| in_ball(random)).collect();
    let point = in_ball(random);
    let normal = (centres[1] - centres[0]).cross(&(centres[2] - centres[0])).normalize();
    let image = point - normal * (2.0 * normal.dot(&(point - centres[0])));
    let distances = centres.iter().map(|centre| (centre - point).norm());
    let data = centres.iter().flat_map(|centre| centre.iter().copied()).chain(distances).collect();
    KnownInstance { data, truths: [point, image].map(|x| x.as_slice().to_vec()).to_vec() }
}
