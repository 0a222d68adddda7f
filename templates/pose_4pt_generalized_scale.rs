/// Pose and scale of a generalised camera from four points: 8 solutions.
///
/// Ventura, Arth, Reitmayr, Schmalstieg, "A minimal solution to the generalized pose-and-scale
/// problem", CVPR 2014. Published as `gp4p_scale`.
///
/// A point X, and the ray from c along d by which the camera sees it, satisfy d x (R X + t - s c) =
/// 0: two equations, linear in the entries of R, t and s up to a common factor. Seven of the eight
/// leave a null space of dimension six; `basis` holds the entries of R, row by row, of vectors that
/// span it; R is their sum, each times its weight, up to scale.
fn pose_4pt_generalized_scale(basis: [[f64; 9]; 6]) -> (#[projective] weights: [f64; 6]) {
    let s = weights * basis;
    let rows = [[s[0], s[1], s[2]], [s[3], s[4], s[5]], [s[6], s[7], s[8]]];
    let columns = rows.t();
    dot(rows[0], rows[0]) - dot(rows[1], rows[1]) == 0;
    dot(rows[0], rows[0]) - dot(rows[2], rows[2]) == 0;
    dot(columns[0], columns[0]) - dot(rows[1], rows[1]) == 0;
    dot(columns[0], columns[0]) - dot(columns[2], columns[2]) == 0;
    for i in 0..3 {
        dot(rows[i], rows[(i + 1) % 3]) == 0;
        dot(columns[i], columns[(i + 1) % 3]) == 0;
    }
}
