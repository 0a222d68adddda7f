/// Pose and scale of a generalised camera from four points: 8 solutions.
///
/// Ventura, Arth, Reitmayr, Schmalstieg, "A minimal solution to the generalized pose-and-scale
/// problem", CVPR 2014. Published as `gp4p_scale`. As three quadrics: Kukelova, Heller, Fitzgibbon,
/// "Efficient intersection of three quadrics and applications in computer vision", CVPR 2016.
///
/// `rays[k]` is the ray of point k, of any length, from `centres[k]`, and `points[k]` its position.
/// With R = `rotation` of the quaternion q, t = `translation` and s = `scale`, R `points[k]` + t - s
/// `centres[k]` is along `rays[k]`: for each point two equations, linear in R, t and s. Seven of the
/// eight are combined so that t and s vanish. Measurements that are exact satisfy the eighth, the
/// second of the last ray, for the true solution only.
fn pose_4pt_generalized_scale(
    centres: [[f64; 3]; 4],
    rays: [[f64; 3]; 4],
    points: [[f64; 3]; 4],
) -> (#[projective] q: [f64; 4]) {
    // Relative to the first centre and the first point, in units in which they are about 1.
    let far = [centres[1] - centres[0], centres[2] - centres[0], centres[3] - centres[0]];
    let offsets = [points[1] - points[0], points[2] - points[0], points[3] - points[0]];
    let [unit, scale_unit] = [norm(offsets), norm(offsets) / norm(far)];
    let [mut from, mut to] = [[[0; 3]; 4], [[0; 3]; 4]];
    for k in 0..3 {
        from[k + 1] = far[k] / norm(far);
        to[k + 1] = offsets[k] / unit;
    }
    // Coefficients of R, row by row, and of t and s: all first equations, then the second ones.
    let mut of_rotation = [[0; 9]; 7];
    let mut of_position = [[0; 4]; 7];
    for side in 0..2 {
        for k in 0..4 - side {
            let normal = null_space([rays[k]])[side];
            for i in 0..3 {
                for j in 0..3 {
                    of_rotation[4 * side + k][3 * i + j] = normal[i] * to[k][j];
                }
                of_position[4 * side + k][i] = normal[i];
            }
            of_position[4 * side + k][3] = -dot(normal, from[k]);
        }
    }
    let r = rotation(q);
    let entries = reshape(r, [9]);
    null_space(of_position.t()) * of_rotation * entries == 0;
    let normal_matrix = of_position.t() * of_position;
    let position = -solve(normal_matrix, of_position.t() * of_rotation) * entries;
    let square = dot(q, q);
    let t = [position[0], position[1], position[2]];
    let s = scale_unit * position[3];
    ScaledPose {
        rotation: r / square,
        translation: (unit * t - r * points[0] + s * centres[0]) / square,
        scale: s / square,
    }
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
