/// Relative pose of two cameras whose vertical is known, as by an inertial sensor, from three
/// points: 4 solutions.
///
/// Fraundorfer, Tanskanen, Pollefeys, "A minimal case solution to the calibrated relative pose
/// problem for the case of two known orientation angles", ECCV 2010.
///
/// `first[k]` and `second[k]` are the rays of point k in frames of the cameras whose y axes are
/// vertical, of any length. The unknowns are cosine and sine of the turn about the vertical.
///
/// A pose X -> rotation X + translation takes the frame of the first camera to that of the second.
/// The length of the translation is open, and it is of length 1; where the motion is a rotation it
/// is not known. Its sign is the one for which the first point is in front of the first camera.
fn relpose_3pt_upright(first: [[f64; 3]; 3], second: [[f64; 3]; 3]) -> (c, s) {
    let rotation = [[c, 0, s], [0, 1, 0], [-s, 0, c]];
    let normals = [
        cross(second[0], rotation * first[0]),
        cross(second[1], rotation * first[1]),
        cross(second[2], rotation * first[2]),
    ];
    c * c + s * s == 1;
    det(normals) == 0;
    RelativePose { rotation: rotation, translation: translation_of(rotation, first, second) }
}

/// Any weights: combinations of the equations of all points, so that no two points decide.
const MIXTURE: [[f64; 3]; 2] = [[0.9, -0.4, 0.7], [0.2, 0.8, -0.5]];

/// The translation, of length 1. It is orthogonal to second x rotation first of each point.
fn translation_of(r: [[f64; 3]; 3], first: _, second: _) -> [f64; 3] {
    let mut n = [[0; 3]; 2];
    for k in 0..3 {
        for i in 0..2 {
            n[i] += MIXTURE[i][k] * cross(second[k], r * first[k]);
        }
    }
    let turned = r * first[0];
    in_front(second[0], turned[0], turned[1], turned[2], n[0][0], n[0][1], n[0][2], n[1][0], n[1][1], n[1][2])
}

/// The vector orthogonal to (a, b, c) and (d, e, f), with the sign for which the first point is in
/// front of the first camera: its depth is in proportion to -(second x t) . (second x turned),
/// where (x, y, z) is its turned ray.
fn in_front(second: _, x: f64, y: f64, z: f64, a: f64, b: f64, c: f64, d: f64, e: f64, f: f64) -> [f64; 3] {
    let t = cross([a, b, c], [d, e, f]);
    sign(-dot(cross(second, t), cross(second, [x, y, z]))) * sqrt(1 / dot(t, t)) * t
}

/// 1 or -1.
fn sign(x: f64) -> f64 {
    x * sqrt(1 / (x * x))
}

/// Two cameras that look from about 4 away at points in a cube of side 2, from any sides.
#[scene]
fn scene(#[unit] turn: [f64; 2], shift: [f64; 3], points: [[f64; 3]; 3]) -> (Data, RelativePose) {
    let [c, s] = turn;
    let rotation = [[c, 0, s], [0, 1, 0], [-s, 0, c]];
    let centre = [0, 0, 4];
    let [mut first, mut second] = [points, points];
    for k in 0..3 {
        first[k] = normalise(points[k] + centre);
        second[k] = normalise(rotation * points[k] + centre + shift);
    }
    let translation = normalise(centre + shift - rotation * centre);
    (Data { first, second }, RelativePose { rotation, translation })
}
