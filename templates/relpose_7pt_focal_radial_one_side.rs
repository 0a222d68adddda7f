/// Relative pose, focal length and radial distortion of the first camera, the second calibrated,
/// from seven point correspondences: 19 solutions.
///
/// Kuang, Solem, Kahl, Åström, "Minimal solvers for relative pose with a single unknown radial
/// distortion", CVPR 2014. Published as `relpose_7p_fr_1s`;
/// `relpose_7pt_focal_radial_one_side_eliminated` is a formulation without the focal length.
///
/// A point x1 of the first image lies along (x1, 1 + radial |x1|^2), the division model. Then x1^T
/// F x2 = 0 is, with f33 = 1, linear in f11, f21, f12, f22, f13, f23, f31 and the monomials radial
/// f31, f32, radial f32, radial, 1: seven points give the former as combinations of these, the rows
/// of `affine`. With the focal length, diag(focal, focal, 1) F is an essential matrix; `w` is 1 /
/// focal^2.
fn relpose_7pt_focal_radial_one_side(affine: [[f64; 5]; 7]) -> (w, f_31, f_32, radial) {
    let [f11, f21, f12, f22, f13, f23, f_31_again] = affine * [radial * f_31, f_32, radial * f_32, radial, 1];
    let f = [[f11, f12, f13], [f21, f22, f23], [f_31, f_32, 1]];
    let omega = [[1, 0, 0], [0, 1, 0], [0, 0, w]];
    let left = f * f.t() * omega;
    f_31 == f_31_again;
    det(f) == 0;
    2 * left * f == trace(left) * f;
}
