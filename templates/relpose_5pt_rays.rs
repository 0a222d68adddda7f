/// Relative pose of two calibrated cameras from five points: 10 essential matrices.
///
/// The problem `relpose_5pt` from measurements. `first[k]` and `second[k]` are the rays of point k
/// in both cameras, of any length. An essential matrix E satisfies `second[k] . E first[k] = 0`; it
/// is the sum of the matrices that span the null space of these equations, each times its weight.
fn relpose_5pt_rays(first: [[f64; 3]; 5], second: [[f64; 3]; 5]) -> (#[projective] weights: [f64; 4]) {
    let mut rows = [[0; 9]; 5];
    for k in 0..5 {
        for i in 0..3 {
            for j in 0..3 {
                rows[k][3 * i + j] = second[k][i] * first[k][j];
            }
        }
    }
    let basis = reshape(null_space(rows), [4, 3, 3]);
    let [a, b, c, d] = weights;
    let e = a * basis[0] + b * basis[1] + c * basis[2] + d * basis[3];
    det(e) == 0;
    2 * e * e.t() * e - trace(e * e.t()) * e == 0;
    RelativePose { essential: e }
}
