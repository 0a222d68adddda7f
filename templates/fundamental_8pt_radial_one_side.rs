/// Fundamental matrix and radial distortion of the second camera from eight points: 8 solutions.
///
/// Kuang, Solem, Kahl, Åström, "Minimal solvers for relative pose with a single unknown radial
/// distortion", CVPR 2014. Published as `8ptF_radial_1s`, with f33 = 1, which loses planar motions
/// and those without a rotation: f33 is 0.
///
/// `first[k]` is the image of point k in a camera without distortion, `second[k]` the distorted one
/// in the other, relative to the centre of distortion. There an image x lies along (x, 1 + radial
/// |x|^2), the division model. Then x2^T F x1 = 0 is linear in the nine entries of F and in
/// `third`, its third row, times `radial`. Eight points give the first two rows, radial f31 and
/// radial f32 as combinations of radial f33 and `third`. F is given up to scale. `third` vanishes
/// where the second camera moves along its optical axis: then the points tell nothing of the
/// distortion.
fn fundamental_8pt_radial_one_side(first: [[f64; 2]; 8], second: [[f64; 2]; 8]) -> (
    #[projective] third: [f64; 3],
    radial,
) {
    let mut leading = [[0; 8]; 8];
    let mut others = [[0; 4]; 8];
    for k in 0..8 {
        let [a, b] = first[k];
        let [c, d] = second[k];
        let s = c * c + d * d;
        leading[k] = [a * c, b * c, c, a * d, b * d, d, a * s, b * s];
        others[k] = [-s, -a, -b, -1];
    }
    let [f11, f12, f13, f21, f22, f23, radial_f31, radial_f32] =
        solve(leading, others) * concat(radial * third[2], third);
    let fundamental = [[f11, f12, f13], [f21, f22, f23], third];
    det(fundamental) == 0;
    radial * third[0] == radial_f31;
    radial * third[1] == radial_f32;
    RadialEpipolar { fundamental: fundamental, radial: radial }
}
