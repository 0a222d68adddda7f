/// Relative pose of two calibrated cameras from five points: 10 essential matrices.
///
/// The problem `relpose_5pt` from measurements. `first[k]` and `second[k]` are the rays of point k
/// in both cameras, of any length. An essential matrix E satisfies `second[k] . E first[k] = 0`; it
/// is the sum of the matrices that span the null space of these equations, each times its weight.
///
/// A pose X -> rotation X + translation takes the frame of the first camera to that of the second;
/// the translation has the length 1. Of the four poses of an essential matrix it is the one with
/// the first point in front of both cameras: Horn, "Recovering baseline and orientation from
/// essential matrix", 1990. For a solution that belongs to the scene all points are in front.
fn relpose_5pt_rays(first: [[f64; 3]; 5], second: [[f64; 3]; 5]) -> (#[projective] weights: [f64; 4]) {
    let mut rows = [[0; 9]; 5];
    for k in 0..5 {
        for i in 0..3 {
            for j in 0..3 {
                rows[k][3 * i + j] = second[k][i] * first[k][j];
            }
        }
    }
    let basis = reshape(null_space(rows), [4, 3, 3]);
    let [a, b, c, d] = weights;
    let e = a * basis[0] + b * basis[1] + c * basis[2] + d * basis[3];
    det(e) == 0;
    2 * e * e.t() * e - trace(e * e.t()) * e == 0;
    RelativePose {
        #[projective] essential: e,
        rotation: rotation_of(e, first[0], second[0]),
        translation: translation_of(e, first[0], second[0]),
    }
}

const ROOT_2: f64 = 1.4142135623730951;
/// Any vector that no baseline is orthogonal to but by chance.
const REFERENCE: [f64; 3] = [0.48, 0.6, 0.64];

/// E = \[b\] R, with \[b\] the matrix of the cross product by b, has the norm 1: b b^T = 1/2 - E
/// E^T. This is the reference times that.
fn along_baseline(e: [[f64; 3]; 3]) -> [f64; 3] {
    REFERENCE / 2 - e * (e.t() * REFERENCE)
}

fn rotation_of(e: [[f64; 3]; 3], ray: [f64; 3], second: [f64; 3]) -> [[f64; 3]; 3] {
    let along = along_baseline(e);
    rotation_of_baseline(e, ray, second, along[0], along[1], along[2])
}

fn rotation_of_baseline(e: _, ray: [f64; 3], second: [f64; 3], x: f64, y: f64, z: f64) -> [[f64; 3]; 3] {
    let b = of_length(x, y, z);
    let turned = rotation(e, b, 1) * ray;
    rotation(e, b, side(b, second, turned[0], turned[1], turned[2]))
}

fn translation_of(e: [[f64; 3]; 3], ray: [f64; 3], second: [f64; 3]) -> [f64; 3] {
    let along = along_baseline(e);
    translation_of_baseline(e, ray, second, along[0], along[1], along[2])
}

fn translation_of_baseline(e: _, ray: [f64; 3], second: [f64; 3], x: f64, y: f64, z: f64) -> [f64; 3] {
    let b = of_length(x, y, z);
    let turned = rotation(e, b, 1) * ray;
    in_front(b, second, turned[0], turned[1], turned[2])
}

/// The vector along (x, y, z) with the square 1/2, as b has. It keeps more digits than a quotient
/// by the product with the reference, which may be nearly orthogonal to b.
fn of_length(x: f64, y: f64, z: f64) -> [f64; 3] {
    sqrt(1 / (2 * (x * x + y * y + z * z))) * [x, y, z]
}

/// The cofactors of E are b b^T R, and b b^T - 1/2 is the square of \[b\]: the rotation of b, or of
/// -b where `side` is -1.
fn rotation(e: [[f64; 3]; 3], b: [f64; 3], side: f64) -> [[f64; 3]; 3] {
    let cofactors = [cross(e[1], e[2]), cross(e[2], e[0]), cross(e[0], e[1])];
    2 * cofactors - 2 * side * [[0, -b[2], b[1]], [b[2], 0, -b[0]], [-b[1], b[0], 0]] * e
}

/// -1 where the depths of the point have different signs. (x, y, z) is its ray in the first camera,
/// turned by the rotation of b. The depths are in proportion to (second x b) . n and (turned x b) .
/// n, with the normal n = second x turned.
fn side(b: [f64; 3], second: [f64; 3], x: f64, y: f64, z: f64) -> f64 {
    let turned = [x, y, z];
    let normal = cross(second, turned);
    sign(dot(cross(second, b), normal) * dot(cross(turned, b), normal))
}

/// The baseline, of length 1, with the sign for which the point is in front of the first camera,
/// and so of both. The rotation of -b is 4 b b^T - 1 times that of b.
fn in_front(b: [f64; 3], second: [f64; 3], x: f64, y: f64, z: f64) -> [f64; 3] {
    let turned = [x, y, z];
    let s = side(b, second, x, y, z);
    let normal = s * cross(second, turned) + 2 * (1 - s) * dot(b, turned) * cross(second, b);
    sign(-dot(cross(second, b), normal)) * ROOT_2 * b
}

/// 1 or -1.
fn sign(x: f64) -> f64 {
    x * sqrt(1 / (x * x))
}

/// Two cameras that look from about 4 away at points in a cube of side 2, from any sides.
#[scene]
fn scene(
    #[rotation] rotation: [[f64; 3]; 3],
    shift: [f64; 3],
    points: [[f64; 3]; 5],
) -> (Data, RelativePose) {
    let centre = [0, 0, 4];
    let [mut first, mut second] = [points, points];
    for k in 0..5 {
        first[k] = normalise(points[k] + centre);
        second[k] = normalise(rotation * points[k] + centre + shift);
    }
    let translation = normalise(centre + shift - rotation * centre);
    let essential = skew(translation) * rotation;
    (Data { first, second }, RelativePose { essential, rotation, translation })
}
