/// Pose and scale of a generalised camera from four points: 8 solutions, of which those with a
/// positive scale are returned.
///
/// Ventura, Arth, Reitmayr, Schmalstieg, "A minimal solution to the generalized pose-and-scale
/// problem", CVPR 2014, by three quadrics as Kukelova, Heller, Fitzgibbon, "Efficient intersection
/// of three quadrics and applications in computer vision", CVPR 2016. Published as `gp4p_scale`.
///
/// The camera sees the point `points[k]` by the ray from `centres[k]` along `rays[k]`, of any
/// length. A point X has the coordinates R X + t in units of the points, those of the centre c are
/// `scale` c: with the ray d, d x (R X + t - `scale` c) = 0 are two equations. Seven of the eight
/// are solved for t and `scale`, which leaves three equations in R, that of a quaternion of length
/// 1. `residual` is what the eighth equation leaves over: the solution that fits it best is wanted.
fn pose_4pt_generalized_scale(
    centres: [[f64; 3]; 4],
    rays: [[f64; 3]; 4],
    points: [[f64; 3]; 4],
) -> (#[projective] quaternion: [f64; 4]) {
    let mut entries = [[0; 9]; 8];
    let mut others = [[0; 4]; 8];
    for k in 0..4 {
        let across = null_space([rays[k]]);
        for side in 0..2 {
            let normal = across[side];
            others[2 * k + side] = [normal[0], normal[1], normal[2], -dot(normal, centres[k])];
            for i in 0..3 {
                for j in 0..3 {
                    entries[2 * k + side][3 * i + j] = normal[i] * points[k][j];
                }
            }
        }
    }
    let mut used = [[0; 9]; 7];
    let mut columns = [[0; 4]; 7];
    for i in 0..7 {
        used[i] = entries[i];
        columns[i] = others[i];
    }
    // Across the columns: with these the solution is that of least squares, and what that leaves
    // over.
    let left = null_space(columns.t());
    let mut matrix = [[0; 7]; 7];
    for i in 0..7 {
        let row = columns[i];
        matrix[i] = [row[0], row[1], row[2], row[3], left[0][i], left[1][i], left[2][i]];
    }
    let solved = solve(matrix, used);
    let [w, x, y, z] = quaternion;
    let rotation = [
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ];
    let by_entries = solved * reshape(rotation, [9]);
    for i in 4..7 {
        by_entries[i] == 0;
    }
    let rest = [-by_entries[0], -by_entries[1], -by_entries[2], -by_entries[3]];
    rest[3] > 0;
    ScaledPose {
        rotation: rotation,
        translation: [rest[0], rest[1], rest[2]],
        scale: rest[3],
        residual: dot(entries[7], reshape(rotation, [9])) + dot(others[7], rest),
    }
}
