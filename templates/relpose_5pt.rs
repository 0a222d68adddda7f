/// Relative pose of two calibrated cameras from five point correspondences: 10 essential matrices.
///
/// Nistér, "An efficient solution to the five-point relative pose problem", PAMI 2004; in this form
/// Stewénius, Engels, Nistér, "Recent developments on direct relative orientation", ISPRS 2006.
/// Published as `5p`.
///
/// `basis` spans the null space of the five epipolar equations; the essential matrix is x
/// basis\[0\] + y basis\[1\] + z basis\[2\] + basis\[3\].
fn relpose_5pt(basis: [[[f64; 3]; 3]; 4]) -> (x, y, z) {
    let e = x * basis[0] + y * basis[1] + z * basis[2] + basis[3];
    det(e) == 0;
    2 * e * e.t() * e - trace(e * e.t()) * e == 0;
}
