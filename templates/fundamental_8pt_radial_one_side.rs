/// Fundamental matrix and radial distortion of the second camera from eight points: 8 solutions.
///
/// Kuang, Solem, Kahl, Åström, "Minimal solvers for relative pose with a single unknown radial
/// distortion", CVPR 2014. Published as `8ptF_radial_1s`.
///
/// `first[k]` is the image of point k in a camera without distortion, `second[k]` the distorted one
/// in the other, relative to the centre of distortion. There an image x lies along (x, 1 + radial
/// |x|^2), the division model. Then x2^T F x1 = 0 is linear in the nine entries of F, the third row
/// also multiplied by `radial`. Eight points, and f33 = 1, give f11, f21, f31, f12, f22, f13, f23
/// and radial f31 as combinations of radial f32, radial, f32 and 1.
fn fundamental_8pt_radial_one_side(first: [[f64; 2]; 8], second: [[f64; 2]; 8]) -> (f_32, radial) {
    let mut leading = [[0; 8]; 8];
    let mut others = [[0; 4]; 8];
    for k in 0..8 {
        let [a, b] = first[k];
        let [c, d] = second[k];
        let s = c * c + d * d;
        leading[k] = [a * c, a * d, a, b * c, b * d, c, d, a * s];
        others[k] = [-b * s, -s, -b, -1];
    }
    let [f11, f21, f31, f12, f22, f13, f23, radial_f31] = solve(leading, others) * [radial * f_32, radial, f_32, 1];
    let fundamental = [[f11, f12, f13], [f21, f22, f23], [f31, f_32, 1]];
    det(fundamental) == 0;
    radial * f31 == radial_f31;
    RadialEpipolar { fundamental: fundamental, radial: radial }
}
