//! Positions of receivers, and of senders, from what receivers measure of senders.

use std::array::from_fn;

use eliminant_generator::algebra::Random;
use nalgebra::{Matrix3, RowSVector, SMatrix, Vector3};

use super::cameras::in_ball;
use super::{KnownInstance, Make, Maker, coordinates, projective_error, relative_error, vector};

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

/// Senders and receivers in the unit ball. The solver takes its pick of which sender is the first
/// and which the last: that with the smallest combinations.
fn six_receivers(random: &mut Random) -> KnownInstance {
    let senders: [Vector3<f64>; 4] = from_fn(|_| in_ball(random));
    let receivers: [Vector3<f64>; 6] = from_fn(|_| in_ball(random));
    let orders = (0..4).flat_map(|first| (1..4).map(move |last| (first, last)));
    let choices = orders.map(|(first, last)| {
        let mut senders = senders;
        senders.swap(0, first);
        senders.swap(3, last);
        (combinations(&senders, &receivers).map(|x| 1.0 + x * x).product(), senders)
    });
    let (_, chosen) = choices.min_by(|(a, _), (b, _)| a.total_cmp(b)).expect("one of 12");
    let [origin, others @ ..] = chosen;
    let others = others.map(|sender| sender - origin);
    let gram = Matrix3::from_fn(|i, j| others[i].dot(&others[j]));
    let k = gram.try_inverse().expect("the senders are in general position");
    let truth = vec![k[(0, 1)], k[(0, 2)], k[(1, 2)], k[(2, 2)], k.determinant()];
    let ranges = receivers.iter().flat_map(|receiver| senders.map(|sender| (receiver - sender).norm()));
    KnownInstance { data: ranges.collect(), truths: vec![truth] }
}

/// 4 r = c K c + 2 c g + a for every receiver, solved for k11, k22, g and a.
fn combinations(senders: &[Vector3<f64>; 4], receivers: &[Vector3<f64>; 6]) -> SMatrix<f64, 6, 5> {
    let (mut left, mut right) = (SMatrix::<f64, 6, 6>::zeros(), SMatrix::<f64, 6, 5>::zeros());
    for (k, receiver) in receivers.iter().enumerate() {
        let [square, others @ ..] = senders.map(|sender| (receiver - sender).norm_squared());
        let [c1, c2, c3] = others.map(|other| square - other);
        left.set_row(k, &RowSVector::from([c1 * c1, c2 * c2, 2.0 * c1, 2.0 * c2, 2.0 * c3, 1.0]));
        let mixed = [-2.0 * c1 * c2, -2.0 * c1 * c3, -2.0 * c2 * c3, -c3 * c3, 4.0 * square];
        right.set_row(k, &RowSVector::from(mixed));
    }
    left.lu().solve(&right).expect("the receivers are in general position")
}

/// Senders and receivers in the unit ball, and the differences of ranges that the cosines of the
/// angles at the receivers stand for.
fn two_receivers(random: &mut Random) -> KnownInstance {
    let (centre, direction) = (in_ball(random), in_ball(random));
    let senders: [Vector3<f64>; 5] = from_fn(|_| in_ball(random));
    let distance = direction.norm();
    let differences = senders.map(|sender| direction.dot(&(sender - centre).normalize()));
    let data: Vec<f64> = senders.iter().flat_map(|x| x.data.0[0]).chain(differences).chain([distance]).collect();
    let unit = senders.iter().map(Vector3::norm_squared).sum::<f64>().sqrt();
    let truth = coordinates(&[direction.x, direction.y, direction.z, direction.dot(&centre) / unit]);
    KnownInstance { data, truths: vec![truth] }
}
