/// Relative pose of two cameras with one unknown shared focal length from six point
/// correspondences: 15 solutions.
///
/// Stewénius, Nistér, Kahl, Schaffalitzky, "A minimal solution for relative pose with unknown focal
/// length", CVPR 2005; the form with w = 1/f^2 as in Kukelova, Bujnak, Pajdla, "Polynomial
/// eigenvalue solutions to the 5-pt and 6-pt relative pose problems", BMVC 2008. Published as
/// `focal6p`.
///
/// `basis` spans the null space of the six epipolar equations; the fundamental matrix is the
/// sum of its matrices, each times its weight.
fn relpose_6pt_focal(basis: [[[f64; 3]; 3]; 3]) -> (#[projective] weights: [f64; 3], w) {
    let f = weights[0] * basis[0] + weights[1] * basis[1] + weights[2] * basis[2];
    let omega = [[1, 0, 0], [0, 1, 0], [0, 0, w]];
    let left = f * omega * f.t() * omega;
    det(f) == 0;
    2 * left * f - trace(left) * f == 0;
}
