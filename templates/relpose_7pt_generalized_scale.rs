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
