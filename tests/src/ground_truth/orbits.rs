//! Orbits around the origin from lines of sight.

use std::f64::consts::PI;

use eliminant_generator::algebra::Random;
use nalgebra::{Rotation3, Vector3};

use super::cameras::in_ball;
use super::{KnownInstance, Make, Maker, relative_error, uniform};

pub(super) fn makers() -> Vec<Maker> {
    vec![Maker {
        name: "orbit_5_lines_of_sight",
        make: Make::Scene(five_sights),
        error: |_, solution, truth| relative_error(solution, truth),
    }]
}

/// Five points of an ellipse of eccentricity up to 0.6, seen from the unit circle around the Sun in
/// the plane of the first two axes.
fn five_sights(random: &mut Random) -> KnownInstance {
    let normal = loop {
        let normal = in_ball(random).normalize();
        if normal.z.abs() > 0.1 {
            break normal;
        }
    };
    let (parameter, eccentricity) = (uniform(random, 0.5, 2.0), uniform(random, 0.0, 0.6));
    let pericentre = normal.cross(&in_ball(random)).normalize();
    let mut data = Vec::new();
    for _ in 0..5 {
        let (anomaly, season) = (uniform(random, -PI, PI), uniform(random, -PI, PI));
        let distance = parameter / (1.0 + eccentricity * anomaly.cos());
        let axis = nalgebra::Unit::new_normalize(normal);
        let body = Rotation3::from_axis_angle(&axis, anomaly) * pericentre * distance;
        let observer = Vector3::new(season.cos(), season.sin(), 0.0);
        data.extend([observer, (body - observer).normalize()].iter().flat_map(|v| v.data.0[0]));
    }
    let n = normal / normal.z;
    // n x (p, q, 0) is n x e / h for the vector e towards the pericentre.
    let e = pericentre * (eccentricity / parameter);
    let [p, q] = [e.x - e.z * n.x, e.y - e.z * n.y];
    KnownInstance { data, truths: vec![vec![n.x, n.y, p, q, n.x * q - n.y * p, parameter.powi(-2)]] }
}
