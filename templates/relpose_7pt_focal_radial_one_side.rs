/// Relative pose, focal length and radial distortion of the first camera, the second calibrated,
/// from seven points: 19 solutions, of which those with a real focal length are returned.
///
/// Kuang, Solem, Kahl, Åström, "Minimal solvers for relative pose with a single unknown radial
/// distortion", CVPR 2014. Published as `relpose_7p_fr_1s`;
/// `relpose_7pt_focal_radial_one_side_eliminated` is a formulation without the focal length.
///
/// `first[k]` is the distorted image of point k in the first camera, relative to the principal
/// point, `second[k]` that in the calibrated one, in units of its focal length. A point x1 of the
/// first image lies along (x1, 1 + radial |x1|^2), the division model. Then x1^T F x2 = 0 is, with
/// f33 = 1, linear in f11, f21, f12, f22, f13, f23, f31 and the monomials radial f31, f32, radial
/// f32, radial, 1: seven points give the former as combinations of these. With the focal length,
/// diag(focal, focal, 1) F is an essential matrix; `w` is 1 / focal^2.
fn relpose_7pt_focal_radial_one_side(first: [[f64; 2]; 7], second: [[f64; 2]; 7]) -> (w, f_31, f_32, radial) {
    let mut leading = [[0; 7]; 7];
    let mut others = [[0; 5]; 7];
    for k in 0..7 {
        let [a, b] = first[k];
        let [c, d] = second[k];
        let r = a * a + b * b;
        leading[k] = [a * c, b * c, a * d, b * d, a, b, c];
        others[k] = [-c * r, -d, -d * r, -r, -1];
    }
    let [f11, f21, f12, f22, f13, f23, f_31_again] =
        solve(leading, others) * [radial * f_31, f_32, radial * f_32, radial, 1];
    let f = [[f11, f12, f13], [f21, f22, f23], [f_31, f_32, 1]];
    let omega = [[1, 0, 0], [0, 1, 0], [0, 0, w]];
    let left = f * f.t() * omega;
    f_31 == f_31_again;
    det(f) == 0;
    2 * left * f == trace(left) * f;
    w > 0;
    RadialFocalPose { fundamental: f.t(), focal: sqrt(1 / w), radial: radial }
}
