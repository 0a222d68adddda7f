/// The intersection of three general quadrics: 8 solutions by Bézout's theorem.
///
/// Kukelova, Heller, Fitzgibbon, "Efficient intersection of three quadrics and applications in
/// computer vision", CVPR 2016.
///
/// `quadrics` holds the coefficients of x^2, x y, x z, y^2, y z, z^2, x, y, z, 1, a quadric in each
/// row.
fn three_quadrics(quadrics: [[f64; 10]; 3]) -> (x, y, z) {
    quadrics * [x * x, x * y, x * z, y * y, y * z, z * z, x, y, z, 1] == 0;
}
