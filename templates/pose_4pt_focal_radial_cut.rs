/// Pose, focal length and radial distortion of a camera from four points, without the degenerate
/// solutions: 12 solutions.
///
/// Larsson, Kukelova, Zheng, "Making minimal solvers for absolute pose estimation compact and
/// robust", ICCV 2017. Published as `p4p_fr_iccv17`; `pose_4pt_focal_radial` is the older
/// formulation of the same problem, with 16.
///
/// An image point (u, v) lies along (u, v, 1 + radial (u^2 + v^2)), the division model, of P X with
/// P = diag(1, 1, 1/f) \[R t\]. The first two rows of R, column by column, are `upper` w
/// with the weights w, the null space of four equations; the third row of P is, from the four
/// points, `lower` (w, radial w), of which R takes the first three entries.
fn pose_4pt_focal_radial_cut(upper: [[f64; 4]; 6], lower: [[f64; 8]; 3]) -> (
    radial,
    #[projective] weights: [f64; 4],
) {
    let [a, b, c, d] = weights;
    let [p11, p21, p12, p22, p13, p23] = upper * weights;
    let [p31, p32, p33] = lower * [a, b, c, d, radial * a, radial * b, radial * c, radial * d];
    let [p1, p2, p3] = [[p11, p12, p13], [p21, p22, p23], [p31, p32, p33]];
    dot(p2, p3) == 0;
    dot(p1, p3) == 0;
    dot(p1, p2) == 0;
    dot(p1, p1) - dot(p2, p2) == 0;
    // These follow where the rows are not zero.
    p13 * p13 * p32 - p21 * p21 * p32 - p22 * p22 * p32 - p12 * p13 * p33 - p22 * p23 * p33 == 0;
    p12 * p13 * p32 + p22 * p23 * p32 - p12 * p12 * p33 + p21 * p21 * p33 + p23 * p23 * p33 == 0;
    p11 * p13 * p32 + p21 * p23 * p32 - p11 * p12 * p33 - p21 * p22 * p33 == 0;
    p13 * p13 * p31 - p22 * p22 * p31 + p21 * p22 * p32 - p11 * p13 * p33 == 0;
    p12 * p13 * p31 + p22 * p23 * p31 - p11 * p12 * p33 - p21 * p22 * p33 == 0;
}
