/// Relative pose of two calibrated cameras from five point correspondences: 10 essential matrices.
///
/// Nistér, "An efficient solution to the five-point relative pose problem", PAMI 2004; in this form
/// Stewénius, Engels, Nistér, "Recent developments on direct relative orientation", ISPRS 2006.
/// Published as `5p`.
///
/// `basis` spans the null space of the five epipolar equations; the essential matrix is the sum
/// of its matrices, each times its weight.
fn relpose_5pt(basis: [[[f64; 3]; 3]; 4]) -> (#[projective] weights: [f64; 4]) {
    let [a, b, c, d] = weights;
    let e = a * basis[0] + b * basis[1] + c * basis[2] + d * basis[3];
    det(e) == 0;
    2 * e * e.t() * e - trace(e * e.t()) * e == 0;
}
