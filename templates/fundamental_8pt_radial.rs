/// Fundamental matrix and the radial distortion common to both cameras from eight point
/// correspondences: 16 solutions.
///
/// Kukelova, Pajdla, "A minimal solution to the autocalibration of radial distortion", CVPR 2007.
/// Published as `8ptF_radial`.
///
/// A point x lies along (x, 1 + radial |x|^2), the division model. Then x2^T F x1 = 0 is, with f33
/// = 1, linear in f11, f21, f31, f12, f22, f32, radial f31, radial f32 and the monomials radial
/// f13, radial f23, radial^2, f13, f23, radial, 1: eight points give the former as combinations of
/// these, the rows of `affine`.
fn fundamental_8pt_radial(affine: [[f64; 7]; 8]) -> (radial, f_13, f_23) {
    let [f11, f21, f31, f12, f22, f32, radial_f31, radial_f32] =
        affine * [radial * f_13, radial * f_23, radial.pow(2), f_13, f_23, radial, 1];
    let upper = [[f11, f12, f_13], [f21, f22, f_23]];
    radial * f31 == radial_f31;
    radial * f32 == radial_f32;
    det([upper[0], upper[1], [f31, f32, 1]]) == 0;
    // These follow, and have a lower degree than the products that they follow from.
    det([upper[0], upper[1], [radial_f31, radial_f32, radial]]) == 0;
    radial_f31 * f32 == radial_f32 * f31;
}
