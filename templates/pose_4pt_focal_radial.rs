/// Pose, focal length and radial distortion of a camera from four points: 16 solutions.
///
/// Josephson, Byröd, "Pose estimation with radial distortion and unknown focal length", CVPR 2009,
/// in the form of Bujnak, Kukelova, Pajdla, "New efficient solution to the absolute pose problem
/// for camera with unknown focal length and radial distortion", ACCV 2010. Published as `p4p_fr`.
///
/// An image point (u, v) lies along (u, v, 1 + radial (u^2 + v^2)), the division model, of P X with
/// P = diag(1, 1, 1/f) \[R t\]. That v times the first row of P minus u times the second vanishes
/// at X leaves a null space of dimension four: the first two rows of P, without their last entries,
/// are row1 (w, z, y, 1) and row2 (w, z, y, 1). The third, from the four points, is row3 (w, z, y,
/// 1, radial w, radial z, radial y, radial).
fn pose_4pt_focal_radial(row1: [[f64; 4]; 3], row2: [[f64; 4]; 3], row3: [[f64; 8]; 3]) -> (w, radial, y, z) {
    let p1 = row1 * [w, z, y, 1];
    let p2 = row2 * [w, z, y, 1];
    let p3 = row3 * [w, z, y, 1, radial * w, radial * z, radial * y, radial];
    dot(p1, p2) == 0;
    dot(p1, p3) == 0;
    dot(p2, p3) == 0;
    dot(p1, p1) - dot(p2, p2) == 0;
}
