/// Relative pose and radial distortion of the first camera, whose focal length is unknown, too, and
/// eliminated, the second calibrated, from seven points: 19 solutions.
///
/// Kukelova, Kileel, Sturmfels, Pajdla, "A clever elimination strategy for efficient minimal
/// solvers", CVPR 2017. Published as `relpose_7p_fr_1s_elr`.
///
/// `first[k]` is the distorted image of point k in the first camera, relative to the principal
/// point, `second[k]` that in the calibrated one, in units of its focal length. A point x1 of the
/// first image lies along (x1, 1 + radial |x1|^2), the division model. Then x2^T F x1 = 0 is, with
/// f33 = 1, linear in radial f13, f11, f21, f31, f12, f22, f32 and the monomials radial f23, f13,
/// f23, radial, 1: seven points give the former as combinations of these. F diag(focal, focal, 1)
/// is an essential matrix for some focal length: with A the first two columns of F, the third is an
/// eigenvector of A A^T, and where mu is its eigenvalue, |third column|^2 / focal^2 = trace(A A^T)
/// - 2 mu.
fn relpose_7pt_focal_radial_one_side_eliminated(first: [[f64; 2]; 7], second: [[f64; 2]; 7]) -> (
    f_13,
    f_23,
    radial,
) {
    let mut leading = [[0; 7]; 7];
    let mut others = [[0; 5]; 7];
    for k in 0..7 {
        let [a, b] = first[k];
        let [c, d] = second[k];
        let r = a * a + b * b;
        leading[k] = [c * r, a * c, a * d, a, b * c, b * d, b];
        others[k] = [-d * r, -c, -d, -r, -1];
    }
    let [radial_f13, f11, f21, f31, f12, f22, f32] =
        solve(leading, others) * [radial * f_23, f_13, f_23, radial, 1];
    let left = [[f11, f12], [f21, f22], [f31, f32]];
    let third = [f_13, f_23, 1];
    let fundamental = [[f11, f12, f_13], [f21, f22, f_23], [f31, f32, 1]];
    radial * f_13 == radial_f13;
    det(fundamental) == 0;
    cross(third, left * left.t() * third) == 0;
    RadialEpipolar { fundamental: fundamental, radial: radial }
}
