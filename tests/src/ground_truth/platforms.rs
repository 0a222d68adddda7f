//! Poses of platforms from the lengths of their legs.

use std::array::from_fn;

use eliminant_generator::algebra::Random;
use nalgebra::{Matrix3, Rotation3, SMatrix, Vector3};

use super::cameras::{camera, cayley, in_ball};
use super::{KnownInstance, Make, Maker, null_space, relative_error};

/// The entries of a rotation, row by row, on the products (w w, w x, w y, w z, x x, x y, x z, y y,
/// y z, z z) of its quaternion.
#[rustfmt::skip]
const ENTRIES: [[f64; 10]; 9] = [
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

pub(super) fn makers() -> Vec<Maker> {
    vec![Maker {
        name: "platform_forward_kinematics",
        make: Make::Scene(|random| known_pose(&Platform::draw(random))),
        error: |_, solution, truth| relative_error(solution, truth),
    }]
}

/// Joints of base and platform relative to those of the first leg, and the pose x -> rotation x +
/// translation of the platform.
struct Platform {
    base: [Vector3<f64>; 5],
    joints: [Vector3<f64>; 5],
    rotation: Matrix3<f64>,
    translation: Vector3<f64>,
}

impl Platform {
    /// Joints of the base in the unit ball, those of the platform in one of radius 0.4, one to two
    /// units apart.
    fn draw(random: &mut Random) -> Self {
        let base: [Vector3<f64>; 6] = from_fn(|_| in_ball(random));
        let joints: [Vector3<f64>; 6] = from_fn(|_| 0.4 * in_ball(random));
        let (rotation, position) = camera(random);
        Self {
            base: from_fn(|k| base[k + 1] - base[0]),
            joints: from_fn(|k| joints[k + 1] - joints[0]),
            rotation,
            translation: 0.5 * position + rotation * joints[0] - base[0],
        }
    }

    /// The base as it moves before the platform.
    fn inverse(&self) -> Self {
        let rotation = self.rotation.transpose();
        Self { base: self.joints, joints: self.base, rotation, translation: -rotation * self.translation }
    }

    /// Platform and base turned, each for itself.
    fn turned(&self, platform: &Matrix3<f64>, base: &Matrix3<f64>) -> Self {
        Self {
            base: self.base.map(|x| base * x),
            joints: self.joints.map(|x| platform * x),
            rotation: base * self.rotation * platform.transpose(),
            translation: base * self.translation,
        }
    }

    /// x s - X t of a leg, with s = R^T t, is (|leg|^2 - |t|^2 - |x|^2 - |X|^2) / 2 + X R x: the
    /// coefficients of s and t.
    fn left(&self) -> SMatrix<f64, 5, 6> {
        SMatrix::from_fn(|k, j| if j < 3 { self.joints[k][j] } else { -self.base[k][j - 3] })
    }

    /// The right side: its coefficients of the entries of R, row by row, and 1.
    fn right(&self) -> SMatrix<f64, 5, 10> {
        SMatrix::from_fn(|k, j| {
            let (x, base) = (self.joints[k], self.base[k]);
            let leg = self.rotation * x + self.translation - base;
            match j {
                9 => {
                    0.5 * (leg.norm_squared()
                        - self.translation.norm_squared()
                        - x.norm_squared()
                        - base.norm_squared())
                }
                _ => base[j / 3] * x[j % 3],
            }
        })
    }
}

/// The null vector of the five equations for s and t, both halves.
fn null_vector(platform: &Platform) -> [Vector3<f64>; 2] {
    let rows: Vec<Vec<f64>> = platform.left().row_iter().map(|row| row.iter().copied().collect()).collect();
    let null = &null_space(&rows)[0];
    [0, 3].map(|at| Vector3::from_row_slice(&null[at..at + 3]))
}

fn known_pose(platform: &Platform) -> KnownInstance {
    let [platform_half, base_half] = null_vector(platform);
    if platform_half.norm() < base_half.norm() {
        return known_pose(&platform.inverse());
    }
    let upright = |half: &Vector3<f64>| {
        Rotation3::rotation_between(half, &Vector3::z()).map_or_else(Matrix3::identity, Rotation3::into_inner)
    };
    let turned = platform.turned(&upright(&platform_half), &upright(&base_half));
    let inverse = turned.left().pseudo_inverse(0.0).expect("the tolerance is not negative");
    // A constant is that times n.
    let quadratics = SMatrix::<f64, 10, 10>::from_fn(|i, j| match i {
        9 => f64::from(u8::from([0, 4, 7, 9].contains(&j))),
        _ => ENTRIES[i][j],
    });
    let solved: SMatrix<f64, 6, 10> = inverse * turned.right() * quadratics;
    let row = |i: usize| solved.row(i).into_owned();
    // s3 = slope t3 + ..
    let slope = platform_half.norm() / base_half.norm();
    let ratio = (slope + 1.0) / (slope - 1.0);
    let shift = (row(2) - slope * row(5)) * (1.0 - ratio);
    let parts = [row(0) + row(3), row(1) + row(4), row(0) - row(3), row(1) - row(4), shift];
    let numbers = [ratio - 2.0, turned.translation.norm_squared()];
    let data = parts.iter().flat_map(|part| part.iter().copied()).chain(numbers).collect();
    KnownInstance { data, truths: vec![cayley(&turned.rotation)] }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Both products of the differences of the third coordinates, with 1 and c, agree at the true
    /// pose, and so do those of the sums.
    #[test]
    fn true_poses_satisfy_the_first_equations() {
        let mut random = Random::new(8);
        for _ in 0..1000 {
            let KnownInstance { data, truths } = known_pose(&Platform::draw(&mut random));
            let [a, b, c] = truths[0][..] else { panic!("three unknowns") };
            let monomials = [1.0, a, b, c, a * a, a * b, a * c, b * b, b * c, c * c];
            let value = |k: usize| data[10 * k..10 * k + 10].iter().zip(monomials).map(|(x, m)| x * m).sum::<f64>();
            let [sum, difference] = [[value(0), value(1)], [value(2), value(3)]];
            let third = b * sum[0] - a * sum[1];
            let both = (2.0 + data[50]) * third + value(4);
            let terms = [
                vec![c * b * sum[0], -c * a * sum[1], a * difference[0], b * difference[1]],
                vec![a * both, -difference[1], -c * sum[0]],
                vec![b * both, difference[0], -c * sum[1]],
            ];
            let spread = terms.iter().flatten().chain(&monomials).fold(value(4).abs(), |size, x| size.max(x.abs()));
            for equation in terms {
                assert!(equation.iter().sum::<f64>().abs() < 1e-9 * spread * (1.0 + data[50].abs()), "{equation:?}");
            }
        }
    }
}
