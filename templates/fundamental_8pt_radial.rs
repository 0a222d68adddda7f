/// Fundamental matrix and the radial distortion common to both cameras from eight points: 16
/// solutions.
///
/// Kukelova, Pajdla, "A minimal solution to the autocalibration of radial distortion", CVPR 2007.
/// Published as `8ptF_radial`.
///
/// `first[k]` and `second[k]` are the distorted images of point k, relative to the centre of
/// distortion. An image x lies along (x, 1 + radial |x|^2), the division model. Then x2^T F x1 = 0
/// is, with f33 = 1, linear in f11, f21, f31, f12, f22, f32, radial f31, radial f32 and the
/// monomials radial f13, radial f23, radial^2, f13, f23, radial, 1: eight points give the former as
/// combinations of these.
fn fundamental_8pt_radial(first: [[f64; 2]; 8], second: [[f64; 2]; 8]) -> (radial, f_13, f_23) {
    let mut leading = [[0; 8]; 8];
    let mut others = [[0; 7]; 8];
    for k in 0..8 {
        let [a, b] = first[k];
        let [c, d] = second[k];
        let [r, s] = [a * a + b * b, c * c + d * d];
        leading[k] = [a * c, a * d, a, b * c, b * d, b, a * s, b * s];
        others[k] = [-c * r, -d * r, -r * s, -c, -d, -r - s, -1];
    }
    let [f11, f21, f31, f12, f22, f32, radial_f31, radial_f32] =
        solve(leading, others) * [radial * f_13, radial * f_23, radial.pow(2), f_13, f_23, radial, 1];
    let upper = [[f11, f12, f_13], [f21, f22, f_23]];
    radial * f31 == radial_f31;
    radial * f32 == radial_f32;
    det([upper[0], upper[1], [f31, f32, 1]]) == 0;
    // These follow, and have a lower degree than the products that they follow from.
    det([upper[0], upper[1], [radial_f31, radial_f32, radial]]) == 0;
    radial_f31 * f32 == radial_f32 * f31;
    RadialEpipolar { fundamental: [upper[0], upper[1], [f31, f32, 1]], radial: radial }
}
