/// Relative pose of two cameras with one unknown shared focal length from six points: 15 solutions,
/// of which those with a real focal length are returned.
///
/// The problem `relpose_6pt_focal` from measurements. `first[k]` and `second[k]` are the images of
/// point k, relative to the principal points. The fundamental matrix is the sum of the matrices
/// that span the null space of the epipolar equations, each times its weight. w is 1 / focal^2 in
/// units of the length of all images.
///
/// A pose X -> rotation X + translation takes the frame of the first camera to that of the second;
/// the translation has the length 1. Of the four poses of an essential matrix it is the one with
/// the first point in front of both cameras, as in `relpose_5pt_rays`. For a solution that belongs
/// to the scene all points are in front.
fn relpose_6pt_focal_points(first: [[f64; 2]; 6], second: [[f64; 2]; 6]) -> (#[projective] weights: [f64; 3], w) {
    // In units in which images are about 1, so that all entries of the matrix keep their digits.
    let unit = norm([first, second]);
    let mut rows = [[0; 9]; 6];
    for k in 0..6 {
        let [x, y] = [[first[k][0], first[k][1], unit], [second[k][0], second[k][1], unit]];
        for i in 0..3 {
            for j in 0..3 {
                rows[k][3 * i + j] = y[i] * x[j];
            }
        }
    }
    let basis = reshape(null_space(rows), [3, 3, 3]);
    let f = weights[0] * basis[0] + weights[1] * basis[1] + weights[2] * basis[2];
    let omega = [[1, 0, 0], [0, 1, 0], [0, 0, w]];
    let left = f * omega * f.t() * omega;
    det(f) == 0;
    2 * left * f - trace(left) * f == 0;
    w > 0;
    let to_unit = [[1, 0, 0], [0, 1, 0], [0, 0, unit]];
    let [x, y] = [[first[0][0], first[0][1], unit], [second[0][0], second[0][1], unit]];
    FocalPose {
        #[projective] fundamental: to_unit * f * to_unit,
        focal: sqrt(unit * unit / w),
        rotation: rotation_of(f, x, y, sqrt(w)) / square_of_baseline(essential(f, sqrt(w))),
        translation: translation_of(f, x, y, sqrt(w)),
    }
}

/// Any vector that no baseline is orthogonal to but by chance.
const REFERENCE: [f64; 3] = [0.48, 0.6, 0.64];

/// The essential matrix, and the ray of an image; `scale` is 1 / focal.
fn essential(f: [[f64; 3]; 3], scale: f64) -> [[f64; 3]; 3] {
    let calibration = [[1, 0, 0], [0, 1, 0], [0, 0, scale]];
    calibration * f * calibration
}

fn ray(image: [f64; 3], scale: f64) -> [f64; 3] {
    [scale * image[0], scale * image[1], image[2]]
}

/// E = \[b\] R, with \[b\] the matrix of the cross product by b: b . b is half the square of its
/// norm.
fn square_of_baseline(e: [[f64; 3]; 3]) -> f64 {
    (dot(e[0], e[0]) + dot(e[1], e[1]) + dot(e[2], e[2])) / 2
}

/// b b^T = b . b - E E^T; this is the reference times that.
fn along_baseline(f: [[f64; 3]; 3], scale: f64) -> [f64; 3] {
    let e = essential(f, scale);
    square_of_baseline(e) * REFERENCE - e * (e.t() * REFERENCE)
}

fn rotation_of(f: [[f64; 3]; 3], x: [f64; 3], y: [f64; 3], scale: f64) -> [[f64; 3]; 3] {
    let along = along_baseline(f, scale);
    let e = essential(f, scale);
    let [x, y] = [ray(x, scale), ray(y, scale)];
    rotation_of_baseline(e, x, y, along[0], along[1], along[2])
}

fn rotation_of_baseline(e: _, x: [f64; 3], y: [f64; 3], b1: f64, b2: f64, b3: f64) -> [[f64; 3]; 3] {
    let b = of_length(e, b1, b2, b3);
    let turned = rotation(e, b, 1) * x;
    rotation(e, b, side(b, y, turned[0], turned[1], turned[2]))
}

fn translation_of(f: [[f64; 3]; 3], x: [f64; 3], y: [f64; 3], scale: f64) -> [f64; 3] {
    let along = along_baseline(f, scale);
    let e = essential(f, scale);
    let [x, y] = [ray(x, scale), ray(y, scale)];
    translation_of_baseline(e, x, y, along[0], along[1], along[2])
}

fn translation_of_baseline(e: _, x: [f64; 3], y: [f64; 3], b1: f64, b2: f64, b3: f64) -> [f64; 3] {
    let b = of_length(e, b1, b2, b3);
    let turned = rotation(e, b, 1) * x;
    in_front(b, y, turned[0], turned[1], turned[2])
}

/// The vector along (x, y, z) of the length of b. It keeps more digits than a quotient by the
/// product with the reference, which may be nearly orthogonal to b.
fn of_length(e: [[f64; 3]; 3], x: f64, y: f64, z: f64) -> [f64; 3] {
    sqrt(square_of_baseline(e) / (x * x + y * y + z * z)) * [x, y, z]
}

/// b . b times the rotation of b, or of -b where `side` is -1: the cofactors of E are b b^T R, and
/// b b^T - b . b is the square of \[b\].
fn rotation(e: [[f64; 3]; 3], b: [f64; 3], side: f64) -> [[f64; 3]; 3] {
    let cofactors = [cross(e[1], e[2]), cross(e[2], e[0]), cross(e[0], e[1])];
    cofactors - side * [[0, -b[2], b[1]], [b[2], 0, -b[0]], [-b[1], b[0], 0]] * e
}

/// -1 where the depths of the point have different signs. (x, y, z) is in proportion to its ray in
/// the first camera, turned by the rotation of b. The depths are in proportion to (second x b) . n
/// and (turned x b) . n, with the normal n = second x turned.
fn side(b: [f64; 3], second: [f64; 3], x: f64, y: f64, z: f64) -> f64 {
    let turned = [x, y, z];
    let normal = cross(second, turned);
    sign(dot(cross(second, b), normal) * dot(cross(turned, b), normal))
}

/// The baseline, of length 1, with the sign for which the point is in front of the first camera,
/// and so of both. The rotation of -b is 2 b b^T / b . b - 1 times that of b.
fn in_front(b: [f64; 3], second: [f64; 3], x: f64, y: f64, z: f64) -> [f64; 3] {
    let turned = [x, y, z];
    let s = side(b, second, x, y, z);
    let normal = s * dot(b, b) * cross(second, turned) + (1 - s) * dot(b, turned) * cross(second, b);
    along(b, -dot(cross(second, b), normal))
}

/// 1 or -1.
fn sign(x: f64) -> f64 {
    x * sqrt(1 / (x * x))
}

/// The vector of length 1 along b if x is positive, else along -b.
fn along(b: [f64; 3], x: f64) -> [f64; 3] {
    x * sqrt(1 / (x * x * dot(b, b))) * b
}

/// Two cameras that look from about 4 away at points in a cube of side 2, from any sides.
#[scene]
fn scene(
    #[rotation] rotation: [[f64; 3]; 3],
    shift: [f64; 3],
    zoom: f64,
    points: [[f64; 3]; 6],
) -> (Data, FocalPose) {
    let centre = [0, 0, 4];
    let focal = 3 / 2 + zoom / 2;
    let [mut first, mut second] = [[[0; 2]; 6], [[0; 2]; 6]];
    for k in 0..6 {
        let [x, y, depth] = points[k] + centre;
        first[k] = focal * [x, y] / depth;
        let [x, y, depth] = rotation * points[k] + centre + shift;
        second[k] = focal * [x, y] / depth;
    }
    let translation = normalise(centre + shift - rotation * centre);
    let inverse_calibration = [[1, 0, 0], [0, 1, 0], [0, 0, focal]];
    let fundamental = inverse_calibration * skew(translation) * rotation * inverse_calibration;
    (Data { first, second }, FocalPose { fundamental, focal, rotation, translation })
}
