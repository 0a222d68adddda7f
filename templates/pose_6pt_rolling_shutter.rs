/// Pose and motion of a camera with rolling shutter from six points: 20 solutions.
///
/// Albl, Kukelova, Pajdla, "R6P - rolling shutter absolute camera pose", CVPR 2015. Published as
/// `r6p`.
///
/// A point X is seen at q, in the row q\[0\], where (q, 1) and (I + q\[0\] \[(x, y, z)\]x) (I +
/// \[(u, v, w)\]x) X + C + q\[0\] t are parallel: both rotations linearised, the first for an
/// angular velocity. Three of the points, linear in the position C and the velocity t, give them as
/// position m and velocity m, m being the products of x, y, z (slower) with u, v, w, and then u, v,
/// w, x, y, z, 1. `image` and `points` are the other three, one a row.
fn pose_6pt_rolling_shutter(
    image: [[f64; 2]; 3],
    points: [[f64; 3]; 3],
    position: [[f64; 16]; 3],
    velocity: [[f64; 16]; 3],
) -> (u, v, w, x, y, z) {
    let monomials = [u * x, v * x, w * x, u * y, v * y, w * y, u * z, v * z, w * z, u, v, w, x, y, z, 1];
    for k in 0..3 {
        let row = image[k][0];
        let turned = points[k] + cross([u, v, w], points[k]);
        let seen = turned + row * cross([x, y, z], turned) + position * monomials + row * (velocity * monomials);
        image[k][1] * seen[2] - seen[1] == 0;
        seen[0] - row * seen[2] == 0;
    }
}
