/// Fundamental matrix and radial distortion of the second camera from eight points: 8 solutions.
///
/// Kuang, Solem, Kahl, Åström, "Minimal solvers for relative pose with a single unknown radial
/// distortion", CVPR 2014. Published as `8ptF_radial_1s`, with f33 = 1, which loses planar motions
/// and those without a rotation: f33 is 0.
///
/// `first[k]` is the image of point k in a camera without distortion, `second[k]` the distorted one
/// in the other, relative to the centre of distortion. There an image x lies along (x, 1 + radial
/// |x|^2), the division model. Then x2^T F x1 = 0 is, with f32 = 1, linear in the first two rows of
/// F, radial f31, radial f32 and in radial f33, f31, 1, f33: eight points give the former as
/// combinations of these. The first image is turned, which turns (f31, f32): for usual motions one
/// of these is 0 if it is not. Both vanish where the second camera moves along its optical axis:
/// then the points tell nothing of the distortion.
fn fundamental_8pt_radial_one_side(first: [[f64; 2]; 8], second: [[f64; 2]; 8]) -> (f_31, f_33, radial) {
    let [cos, sin] = TURN;
    let turned = first * [[cos, -sin], [sin, cos]];
    let mut leading = [[0; 8]; 8];
    let mut others = [[0; 4]; 8];
    for k in 0..8 {
        let [a, b] = turned[k];
        let [c, d] = second[k];
        let s = c * c + d * d;
        leading[k] = [a * c, b * c, c, a * d, b * d, d, a * s, b * s];
        others[k] = [-s, -a, -b, -1];
    }
    let [f11, f12, f13, f21, f22, f23, radial_f31, radial_f32] =
        solve(leading, others) * [radial * f_33, f_31, 1, f_33];
    let own = [[f11, f12, f13], [f21, f22, f23], [f_31, 1, f_33]];
    radial * f_31 == radial_f31;
    radial == radial_f32;
    det(own) == 0;
    RadialEpipolar { #[projective] fundamental: own * [[cos, sin, 0], [-sin, cos, 0], [0, 0, 1]], radial: radial }
}

/// Cosine and sine of the angle by which the image is turned.
const TURN: [f64; 2] = [5 / 13, 12 / 13];

/// Two cameras that look from about 4 away at points in a cube of side 2, from any sides.
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
        first[k] = f * [x, y] / depth;
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
