//! Points in space from their images.

use std::array::from_fn;

use eliminant_generator::algebra::Random;
use nalgebra::{Matrix2, Matrix3, Matrix4, RowVector4, SMatrix, SVector, Vector2, Vector3, Vector4};

use super::cameras::{camera, image, in_ball};
use super::{KnownInstance, Make, Maker, derived_null_space, relative_error};

pub(super) fn makers() -> Vec<Maker> {
    vec![
        Maker {
            name: "triangulation_3view",
            make: Make::Scene(three_depths),
            error: |_, solution, truth| relative_error(solution, truth),
        },
        Maker {
            name: "triangulation_3view_relaxed",
            make: Make::Scene(three_views),
            error: |_, solution, truth| relative_error(&solution[..6], &truth[..6]),
        },
    ]
}

type Camera = (Matrix3<f64>, Vector3<f64>);

/// Three cameras, a point of the unit ball, and where they see it with an error of up to 0.003.
fn seen_point(random: &mut Random) -> ([Camera; 3], Vector3<f64>, [Vector2<f64>; 3]) {
    let cameras: [Camera; 3] = from_fn(|_| camera(random));
    let point = in_ball(random);
    let exact = cameras.map(|(rotation, translation)| image(&(rotation * point + translation), 1.0));
    (cameras, point, exact.map(|q| q + 0.003 * Vector2::from_fn(|_, _| random.symmetric_unit())))
}

/// The point whose images are closest to what is seen, in coordinates in which two depths relative
/// to the third are x and y.
fn three_depths(random: &mut Random) -> KnownInstance {
    let (cameras, start, seen) = seen_point(random);
    let depth = |k: usize| {
        let (rotation, translation): &Camera = &cameras[k];
        RowVector4::from_fn(|_, j| if j == 3 { translation.z } else { rotation[(2, j)] })
    };
    // Residual times depth.
    let offset = |k: usize| {
        let (rotation, translation): &Camera = &cameras[k];
        SMatrix::<f64, 2, 4>::from_fn(|i, j| if j == 3 { translation[i] } else { rotation[(i, j)] })
            - seen[k] * depth(k)
    };
    let depths: [RowVector4<f64>; 3] = from_fn(depth);
    let offsets: [SMatrix<f64, 2, 4>; 3] = from_fn(offset);
    // The point at depth zero in all views, and images turned so that their second axis does not
    // see it.
    let rows: Vec<Vec<f64>> = depths.iter().map(|row| row.iter().copied().collect()).collect();
    let axis = Vector4::from_row_slice(&derived_null_space(&rows));
    let scales = offsets.map(|offset| (offset * axis).norm());
    let turned: [SMatrix<f64, 2, 4>; 3] = from_fn(|k| {
        let along = (offsets[k] * axis).normalize();
        Matrix2::new(along.x, along.y, -along.y, along.x) * offsets[k]
    });
    let frame = Matrix4::from_rows(&[
        depths[0] * (scales[2] / scales[0]),
        depths[1] * (scales[2] / scales[1]),
        turned[2].row(0).into_owned(),
        depths[2],
    ]);
    let cameras = cameras.iter().flat_map(|(rotation, translation)| {
        (0..3).flat_map(|i| [rotation[(i, 0)], rotation[(i, 1)], rotation[(i, 2)], translation[i]])
    });
    let data = cameras.chain(seen.iter().flat_map(|q| q.data.0[0])).collect();
    let best = frame * nearest(&depths, &offsets, start).push(1.0);
    KnownInstance { data, truths: vec![(best.xyz() / best.w).as_slice().to_vec()] }
}

/// The stationary point of the squared residuals next to `start`, by the method of Gauss and
/// Newton, which converges fast where they are small.
fn nearest(depths: &[RowVector4<f64>; 3], offsets: &[SMatrix<f64, 2, 4>; 3], start: Vector3<f64>) -> Vector3<f64> {
    let mut point = start;
    for _ in 0..20 {
        let x = point.push(1.0);
        let mut slope = SMatrix::<f64, 6, 3>::zeros();
        let mut residuals = SVector::<f64, 6>::zeros();
        for (k, (depth, offset)) in depths.iter().zip(offsets).enumerate() {
            let (z, residual) = ((depth * x).x, offset * x / (depth * x).x);
            residuals.fixed_rows_mut::<2>(2 * k).copy_from(&residual);
            let rows = (offset - residual * depth).fixed_columns::<3>(0) / z;
            slope.fixed_rows_mut::<2>(2 * k).copy_from(&rows);
        }
        let normal = slope.transpose() * slope;
        point -= normal.lu().solve(&(slope.transpose() * residuals)).expect("the rays are not parallel");
    }
    point
}

/// The image points that satisfy two epipolar constraints and are closest to what three cameras
/// see.
fn three_views(random: &mut Random) -> KnownInstance {
    let (cameras, point, seen) = seen_point(random);
    let exact = cameras.map(|(rotation, translation)| image(&(rotation * point + translation), 1.0));
    // p^T [t]x R p' = 0 with the rotation and the translation from the second camera of a pair to
    // the first.
    let essential = |(r1, t1): (Matrix3<f64>, Vector3<f64>), (r2, t2): (Matrix3<f64>, Vector3<f64>)| {
        let rotation = r1 * r2.transpose();
        (t1 - rotation * t2).normalize().cross_matrix() * rotation
    };
    let [first, second] = [essential(cameras[0], cameras[1]), essential(cameras[1], cameras[2])];
    let truth = closest(&first, &second, &seen, exact);
    let matrices = [first, second].into_iter().flat_map(|matrix| matrix.transpose().as_slice().to_vec());
    let data = matrices.chain(seen.iter().flat_map(|q| q.data.0[0])).collect();
    KnownInstance { data, truths: vec![truth] }
}

/// The points and the multipliers (a, b), by Newton's method on the derivatives of |p1 - m1|^2 +
/// |p2 - m2|^2 + |p3 - m3|^2 + a p1^T `first` p2 + b p2^T `second` p3, the image points with a
/// third coordinate of 1 in the products, from `start` and a = b = 0.
fn closest(
    first: &Matrix3<f64>,
    second: &Matrix3<f64>,
    measured: &[Vector2<f64>; 3],
    start: [Vector2<f64>; 3],
) -> Vec<f64> {
    let mut x = SVector::<f64, 8>::from_fn(|i, _| if i < 6 { start[i / 2][i % 2] } else { 0.0 });
    for _ in 0..20 {
        let p: [Vector3<f64>; 3] = from_fn(|k| Vector3::new(x[2 * k], x[2 * k + 1], 1.0));
        let mut gradient = SVector::<f64, 8>::zeros();
        let mut hessian = SMatrix::<f64, 8, 8>::zeros();
        for i in 0..6 {
            gradient[i] = 2.0 * (x[i] - measured[i / 2][i % 2]);
            hessian[(i, i)] = 2.0;
        }
        for (k, matrix) in [first, second].into_iter().enumerate() {
            let (left, right, at, multiplier) = (matrix * p[k + 1], matrix.transpose() * p[k], 6 + k, x[6 + k]);
            gradient[at] = p[k].dot(&left);
            for i in 0..2 {
                for (entry, slope) in [(2 * k + i, left[i]), (2 * k + 2 + i, right[i])] {
                    gradient[entry] += multiplier * slope;
                    hessian[(entry, at)] = slope;
                    hessian[(at, entry)] = slope;
                }
                for j in 0..2 {
                    hessian[(2 * k + i, 2 * k + 2 + j)] = multiplier * matrix[(i, j)];
                    hessian[(2 * k + 2 + j, 2 * k + i)] = multiplier * matrix[(i, j)];
                }
            }
        }
        x -= hessian.lu().solve(&gradient).expect("the epipolar constraints are independent");
    }
    x.as_slice().to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn closest_points_satisfy_the_epipolar_constraints() {
        let mut random = Random::new(7);
        for _ in 0..1000 {
            let KnownInstance { data, truths } = three_views(&mut random);
            let p: [Vector3<f64>; 3] = from_fn(|k| Vector3::new(truths[0][2 * k], truths[0][2 * k + 1], 1.0));
            for k in 0..2 {
                let matrix = Matrix3::from_row_slice(&data[9 * k..9 * k + 9]);
                assert!(p[k].dot(&(matrix * p[k + 1])).abs() < 1e-14);
            }
            let moved = truths[0].iter().zip(&data[18..]).map(|(x, m)| (x - m).abs());
            assert!(moved.fold(0.0, f64::max) < 0.02);
        }
    }
}
