/// Relative pose of two generalized cameras from six point correspondences: 64 solutions.
///
/// Stewénius, Nistér, Oskarsson, Åström, "Solutions to minimal generalized relative pose problems",
/// OMNIVIS 2005. Published as `gen6p`.
///
/// `first` and `second` hold the rays of the points in either system of cameras: a point of the
/// ray, and its direction. The rotation from the first system to the second is that of the
/// quaternion q. That the rays of one point meet gives the translation up to the
/// depths of that point along either ray; that the rays of any three others meet, too, are linear
/// equations for these depths.
///
/// A pose X -> rotation X + translation takes the first system to the second, in the unit of the
/// points of the rays.
fn relpose_6pt_generalized(first: [[[f64; 3]; 2]; 6], second: [[[f64; 3]; 2]; 6]) -> (#[projective] q: [f64; 4]) {
    let r = rotation(q);
    for i in 0..3 {
        for j in i + 1..4 {
            for k in j + 1..5 {
                for l in k + 1..6 {
                    let by_j = meet(r, first[i], second[i], first[j], second[j]);
                    let by_k = meet(r, first[i], second[i], first[k], second[k]);
                    let by_l = meet(r, first[i], second[i], first[l], second[l]);
                    det([by_j, by_k, by_l]) == 0;
                }
            }
        }
    }
    let n = equations_of_translation(r, first, second);
    Pose { rotation: r, translation: solved(n)[0..3] / solved(n)[3] }
}

/// Any weights: combinations of the equations of all points, so that no three points decide.
const MIXTURE: [[f64; 6]; 3] = [
    [0.9, -0.4, 0.7, 0.3, -0.8, 0.5],
    [0.2, 0.8, -0.5, 0.9, 0.4, -0.7],
    [-0.6, 0.5, 0.3, -0.7, 0.9, 0.8],
];

/// Equations for the translation by which the rays meet: for each point
/// n . (rotation p1 + translation - p2) = 0, with points p1 and p2 of its rays, and n orthogonal to
/// both.
fn equations_of_translation(r: [[f64; 3]; 3], first: _, second: _) -> [[f64; 4]; 3] {
    let mut n = [[0; 4]; 3];
    for k in 0..6 {
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
    a: f64, b: f64, c: f64, x: f64, d: f64, e: f64, f: f64, y: f64, g: f64, h: f64, i: f64, z: f64,
) -> [f64; 4] {
    let [p, q, r] = [cross([d, e, f], [g, h, i]), cross([g, h, i], [a, b, c]), cross([a, b, c], [d, e, f])];
    concat(x * p + y * q + z * r, [dot([a, b, c], p)])
}

/// The rays of point j meet where those of point i do: the coefficients of the depths of point i in
/// the first and in the second system, and of 1.
fn meet(r: [[f64; 3]; 3], first_i: _, second_i: _, first_j: _, second_j: _) -> [f64; 3] {
    let [point, direction] = [first_j[0] - first_i[0], first_j[1]];
    let [second_point, second_direction] = [second_j[0] - second_i[0], second_j[1]];
    [
        dot(second_direction, r * cross(direction, first_i[1])),
        dot(cross(second_i[1], second_direction), r * direction),
        dot(second_direction, r * cross(direction, point)) + dot(cross(second_direction, second_point), r * direction),
    ]
}

/// |q|^2 times the rotation of the quaternion q.
fn rotation(q: [f64; 4]) -> [[f64; 3]; 3] {
    let [w, x, y, z] = q;
    [
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ]
}

/// Two systems of cameras within a cube of side 1 that look at points in a cube of side 2, about 4
/// away.
#[scene]
fn scene(
    #[rotation] rotation: [[f64; 3]; 3],
    shift: [f64; 3],
    centres: [[[f64; 3]; 2]; 6],
    points: [[f64; 3]; 6],
) -> (Data, Pose) {
    let from = [0, 0, 4];
    let translation = shift + from - rotation * from;
    let [mut first, mut second] = [centres, centres];
    for k in 0..6 {
        let point = points[k] + from;
        let [a, b] = centres[k] / 2;
        first[k] = [a, normalise(point - a)];
        second[k] = [b, normalise(rotation * point + translation - b)];
    }
    (Data { first, second }, Pose { rotation, translation })
}
