/// Relative pose of a calibrated camera and one with unknown focal length from six point
/// correspondences: 9 solutions.
///
/// Bujnak, Kukelova, Pajdla, "3D reconstruction from image collections with a single known focal
/// length", ICCV 2009. Published as `focal6p_1s`.
///
/// `basis` spans the null space of the six epipolar equations x2^T F x1 = 0, the first camera
/// having the unknown focal length f and the second none; the fundamental matrix is the sum
/// of its matrices, each times its weight, and w = 1/f^2.
fn relpose_6pt_focal_one_side(basis: [[[f64; 3]; 3]; 3]) -> (#[projective] weights: [f64; 3], w) {
    let f = weights[0] * basis[0] + weights[1] * basis[1] + weights[2] * basis[2];
    let omega = [[1, 0, 0], [0, 1, 0], [0, 0, w]];
    let left = f * omega * f.t();
    det(f) == 0;
    2 * left * f - trace(left) * f == 0;
}
