//! Points on conics and at known distances.

use eliminant_generator::instance::Random;
use nalgebra::Vector3;

use super::cameras::in_ball;
use super::{KnownInstance, Maker, null_space, relative_error};

pub(super) fn makers() -> Vec<Maker> {
    vec![
        Maker {
            name: "trilateration",
            make: distances_to_points,
            error: |_, solution, truth| relative_error(solution, truth),
        },
        Maker {
            name: "two_conics",
            make: conics_through_points,
            error: |_, solution, truth| relative_error(solution, truth),
        },
    ]
}

/// Two conics of the pencil through four points in [-1, 1)^2: they meet in these points and nowhere else.
fn conics_through_points(random: &mut Random) -> KnownInstance {
    let points: Vec<Vec<f64>> = (0..4).map(|_| (0..2).map(|_| random.symmetric_unit()).collect()).collect();
    let rows: Vec<Vec<f64>> =
        points.iter().map(|p| vec![p[0] * p[0], p[0] * p[1], p[1] * p[1], p[0], p[1], 1.0]).collect();
    KnownInstance { data: null_space(&rows).concat(), truths: points }
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
