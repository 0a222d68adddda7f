/// Fundamental matrix and the two different radial distortions of two cameras from nine points: 24
/// solutions.
///
/// Kukelova, Byröd, Josephson, Pajdla, Åström, "Fast and robust numerical solutions to minimal
/// problems for cameras with radial distortion", CVIU 114, 2010. Published as `rdist9p`, with f13
/// and f23 eliminated in place of t and f13.
///
/// `first[k]` and `second[k]` are the distorted images of point k, relative to the centres of
/// distortion. An image x lies along (x, 1 + radial |x|^2), the division model: with s for `radial`
/// in the second image and t in the first. Then x2^T F x1 = 0 is, with f33 = 1, linear in f11, f12,
/// f21, f22, t, f13, t f13, t f23, s t and in s f31, s f32, s, f31, f32, f23, 1: nine points give
/// the former as combinations of these.
fn fundamental_9pt_two_radials(first: [[f64; 2]; 9], second: [[f64; 2]; 9]) -> (s, f_31, f_32, f_23) {
    let mut leading = [[0; 9]; 9];
    let mut others = [[0; 7]; 9];
    for k in 0..9 {
        let [a, b] = first[k];
        let [c, d] = second[k];
        let [p, q] = [a * a + b * b, c * c + d * d];
        leading[k] = [c * a, c * b, d * a, d * b, p, c, c * p, d * p, p * q];
        others[k] = [-a * q, -b * q, -q, -a, -b, -d, -1];
    }
    let [f11, f12, f21, f22, t, f13, t_f13, t_f23, s_t] =
        solve(leading, others) * [s * f_31, s * f_32, s, f_31, f_32, f_23, 1];
    let fundamental = [[f11, f12, f13], [f21, f22, f_23], [f_31, f_32, 1]];
    t * f13 == t_f13;
    t * f_23 == t_f23;
    s * t == s_t;
    det(fundamental) == 0;
    // These follow, and have a lower degree than the products that they follow from.
    det([[f11, f12, f13], [f21, f22, f_23], [s * f_31, s * f_32, s]]) == 0;
    det([[f11, f12, t_f13], [f21, f22, t_f23], [f_31, f_32, t]]) == 0;
    det([[f11, f12, t_f13], [f21, f22, t_f23], [s * f_31, s * f_32, s_t]]) == 0;
    t_f13 * f_23 == t_f23 * f13;
    s_t * [f13, f_23] == s * [t_f13, t_f23];
    RadialEpipolar { fundamental: fundamental, radials: [t, s] }
}
