/// Relative pose of two generalized cameras with a known angle of rotation from five point
/// correspondences: 44 solutions.
///
/// Martyushev, Li, "Efficient relative pose estimation for cameras and generalized cameras in case
/// of known relative rotation angle", JMIV 62, 2020. Published as `gen5pra`.
///
/// `first` and `second` hold the rays of the points in either system of cameras: a point of the
/// ray, and its direction. `half_angle` holds the cosine and the sine of half the angle: the
/// rotation from the first system to the second is that of the unit quaternion cosine + u i + v j +
/// w k. That the rays of one point meet gives the translation up to the depths of that point along
/// either ray; that the rays of any three others meet, too, are linear equations for these depths.
/// All polynomials are written p + w q, with p and q in u and v only, and stated with their
/// multiple by w.
///
/// A pose X -> rotation X + translation takes the first system to the second, in the unit of the
/// points of the rays.
fn relpose_5pt_generalized_angle(
    first: [[[f64; 3]; 2]; 5],
    second: [[[f64; 3]; 2]; 5],
    #[unit] half_angle: [f64; 2],
) -> (u, v, w) {
    let r = rotation(u, v, half_angle);
    let square = half_angle[1].pow(2) - u * u - v * v;
    for left_out in 0..5 {
        let [i, j, k, l] = [(left_out + 1) % 5, (left_out + 2) % 5, (left_out + 3) % 5, (left_out + 4) % 5];
        let a = meet(r, first[i], second[i], first[j], second[j]);
        let b = meet(r, first[i], second[i], first[k], second[k]);
        let c = meet(r, first[i], second[i], first[l], second[l]);
        let [p, q] = determinant(a, b, c, square);
        p + w * q == 0;
        w * p + square * q == 0;
    }
    w * w == square;
    let rotation = r[0] + w * r[1];
    let n = equations_of_translation(rotation, first, second);
    Pose { rotation: rotation, translation: solved(n)[0..3] / solved(n)[3] }
}

/// Any weights: combinations of the equations of all points, so that no three points decide.
const MIXTURE: [[f64; 5]; 3] = [[0.9, -0.4, 0.7, 0.3, -0.8], [0.2, 0.8, -0.5, 0.9, 0.4], [-0.6, 0.5, 0.3, -0.7, 0.9]];

/// Equations for the translation by which the rays meet: for each point
/// n . (rotation p1 + translation - p2) = 0, with points p1 and p2 of its rays, and n orthogonal to
/// both.
fn equations_of_translation(r: [[f64; 3]; 3], first: _, second: _) -> [[f64; 4]; 3] {
    let mut n = [[0; 4]; 3];
    for k in 0..5 {
        let normal = cross(r * first[k][1], second[k][1]);
        let equation = concat(normal, [dot(normal, second[k][0] - r * first[k][0])]);
        for i in 0..3 {
            n[i] += MIXTURE[i][k] * equation;
        }
    }
    n
}

/// Three linear equations: n[k][0..3] . x = n[k][3]. The solution times the determinant, and behind
/// it the determinant, by Cramer's rule.
fn solved(n: [[f64; 4]; 3]) -> [f64; 4] {
    by_cramers_rule(
        n[0][0], n[0][1], n[0][2], n[0][3], n[1][0], n[1][1], n[1][2], n[1][3], n[2][0], n[2][1], n[2][2], n[2][3],
    )
}

fn by_cramers_rule(
    a: f64,
    b: f64,
    c: f64,
    x: f64,
    d: f64,
    e: f64,
    f: f64,
    y: f64,
    g: f64,
    h: f64,
    i: f64,
    z: f64,
) -> [f64; 4] {
    let [p, q, r] = [cross([d, e, f], [g, h, i]), cross([g, h, i], [a, b, c]), cross([a, b, c], [d, e, f])];
    concat(x * p + y * q + z * r, [dot([a, b, c], p)])
}

/// The rays of point j meet where those of point i do: the coefficients of the depths of point i in
/// the first and in the second system, and of 1.
fn meet(r: [[[f64; 3]; 3]; 2], first_i: _, second_i: _, first_j: _, second_j: _) -> [[f64; 2]; 3] {
    let [point, direction] = [first_j[0] - first_i[0], first_j[1]];
    let [second_point, second_direction] = [second_j[0] - second_i[0], second_j[1]];
    let constant = cross(second_direction, second_point);
    [
        bilinear(r, second_direction, cross(direction, first_i[1])),
        bilinear(r, cross(second_i[1], second_direction), direction),
        bilinear(r, second_direction, cross(direction, point)) + bilinear(r, constant, direction),
    ]
}

fn bilinear(r: [[[f64; 3]; 3]; 2], a: [f64; 3], b: [f64; 3]) -> [f64; 2] {
    [dot(a, r[0] * b), dot(a, r[1] * b)]
}

fn determinant(a: [[f64; 2]; 3], b: [[f64; 2]; 3], c: [[f64; 2]; 3], square: f64) -> [f64; 2] {
    product(a[0], product(b[1], c[2], square) - product(b[2], c[1], square), square)
        + product(a[1], product(b[2], c[0], square) - product(b[0], c[2], square), square)
        + product(a[2], product(b[0], c[1], square) - product(b[1], c[0], square), square)
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

/// Two systems of cameras within a cube of side 1 that look at points in a cube of side 2, about 4
/// away.
#[scene]
fn scene(
    #[unit] quaternion: [f64; 4],
    shift: [f64; 3],
    centres: [[[f64; 3]; 2]; 5],
    points: [[f64; 3]; 5],
) -> (Data, Pose) {
    let rotation = of_quaternion(quaternion);
    let half_angle = [quaternion[0], norm(quaternion[1..4])];
    let from = [0, 0, 4];
    let translation = shift + from - rotation * from;
    let [mut first, mut second] = [centres, centres];
    for k in 0..5 {
        let point = points[k] + from;
        let [a, b] = centres[k] / 2;
        first[k] = [a, normalise(point - a)];
        second[k] = [b, normalise(rotation * point + translation - b)];
    }
    (Data { first, second, half_angle }, Pose { rotation, translation })
}

fn of_quaternion(q: [f64; 4]) -> [[f64; 3]; 3] {
    let [w, x, y, z] = q;
    [
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ] / dot(q, q)
}
