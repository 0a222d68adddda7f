/// Keplerian orbit from five lines of sight without times: 66 solutions.
///
/// Mancini, Duff, Leykin, Christian, "Geometric solution to the angles-only initial orbit
/// determination problem", 2023; Huang, Leykin, Mancini, "Projective plane subdivision method for
/// initial orbit determination", arXiv 2509.14397, 2025. Published as `IOD`.
///
/// `sights` holds for each line the position of the observer and the direction; the Sun is the
/// origin. The plane of the orbit has the normal n = (a, b, 1). It meets the line with direction d
/// and moment m in x = n x m / n.d. The orbit is |x| = h - e.x, where e points to the pericentre
/// and has the eccentricity as its length. With w = n x e / h = (-q, p, r), where (p, q, 0) is e /
/// h up to a multiple of n, this is (n.d + w.m)^2 = |n x m|^2 / h^2, and `square` is 1 / h^2. The
/// published unknowns are the entries of the orbit's dual quadric.
///
/// Returned are the normal of the plane, of length 1, e and h, which is the semi-latus rectum.
///
/// With directions and moments exchanged these are the cylinders that touch five lines: n is the
/// direction of the axis, w its moment, and `square` that of the radius.
fn orbit_5_lines_of_sight(sights: [[[f64; 3]; 2]; 5]) -> (a, b, p, q, r, square) {
    let n = [a, b, 1];
    let w = [-q, p, r];
    dot(n, w) == 0;
    for [observer, direction] in sights {
        let moment = cross(observer, direction);
        let root = dot(direction, n) + dot(moment, w);
        let distance = cross(n, moment);
        root * root == square * dot(distance, distance);
    }
    let shape = [p, q, 0];
    Orbit {
        normal: n / sqrt(dot(n, n)),
        eccentricity: sqrt(1 / square) * (shape - dot(n, shape) / dot(n, n) * n),
        semi_latus_rectum: sqrt(1 / square),
    }
}

/// Five points of an ellipse, seen from the unit circle around the Sun in the plane of the first
/// two axes.
#[scene]
fn scene(
    #[unit] normal: [f64; 3],
    towards: [f64; 3],
    size: f64,
    bodies: [[f64; 3]; 5],
    #[unit] seasons: [[f64; 2]; 5],
) -> (Data, Orbit) {
    normal[2] > 1 / 10;
    let eccentricity = cross(normal, towards) / 3;
    let semi_latus_rectum = 5 / 4 + 3 * size / 4;
    let mut sights = [[[0; 3]; 2]; 5];
    for k in 0..5 {
        let observer = concat(seasons[k], 0);
        let direction = normalise(cross(normal, bodies[k]));
        let body = semi_latus_rectum / (1 + dot(eccentricity, direction)) * direction;
        sights[k] = [observer, normalise(body - observer)];
    }
    (Data { sights }, Orbit { normal, eccentricity, semi_latus_rectum })
}
