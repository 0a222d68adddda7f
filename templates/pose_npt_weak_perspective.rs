/// Pose of a weak-perspective camera from n points, all stationary points of the least-squares
/// cost: 16 solutions.
///
/// Larsson, Åström, "Uncovering symmetries in polynomial systems", ECCV 2016. Published as `wpnp`.
///
/// In the principal axes of the points, whose standard deviations are `spread`, the cost is |P
/// diag(spread) - `image`|^2, with P the first two rows of a rotation times a scale, that is, of
/// the rotation of a quaternion q that is not normalised. Since q and -q are the same rotation, the
/// unknowns are the ratios in q = root (w, 1, y, z), and `square`, that of the root.
fn pose_npt_weak_perspective(spread: [f64; 3], image: [[f64; 3]; 2]) -> (w, square, y, z) {
    let rows = [
        [w * w + 1 - y * y - z * z, 2 * (y - w * z), 2 * (z + w * y)],
        [2 * (y + w * z), w * w - 1 + y * y - z * z, 2 * (y * z - w)],
    ];
    let target = [weighted(spread, image[0]), weighted(spread, image[1])];
    let a = square * weighted(spread, weighted(spread, rows[0])) - target[0];
    let b = square * weighted(spread, weighted(spread, rows[1])) - target[1];
    // The derivatives by the four entries of q, divided by the root: a and b are those by the
    // entries of P.
    let slope = [
        [a[0] + b[1], -b[2], a[2], b[0] - a[1]],
        [-b[2], a[0] - b[1], a[1] + b[0], a[2]],
        [a[2], a[1] + b[0], b[1] - a[0], b[2]],
        [b[0] - a[1], a[2], b[2], -a[0] - b[1]],
    ];
    slope * [w, 1, y, z] == 0;
    // What follows for a turn about the optical axis, in which the scale cancels.
    dot(target[0], rows[1]) - dot(target[1], rows[0]) == 0;
    let length = w * w + 1 + y * y + z * z;
    let turned = [rows[0], rows[1], [2 * (z - w * y), 2 * (y * z + w), w * w - 1 - y * y + z * z]];
    WeakPose { rotation: turned / length, scale: square * length }
}

fn weighted(weights: _, v: _) -> [f64; 3] {
    [weights[0] * v[0], weights[1] * v[1], weights[2] * v[2]]
}
