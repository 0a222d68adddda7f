//! Positions of receivers from what they measure of senders.

use eliminant_generator::instance::Random;
use nalgebra::{RowSVector, SMatrix, Vector3};

use super::cameras::in_ball;
use super::{KnownInstance, Maker, null_space, relative_error};

pub(super) fn makers() -> Vec<Maker> {
    vec![Maker {
        name: "pose_5tdoa_two_receivers",
        make: two_receivers,
        error: |_, solution, truth| relative_error(solution, truth),
    }]
}

/// Senders and receivers in the unit ball: the cosines c of the angles at the receivers, and from them, with t = n C, the coefficients of
/// c^2 |n|^2 |C|^2 - 2 c^2 |n|^2 U C = (n U)^2 - 2 t n U + t^2 - c^2 |n|^2 |U|^2 for five senders U: solved for what stands on the left, and without it.
fn two_receivers(random: &mut Random) -> KnownInstance {
    let (centre, direction) = (in_ball(random), in_ball(random));
    let (mut left, mut right) = (SMatrix::<f64, 5, 4>::zeros(), SMatrix::<f64, 5, 10>::zeros());
    for k in 0..5 {
        let sender = in_ball(random);
        let sight: Vector3<f64> = sender - centre;
        let square = (direction.dot(&sight) / (direction.norm() * sight.norm())).powi(2);
        let along = -2.0 * square * sender;
        left.set_row(k, &RowSVector::from_row_slice(&[square, along.x, along.y, along.z]));
        let (x, y, z) = (sender.x, sender.y, sender.z);
        let far = square * sender.norm_squared();
        let products = [x * x - far, 2.0 * x * y, 2.0 * x * z, y * y - far, 2.0 * y * z, z * z - far];
        right.set_row(k, &RowSVector::from_row_slice(&[&products[..], &[-2.0 * x, -2.0 * y, -2.0 * z, 1.0]].concat()));
    }
    let columns: Vec<Vec<f64>> = left.column_iter().map(|column| column.iter().copied().collect()).collect();
    let without = &null_space(&columns)[0];
    let quadric = (SMatrix::<f64, 1, 5>::from_row_slice(without) * right).normalize();
    let linear = left.pseudo_inverse(0.0).expect("the tolerance is not negative") * right;
    let data = quadric.iter().chain(linear.transpose().iter()).copied().collect();
    let n = direction / direction.z;
    KnownInstance { data, truths: vec![vec![n.x, n.y, n.dot(&centre)]] }
}
