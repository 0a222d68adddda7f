/// Pose of a calibrated camera from n points, all stationary points of a least-squares cost in a
/// quaternion that is not normalised: 40 solutions.
///
/// Zheng, Kuang, Sugimoto, Åström, Okutomi, "Revisiting the PnP problem: a fast, general and
/// optimal solution", ICCV 2013. Published as `opt_pnp_zheng`.
///
/// The quaternion q has the square of its length, the inverse of the mean depth, free. The rest of
/// the pose is linear in the products of two of its entries, and the cost is |`rows` p|^2 with p =
/// (1, w w, w x, w y, w z, x x, x y, x z, y y, y z, z z): `rows` are the equations of ten points,
/// or, of another number of points, their triangular factor and zeros, since only the Gram matrix
/// matters. Since q and -q are the same rotation, q is an unknown scale s times the unknown
/// direction below. The derivatives, divided by s, are linear in the square of s, with the
/// coefficients `cubic` and `linear`: it follows from any of them, and is eliminated here.
fn pose_npt_least_squares_quaternion(rows: [[f64; 11]; 20]) -> (#[projective] q: [f64; 4]) {
    let [w, x, y, z] = q;
    let products = [0, w * w, w * x, w * y, w * z, x * x, x * y, x * z, y * y, y * z, z * z];
    let cubic = derivatives(rows.t() * (rows * products)) * q;
    let linear = derivatives(rows.t() * (rows * [1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0])) * q;
    for i in 0..4 {
        for j in 0..i {
            cubic[i] * linear[j] - cubic[j] * linear[i] == 0;
        }
    }
    let rotation = [
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ];
    Orientation { rotation: rotation }
}

/// The matrix of the quadratic form in q with the coefficients `form`, times 2; the first is of no
/// product.
fn derivatives(form: [f64; 11]) -> [[f64; 4]; 4] {
    [
        [2 * form[1], form[2], form[3], form[4]],
        [form[2], 2 * form[5], form[6], form[7]],
        [form[3], form[6], 2 * form[8], form[9]],
        [form[4], form[7], form[9], 2 * form[10]],
    ]
}
