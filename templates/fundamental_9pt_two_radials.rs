/// Fundamental matrix and the two different radial distortions of two cameras from nine point
/// correspondences: 24 solutions.
///
/// Kukelova, Byröd, Josephson, Pajdla, Åström, "Fast and robust numerical solutions to minimal
/// problems for cameras with radial distortion", CVIU 114, 2010. Published as `rdist9p`, with f13
/// and f23 eliminated in place of t and f13.
///
/// A point x lies along (x, 1 + radial |x|^2), the division model: with s in the second image and t
/// in the first. Then x2^T F x1 = 0 is, with f33 = 1, linear in f11, f12, f21, f22, t, f13, t f13,
/// t f23, s t and in s f31, s f32, s, f31, f32, f23, 1: nine points give the former as combinations
/// of these, the rows of `affine`.
fn fundamental_9pt_two_radials(affine: [[f64; 7]; 9]) -> (s, f_31, f_32, f_23) {
    let [f11, f12, f21, f22, t, f13, t_f13, t_f23, s_t] = affine * [s * f_31, s * f_32, s, f_31, f_32, f_23, 1];
    t * f13 == t_f13;
    t * f_23 == t_f23;
    s * t == s_t;
    det([[f11, f12, f13], [f21, f22, f_23], [f_31, f_32, 1]]) == 0;
    // These follow, and have a lower degree than the products that they follow from.
    det([[f11, f12, f13], [f21, f22, f_23], [s * f_31, s * f_32, s]]) == 0;
    det([[f11, f12, t_f13], [f21, f22, t_f23], [f_31, f_32, t]]) == 0;
    det([[f11, f12, t_f13], [f21, f22, t_f23], [s * f_31, s * f_32, s_t]]) == 0;
    t_f13 * f_23 == t_f23 * f13;
    s_t * [f13, f_23] == s * [t_f13, t_f23];
}
