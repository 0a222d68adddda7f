/// Relative pose and the radial distortion common to two otherwise calibrated cameras from six
/// points: 52 solutions.
///
/// Kukelova, Byröd, Josephson, Pajdla, Åström, "Fast and robust numerical solutions to minimal
/// problems for cameras with radial distortion", CVIU 114, 2010. Published as `relpose_6p_rad`.
///
/// `first[k]` and `second[k]` are the distorted images of point k, relative to the principal
/// points, in units of the focal length. An image x lies along (x, 1 + radial |x|^2), the division
/// model. Then x2^T E x1 = 0 is linear in e11, e21, e12, e22, e31, radial e31 and the monomials
/// e13, radial e13, e23, radial e23, e32, radial e32, radial^2 e33, radial e33, e33: six points
/// give the former as combinations of these. `others` are the entries of E that are left. It is
/// published with e33 = 1, but e33 vanishes where the camera moves in a plane and turns about the
/// normal of that.
fn relpose_6pt_radial(first: [[f64; 2]; 6], second: [[f64; 2]; 6]) -> (
    #[projective] others: [f64; 4],
    radial,
) {
    let mut leading = [[0; 6]; 6];
    let mut right = [[0; 9]; 6];
    for k in 0..6 {
        let [a, b] = first[k];
        let [c, d] = second[k];
        let [r, s] = [a * a + b * b, c * c + d * d];
        leading[k] = [a * c, a * d, b * c, b * d, a, a * s];
        right[k] = [-c, -c * r, -d, -d * r, -b, -b * s, -r * s, -r - s, -1];
    }
    let [e_13, e_23, e_32, e_33] = others;
    let [e11, e21, e12, e22, e31, radial_e31] = solve(leading, right)
        * [e_13, radial * e_13, e_23, radial * e_23, e_32, radial * e_32, radial.pow(2) * e_33, radial * e_33, e_33];
    let e = [[e11, e12, e_13], [e21, e22, e_23], [e31, e_32, e_33]];
    radial * e31 == radial_e31;
    det(e) == 0;
    2 * e * e.t() * e == trace(e * e.t()) * e;
    RadialRelativePose { essential: e, radial: radial }
}
