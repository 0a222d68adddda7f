/// Pose, focal length and radial distortion of a camera from four points: 16 solutions.
///
/// Josephson, Byröd, "Pose estimation with radial distortion and unknown focal length", CVPR 2009,
/// in the form of Bujnak, Kukelova, Pajdla, "New efficient solution to the absolute pose problem
/// for camera with unknown focal length and radial distortion", ACCV 2010. Published as `p4p_fr`.
///
/// An image point (u, v) lies along (u, v, 1 + radial (u^2 + v^2)), the division model, of P X with
/// P = diag(1, 1, 1/f) \[R t\]. That v times the first row of P minus u times the second vanishes
/// at X leaves a null space of dimension four: the first two rows of P, without their last entries,
/// are row1 w and row2 w with the weights w. The third, from the four points, is row3 (w, radial
/// w).
fn pose_4pt_focal_radial(row1: [[f64; 4]; 3], row2: [[f64; 4]; 3], row3: [[f64; 8]; 3]) -> (
    #[projective]
    weights: [f64; 4],
    radial,
) {
    let [a, b, c, d] = weights;
    let p1 = row1 * weights;
    let p2 = row2 * weights;
    let p3 = row3 * [a, b, c, d, radial * a, radial * b, radial * c, radial * d];
    dot(p1, p2) == 0;
    dot(p1, p3) == 0;
    dot(p2, p3) == 0;
    dot(p1, p1) - dot(p2, p2) == 0;
}
