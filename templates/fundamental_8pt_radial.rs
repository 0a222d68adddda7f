/// Fundamental matrix and the radial distortion common to both cameras from eight points: 16
/// solutions.
///
/// Kukelova, Pajdla, "A minimal solution to the autocalibration of radial distortion", CVPR 2007.
/// Published as `8ptF_radial`, with f33 = 1, which loses planar motions and those without a
/// rotation: f33 is 0.
///
/// `first[k]` and `second[k]` are the distorted images of point k, relative to the centre of
/// distortion. An image x lies along (x, 1 + radial |x|^2), the division model. Then x2^T F x1 = 0
/// is linear in f11, f21, f31, f12, f22, f32, radial f31, radial f32 and the monomials radial f13,
/// radial f23, radial^2 f33, f13, f23, radial f33, f33: eight points give the former as
/// combinations of these. `third` is the third column of F, which is given up to scale. It vanishes
/// where the first camera moves along its optical axis; without a rotation such points tell nothing
/// of the distortion.
fn fundamental_8pt_radial(first: [[f64; 2]; 8], second: [[f64; 2]; 8]) -> (radial, #[projective] third: [f64; 3]) {
    let mut leading = [[0; 8]; 8];
    let mut others = [[0; 7]; 8];
    for k in 0..8 {
        let [a, b] = first[k];
        let [c, d] = second[k];
        let [r, s] = [a * a + b * b, c * c + d * d];
        leading[k] = [a * c, a * d, a, b * c, b * d, b, a * s, b * s];
        others[k] = [-c * r, -d * r, -r * s, -c, -d, -r - s, -1];
    }
    let [x, y, z] = third;
    let [f11, f21, f31, f12, f22, f32, radial_f31, radial_f32] =
        solve(leading, others) * [radial * x, radial * y, radial.pow(2) * z, x, y, radial * z, z];
    let upper = [[f11, f12, x], [f21, f22, y]];
    radial * f31 == radial_f31;
    radial * f32 == radial_f32;
    det([upper[0], upper[1], [f31, f32, z]]) == 0;
    // These follow, and have a lower degree than the products that they follow from.
    det([upper[0], upper[1], [radial_f31, radial_f32, radial * z]]) == 0;
    radial_f31 * f32 == radial_f32 * f31;
    RadialEpipolar { #[projective] fundamental: [upper[0], upper[1], [f31, f32, z]], radial: radial }
}

/// Two cameras that look from about 4 away at points in a cube of side 2, from any sides, and bend
/// their images alike.
#[scene]
fn scene(
    #[rotation] rotation: [[f64; 3]; 3],
    shift: [f64; 3],
    zooms: [f64; 2],
    distortion: f64,
    points: [[f64; 3]; 8],
) -> (Data, RadialEpipolar) {
    let centre = [0, 0, 4];
    let [f, g] = [3 / 2 + zooms[0] / 2, 3 / 2 + zooms[1] / 2];
    let radial = (distortion - 1) / 4;
    let mut first = [[0; 2]; 8];
    let mut second = [[0; 2]; 8];
    for k in 0..8 {
        let [x, y, depth] = points[k] + centre;
        first[k] = distorted(f * [x, y] / depth, radial);
        let [x, y, depth] = rotation * points[k] + centre + shift;
        second[k] = distorted(g * [x, y] / depth, radial);
    }
    let essential = skew(centre + shift - rotation * centre) * rotation;
    let of_first = [[1, 0, 0], [0, 1, 0], [0, 0, f]];
    let of_second = [[1, 0, 0], [0, 1, 0], [0, 0, g]];
    let fundamental = of_second * essential * of_first;
    (Data { first, second }, RadialEpipolar { fundamental, radial })
}

/// The image p of which p / (1 + radial |p|^2) is given.
fn distorted(image: [f64; 2], radial: f64) -> [f64; 2] {
    2 * image / (1 + sqrt(1 - 4 * radial * dot(image, image)))
}
