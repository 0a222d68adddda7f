/// Relative pose, focal length and radial distortion of the first camera, the second calibrated,
/// from seven points: 19 solutions, of which those with a real focal length are returned.
///
/// Kuang, Solem, Kahl, Åström, "Minimal solvers for relative pose with a single unknown radial
/// distortion", CVPR 2014. Published as `relpose_7p_fr_1s`;
/// `relpose_7pt_focal_radial_one_side_eliminated` is a formulation without the focal length.
///
/// `first[k]` is the distorted image of point k in the first camera, relative to the principal
/// point, `second[k]` that in the calibrated one, in units of its focal length. A point x1 of the
/// first image lies along (x1, 1 + radial |x1|^2), the division model. Then x1^T F x2 = 0 is linear
/// in the first two rows of F, radial f33 and the monomials radial f31, radial f32, f31, f32, f33:
/// seven points give the former as combinations of these. `third` is the third row of F, which is
/// given up to scale. It vanishes where the first camera moves along its optical axis: then the
/// points tell nothing of the distortion. With f33 = 1, as published, planar motions and those
/// without a rotation are lost. With the focal length, diag(focal, focal, 1) F is an essential
/// matrix; `w` is 1 / focal^2.
fn relpose_7pt_focal_radial_one_side(first: [[f64; 2]; 7], second: [[f64; 2]; 7]) -> (
    w,
    #[projective] third: [f64; 3],
    radial,
) {
    let mut leading = [[0; 7]; 7];
    let mut others = [[0; 5]; 7];
    for k in 0..7 {
        let [a, b] = first[k];
        let [c, d] = second[k];
        let r = a * a + b * b;
        leading[k] = [a * c, a * d, a, b * c, b * d, b, r];
        others[k] = [-c * r, -d * r, -c, -d, -1];
    }
    let [f11, f12, f13, f21, f22, f23, radial_f33] =
        solve(leading, others) * [radial * third[0], radial * third[1], third[0], third[1], third[2]];
    let f = [[f11, f12, f13], [f21, f22, f23], third];
    let omega = [[1, 0, 0], [0, 1, 0], [0, 0, w]];
    let left = f * f.t() * omega;
    radial * third[2] == radial_f33;
    det(f) == 0;
    2 * left * f == trace(left) * f;
    w > 0;
    RadialFocalPose { #[projective] fundamental: f.t(), focal: sqrt(1 / w), radial: radial }
}

/// Two cameras that look from about 4 away at points in a cube of side 2, from any sides.
#[scene]
fn scene(
    #[rotation] rotation: [[f64; 3]; 3],
    shift: [f64; 3],
    zoom: f64,
    distortion: f64,
    points: [[f64; 3]; 7],
) -> (Data, RadialFocalPose) {
    let centre = [0, 0, 4];
    let focal = 3 / 2 + zoom / 2;
    let radial = (distortion - 1) / 4;
    let mut first = [[0; 2]; 7];
    let mut second = [[0; 2]; 7];
    for k in 0..7 {
        let [x, y, depth] = points[k] + centre;
        first[k] = distorted(focal * [x, y] / depth, radial);
        let [x, y, depth] = rotation * points[k] + centre + shift;
        second[k] = [x, y] / depth;
    }
    let essential = skew(centre + shift - rotation * centre) * rotation;
    let fundamental = essential * [[1, 0, 0], [0, 1, 0], [0, 0, focal]];
    (Data { first, second }, RadialFocalPose { fundamental, focal, radial })
}

/// The image p of which p / (1 + radial |p|^2) is given.
fn distorted(image: [f64; 2], radial: f64) -> [f64; 2] {
    2 * image / (1 + sqrt(1 - 4 * radial * dot(image, image)))
}
