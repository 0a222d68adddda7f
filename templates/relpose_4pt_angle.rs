/// Relative pose of two calibrated cameras with a known angle of rotation from four point
/// correspondences: 20 solutions.
///
/// Li, Heng, Lee, Pollefeys, "A 4-point algorithm for relative pose estimation of a calibrated
/// camera with a known relative rotation angle", IROS 2013. Published as `relpose_4pt`, with the
/// translation among the unknowns; it is eliminated here as in Martyushev, Li, "Efficient relative
/// pose estimation for cameras and generalized cameras in case of known relative rotation angle",
/// JMIV 62, 2020.
///
/// `first` and `second` hold the rays of the points in either camera, one a row, and `half_angle`
/// the cosine and the sine of half the angle: the rotation from the first camera to the second is
/// that of the unit quaternion cosine + u i + v j + w k. The ratio of the two depths of a point
/// follows from any other point. All polynomials are written p + w q, with p and q in u and v only,
/// and stated with their multiple by w.
///
/// A pose X -> rotation X + translation takes the frame of the first camera to that of the second.
/// The length of the translation is open, and it is of length 1; where the motion is a rotation it
/// is not known. Its sign is the one for which the first point is in front of the first camera.
fn relpose_4pt_angle(first: [[f64; 3]; 4], second: [[f64; 3]; 4], #[unit] half_angle: [f64; 2]) -> (u, v, w) {
    let r = rotation(u, v, half_angle);
    let square = half_angle[1].pow(2) - u * u - v * v;
    for left_out in 0..4 {
        let [i, j, k] = [(left_out + 1) % 4, (left_out + 2) % 4, (left_out + 3) % 4];
        let by_j = depths(r, first[i], second[i], first[j], second[j]);
        let by_k = depths(r, first[i], second[i], first[k], second[k]);
        let [p, q] = product(by_j[0], by_k[1], square) - product(by_j[1], by_k[0], square);
        p + w * q == 0;
        w * p + square * q == 0;
    }
    w * w == square;
    let rotation = r[0] + w * r[1];
    RelativePose { rotation: rotation, translation: translation_of(rotation, first, second) }
}

/// Any weights: combinations of the equations of all points, so that no two points decide.
const MIXTURE: [[f64; 4]; 2] = [[0.9, -0.4, 0.7, 0.3], [0.2, 0.8, -0.5, 0.6]];

/// The translation, of length 1. It is orthogonal to second x rotation first of each point.
fn translation_of(r: [[f64; 3]; 3], first: _, second: _) -> [f64; 3] {
    let mut n = [[0; 3]; 2];
    for k in 0..4 {
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

/// The rotation of cosine + u i + v j + w k as \[P, Q\], of value P + w Q.
fn rotation(u: f64, v: f64, half_angle: [f64; 2]) -> [[[f64; 3]; 3]; 2] {
    let [cosine, sine] = half_angle;
    let cosine_of_angle = cosine * cosine - sine * sine;
    [
        [
            [cosine_of_angle + 2 * u * u, 2 * u * v, 2 * cosine * v],
            [2 * u * v, cosine_of_angle + 2 * v * v, -2 * cosine * u],
            [-2 * cosine * v, 2 * cosine * u, 1 - 2 * (u * u + v * v)],
        ],
        [[0, -2 * cosine, 2 * u], [2 * cosine, 0, 2 * v], [2 * u, 2 * v, 0]],
    ]
}

/// The product of p + w q and r + w s, again of that form.
fn product(a: [f64; 2], b: [f64; 2], square: f64) -> [f64; 2] {
    [a[0] * b[0] + square * a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}

/// The depths of point i in either camera, up to a common factor, by its plane with point j.
fn depths(rotation: _, first_i: [f64; 3], second_i: [f64; 3], first_j: [f64; 3], second_j: [f64; 3]) -> [[f64; 2]; 2] {
    let [first_normal, second_normal] = [cross(first_i, first_j), cross(second_i, second_j)];
    [
        [dot(second_normal, rotation[0] * first_j), dot(second_normal, rotation[1] * first_j)],
        [-dot(second_j, rotation[0] * first_normal), -dot(second_j, rotation[1] * first_normal)],
    ]
}

/// Two cameras that look from about 4 away at points in a cube of side 2, from any sides.
#[scene]
fn scene(#[unit] quaternion: [f64; 4], shift: [f64; 3], points: [[f64; 3]; 4]) -> (Data, RelativePose) {
    let rotation = of_quaternion(quaternion);
    let axis = quaternion[1..4];
    let half_angle = [quaternion[0], norm(axis)];
    let centre = [0, 0, 4];
    let [mut first, mut second] = [points, points];
    for k in 0..4 {
        first[k] = normalise(points[k] + centre);
        second[k] = normalise(rotation * points[k] + centre + shift);
    }
    let translation = normalise(centre + shift - rotation * centre);
    (Data { first, second, half_angle }, RelativePose { rotation, translation })
}

fn of_quaternion(q: [f64; 4]) -> [[f64; 3]; 3] {
    let [w, x, y, z] = q;
    [
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ] / dot(q, q)
}
