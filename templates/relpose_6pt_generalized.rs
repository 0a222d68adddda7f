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
