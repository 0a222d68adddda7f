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

/// Quadrics through a point in a cube of side 2.
#[scene]
fn scene(coefficients: [[f64; 9]; 3], place: [f64; 3]) -> (Data, Solution) {
    let [x, y, z] = place;
    let mut quadrics = [[0; 10]; 3];
    for k in 0..3 {
        let others = coefficients[k];
        quadrics[k] = concat(others, -dot(others, [x * x, x * y, x * z, y * y, y * z, z * z, x, y, z]));
    }
    (Data { quadrics }, Solution { x, y, z })
}
