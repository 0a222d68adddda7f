/// Pose of a calibrated camera from n points, all stationary points of a least-squares cost over
/// the rotations, by Cayley parameters: 40 solutions.
///
/// Nakano, "Globally optimal DLS method for PnP problem with Cayley parameterization", BMVC 2015.
/// Published as `opt_pnp_nakanoC`.
///
/// With the best translation and the best depths the cost is r^T `cost` r, r being the entries of
/// the rotation of the quaternion q, row by row. With r times |q|^2 in its place the
/// cost grows with the fourth power of the length of q, so q is stationary up to its length where
/// the gradient d is parallel to it.
fn pose_npt_least_squares_cayley(#[symmetric] cost: [[f64; 9]; 9]) -> (#[projective] q: [f64; 4]) {
    let [w, x, y, z] = q;
    let entries = [
        w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),
        2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x),
        2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z,
    ];
    // Half of their derivatives by the entries of q.
    let slopes = [
        [w, -z, y, z, w, -x, -y, x, w],
        [x, y, z, y, -x, -w, z, w, -x],
        [-y, x, w, x, y, z, -w, z, -y],
        [-z, -w, x, w, -z, y, x, y, z],
    ];
    let d = slopes * (cost * entries);
    for i in 0..4 {
        for j in 0..i {
            d[i] * q[j] - d[j] * q[i] == 0;
        }
    }
    Orientation { rotation: reshape(entries, [3, 3]) }
}
