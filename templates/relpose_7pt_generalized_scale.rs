/// Relative pose and relative scale of two generalized cameras from seven point correspondences:
/// 140 solutions.
///
/// Kneip, Sweeney, Hartley, "The generalized relative pose and scale problem: View-graph fusion via
/// 2D-2D registration", WACV 2016. Published as `gen_relpose_scale`.
///
/// `first` and `second` hold the rays of the points in either system of cameras: a point of the
/// ray, and its direction. The rotation from the first system to the second is that of the
/// quaternion q, and points of the second system are multiplied by its scale.
/// That the rays of one point meet gives the translation up to the depths of that point along
/// either ray and the scale; that the rays of any four others meet, too, are linear equations for
/// these three. What is stated depends on these five points, not on which is the first.
///
/// For a point of the rays, rotation p1 + translation = scale p2, with p1 in the first system and
/// p2 in the second.
fn relpose_7pt_generalized_scale(first: [[[f64; 3]; 2]; 7], second: [[[f64; 3]; 2]; 7]) -> (#[projective] q: [f64; 4]) {
    let r = rotation(q);
    for i in 0..3 {
        for j in i + 1..4 {
            for k in j + 1..5 {
                for l in k + 1..6 {
                    for m in l + 1..7 {
                        det([
                            meet(r, first[i], second[i], first[j], second[j]),
                            meet(r, first[i], second[i], first[k], second[k]),
                            meet(r, first[i], second[i], first[l], second[l]),
                            meet(r, first[i], second[i], first[m], second[m]),
                        ]) == 0;
                    }
                }
            }
        }
    }
    let mut n = [[0; 4]; 3];
    for k in 0..6 {
        let met = meet(r, first[0], second[0], first[k + 1], second[k + 1]);
        for i in 0..3 {
            n[i] += MIXTURE[i][k] * [met[0], met[1], met[2], -met[3]];
        }
    }
    ScaledPose {
        rotation: r,
        translation: translation_of(r, first[0], second[0], n) / solved(n)[3],
        scale: solved(n)[2] / solved(n)[3],
    }
}

/// Any weights: combinations of the equations of all points, so that no four points decide.
const MIXTURE: [[f64; 6]; 3] = [
    [0.9, -0.4, 0.7, 0.3, -0.8, 0.5],
    [0.2, 0.8, -0.5, 0.9, 0.4, -0.7],
    [-0.6, 0.5, 0.3, -0.7, 0.9, 0.8],
];

/// The translation times the determinant of three equations for the depths of a point and the
/// scale.
fn translation_of(r: [[f64; 3]; 3], first: _, second: _, n: [[f64; 4]; 3]) -> [f64; 3] {
    let [depth, second_depth, scale, common] = solved(n);
    scale * second[0] + second_depth * second[1] - common * (r * first[0]) - depth * (r * first[1])
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
/// the first and in the second system, of the scale, and of 1.
fn meet(r: [[f64; 3]; 3], first_i: _, second_i: _, first_j: _, second_j: _) -> [f64; 4] {
    let [direction, second_direction] = [first_j[1], second_j[1]];
    [
        dot(second_direction, r * cross(direction, first_i[1])),
        dot(cross(second_direction, second_i[1]), r * direction),
        dot(cross(second_direction, second_i[0] - second_j[0]), r * direction),
        dot(second_direction, r * cross(first_j[0] - first_i[0], direction)),
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
    zoom: f64,
    centres: [[[f64; 3]; 2]; 7],
    points: [[f64; 3]; 7],
) -> (Data, ScaledPose) {
    let from = [0, 0, 4];
    let translation = shift + from - rotation * from;
    let scale = 3 / 2 + zoom;
    let [mut first, mut second] = [centres, centres];
    for k in 0..7 {
        let point = points[k] + from;
        let [a, b] = centres[k] / 2;
        first[k] = [a, normalise(point - a)];
        second[k] = [b / scale, normalise(rotation * point + translation - b)];
    }
    (Data { first, second }, ScaledPose { rotation, translation, scale })
}
