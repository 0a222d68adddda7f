/// Pose and focal length of a camera from three points and one image coordinate of a fourth: 10
/// solutions.
///
/// Wu, "P3.5P: Pose estimation with unknown focal length", CVPR 2015. Published as `pose_35pt`.
///
/// `points` holds the points, one a row; `horizontal` and `vertical` their image coordinates,
/// centred at the principal point. The rotation is, up to scale, that about the optical axis times
/// that of the quaternion (1, x, y, 0). Each row of the matrix eliminates the rotation about the
/// optical axis, and what is unknown of the focal length, from three points: it annihilates (cos,
/// sin, 1/f).
fn pose_35pt_focal(points: [[f64; 3]; 4], horizontal: [f64; 4], vertical: [f64; 3]) -> (x, y) {
    let rotation = [
        [1 + x * x - y * y, 2 * x * y, 2 * y],
        [2 * x * y, 1 - x * x + y * y, -2 * x],
        [-2 * y, 2 * x, 1 - x * x - y * y],
    ];
    let rows = [
        row(rotation, points, horizontal, vertical, 0, 1, 2),
        row(rotation, points, horizontal, vertical, 0, 2, 1),
        row(rotation, points, horizontal, vertical, 1, 3, 2),
        row(rotation, points, horizontal, vertical, 2, 3, 1),
    ];
    for left_out in 0..4 {
        det([rows[(left_out + 1) % 4], rows[(left_out + 2) % 4], rows[(left_out + 3) % 4]]) == 0;
    }
}

fn row(rotation: _, points: _, horizontal: _, vertical: _, i: f64, j: f64, k: f64) -> [f64; 3] {
    let to_j = rotation * (points[j] - points[i]);
    let to_k = rotation * (points[k] - points[i]);
    let across = horizontal[i] - horizontal[j];
    let down = vertical[i] - vertical[k];
    [
        down * to_j[0] - across * to_k[1],
        -down * to_j[1] - across * to_k[0],
        -down * horizontal[j] * to_j[2] + across * vertical[k] * to_k[2],
    ]
}
