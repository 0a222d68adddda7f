//! Positions of receivers, and of senders, from what receivers measure of senders.

use std::array::from_fn;

use eliminant_generator::algebra::Random;
use nalgebra::{Matrix3, RowSVector, SMatrix, Vector3};

use super::cameras::in_ball;
use super::{KnownInstance, Make, Maker, coordinates, null_space, projective_error, relative_error, vector};

pub(super) fn makers() -> Vec<Maker> {
    vec![
        Maker {
            name: "calibration_6_receivers_4_senders",
            make: Make::Scene(six_receivers),
            error: |_, solution, truth| relative_error(solution, truth),
        },
        Maker {
            name: "pose_5tdoa_two_receivers",
            make: Make::Scene(two_receivers),
            error: |_, solution, truth| projective_error(&vector(solution), &vector(truth)),
        },
    ]
}

/// Senders and receivers in the unit ball. Which sender is the first and which the last is free,
/// but not every choice determines what the receivers are solved for well: the one with the
/// smallest data is taken.
fn six_receivers(random: &mut Random) -> KnownInstance {
    let senders: [Vector3<f64>; 4] = from_fn(|_| in_ball(random));
    let receivers: [Vector3<f64>; 6] = from_fn(|_| in_ball(random));
    let orders = (0..4).flat_map(|first| (1..4).map(move |last| (first, last)));
    let choices = orders.map(|(first, last)| {
        let mut senders = senders;
        senders.swap(0, first);
        senders.swap(3, last);
        ranges(&senders, &receivers)
    });
    let size = |instance: &KnownInstance| instance.data.iter().map(|x| x.abs().ln_1p()).sum::<f64>();
    choices.min_by(|a, b| size(a).total_cmp(&size(b))).expect("one of 12")
}

/// 4 r = c K c + 2 c g + a for every receiver, solved for k11, k22, g and a.
fn ranges(senders: &[Vector3<f64>; 4], receivers: &[Vector3<f64>; 6]) -> KnownInstance {
    let [origin, senders @ ..] = senders;
    let senders = senders.map(|sender| sender - origin);
    let (mut left, mut right) = (SMatrix::<f64, 6, 6>::zeros(), SMatrix::<f64, 6, 5>::zeros());
    for (k, receiver) in receivers.iter().enumerate() {
        let receiver = receiver - origin;
        let square = receiver.norm_squared();
        let [c1, c2, c3] = senders.map(|sender| square - (receiver - sender).norm_squared());
        left.set_row(k, &RowSVector::from([c1 * c1, c2 * c2, 2.0 * c1, 2.0 * c2, 2.0 * c3, 1.0]));
        let mixed = [-2.0 * c1 * c2, -2.0 * c1 * c3, -2.0 * c2 * c3, -c3 * c3, 4.0 * square];
        right.set_row(k, &RowSVector::from(mixed));
    }
    let linear = left.lu().solve(&right).expect("the receivers are in general position");
    let gram = Matrix3::from_fn(|i, j| senders[i].dot(&senders[j]));
    let k = gram.try_inverse().expect("the senders are in general position");
    let truth = vec![k[(0, 1)], k[(0, 2)], k[(1, 2)], k[(2, 2)], k.determinant()];
    KnownInstance { data: linear.transpose().iter().copied().collect(), truths: vec![truth] }
}

/// Senders and receivers in the unit ball: the cosines c of the angles at the receivers, and from
/// them, with t = n C, the coefficients of c^2 |n|^2 |C|^2 - 2 c^2 |n|^2 U C = (n U)^2 - 2 t n U +
/// t^2 - c^2 |n|^2 |U|^2 for five senders U: solved for what stands on the left, and without it.
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
    let truth = coordinates(&[direction.x, direction.y, direction.z, direction.dot(&centre)]);
    KnownInstance { data, truths: vec![truth] }
}
