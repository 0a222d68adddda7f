/// Fundamental matrix and radial distortion of the second camera from eight point correspondences:
/// 8 solutions.
///
/// Kuang, Solem, Kahl, Åström, "Minimal solvers for relative pose with a single unknown radial
/// distortion", CVPR 2014. Published as `8ptF_radial_1s`.
///
/// A point x2 of the second image lies along (x2, 1 + radial |x2|^2), the division model. Then x2^T
/// F x1 = 0 is linear in the nine entries of F, the third row also multiplied by `radial`. Eight
/// points, and f33 = 1, give (f11, f21, f31, f12, f22, f13, f23, radial f31) = affine (radial f32,
/// radial, f32, 1).
fn fundamental_8pt_radial_one_side(affine: [[f64; 4]; 8]) -> (f_32, radial) {
    let [f11, f21, f31, f12, f22, f13, f23, radial_f31] = affine * [radial * f_32, radial, f_32, 1];
    det([[f11, f12, f13], [f21, f22, f23], [f31, f_32, 1]]) == 0;
    radial * f31 == radial_f31;
}
