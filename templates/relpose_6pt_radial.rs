/// Relative pose and the radial distortion common to two otherwise calibrated cameras from six
/// point correspondences: 52 solutions.
///
/// Kukelova, Byröd, Josephson, Pajdla, Åström, "Fast and robust numerical solutions to minimal
/// problems for cameras with radial distortion", CVIU 114, 2010. Published as `relpose_6p_rad`.
///
/// A point x lies along (x, 1 + radial |x|^2), the division model. Then x1^T E x2 = 0 is, with e33
/// = 1, linear in e11, e21, e12, e22, radial e31, e31 and the monomials e32, radial e32, e13,
/// radial e13, e23, radial e23, radial^2, radial, 1: six points give the former as combinations of
/// these. The first image may be turned about its centre, which turns (e13, e23), and `radial` may
/// have any unit: they are such that in e31 radial e23 has the coefficient 0 and radial e13 the
/// coefficient 1, which is a divisor of all that follows. `affine` holds the coefficients of e11,
/// e21, e12, e22, radial e31, and `affine_e31` the other seven of e31.
fn relpose_6pt_radial(affine: [[f64; 9]; 5], affine_e31: [f64; 7]) -> (e_13, e_32, e_23, radial) {
    let [e11, e21, e12, e22, radial_e31] =
        affine * [e_32, radial * e_32, e_13, radial * e_13, e_23, radial * e_23, radial.pow(2), radial, 1];
    let e31 = radial * e_13 + dot(affine_e31, [e_32, radial * e_32, e_13, e_23, radial.pow(2), radial, 1]);
    let e = [[e11, e12, e_13], [e21, e22, e_23], [e31, e_32, 1]];
    radial * e31 == radial_e31;
    det(e) == 0;
    2 * e * e.t() * e == trace(e * e.t()) * e;
    // Where this is small beside its terms there is a point at infinity, near which residuals are
    // small.
    e_13 + affine_e31[1] * e_32 + affine_e31[4] * radial != 0;
}
