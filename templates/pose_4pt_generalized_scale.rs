/// Pose and scale of a generalised camera from four points: 8 solutions, of which those with a
/// positive scale are returned.
///
/// Ventura, Arth, Reitmayr, Schmalstieg, "A minimal solution to the generalized pose-and-scale
/// problem", CVPR 2014. Published as `gp4p_scale`. As three quadrics: Kukelova, Heller, Fitzgibbon,
/// "Efficient intersection of three quadrics and applications in computer vision", CVPR 2016.
///
/// `rays[k]` is the ray of point k, of any length, from `centres[k]`, and `points[k]` its position.
/// With R = `rotation`, that of the quaternion, t = `translation` and s = `scale`,
/// R `points[k]` + t - s `centres[k]` is along `rays[k]`: for each point two equations, linear in
/// R, t and s. Seven of the eight are combined so that t and s vanish. `residual` is what the
/// eighth, of the last point, leaves over: the solution that fits it best is wanted.
fn pose_4pt_generalized_scale(
    centres: [[f64; 3]; 4],
    rays: [[f64; 3]; 4],
    points: [[f64; 3]; 4],
) -> (#[projective] quaternion: [f64; 4]) {
    // Relative to the first centre and the first point, in units in which they are about 1.
    let far = [centres[1] - centres[0], centres[2] - centres[0], centres[3] - centres[0]];
    let offsets = [points[1] - points[0], points[2] - points[0], points[3] - points[0]];
    let [unit, unit_of_centres] = [norm(offsets), norm(far)];
    let mut from = [[0; 3]; 4];
    let mut to = from;
    for k in 0..3 {
        from[k + 1] = far[k] / unit_of_centres;
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
    let [w, x, y, z] = quaternion;
    let rotation = [
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ];
    let entries = reshape(rotation, [9]);
    null_space(of_position.t()) * of_rotation * entries == 0;
    // Least squares.
    let normal_matrix = of_position.t() * of_position;
    let position = -solve(normal_matrix, of_position.t() * of_rotation) * entries;
    position[3] > 0;
    let t = [position[0], position[1], position[2]];
    let scale = unit / unit_of_centres * position[3];
    let off = rotation * to[3] + t - position[3] * from[3];
    ScaledPose {
        rotation: rotation,
        translation: unit * t - rotation * points[0] + scale * centres[0],
        scale: scale,
        residual: unit * dot(null_space([rays[3]])[1], off),
    }
}

/// Four cameras of a rig of unknown scale that look at points in a cube of side 2.
#[scene]
fn scene(
    #[rotation] rotation: [[f64; 3]; 3],
    shift: [f64; 3],
    zoom: f64,
    centres: [[f64; 3]; 4],
    points: [[f64; 3]; 4],
) -> (Data, ScaledPose) {
    let translation = [0, 0, 4] + shift;
    let scale = 5 / 4 + zoom;
    let mut rays = points;
    for k in 0..4 {
        rays[k] = normalise(rotation * points[k] + translation - scale * centres[k]);
    }
    (Data { centres, rays, points }, ScaledPose { rotation, translation, scale })
}
