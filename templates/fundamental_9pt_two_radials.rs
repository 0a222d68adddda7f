/// Fundamental matrix and the two different radial distortions of two cameras from nine points: 24
/// solutions.
///
/// Kukelova, Byröd, Josephson, Pajdla, Åström, "Fast and robust numerical solutions to minimal
/// problems for cameras with radial distortion", CVIU 114, 2010. Published as `rdist9p`, with f33 =
/// 1, which loses planar motions and those without a rotation: f33 is 0.
///
/// `first[k]` and `second[k]` are the distorted images of point k, relative to the centres of
/// distortion. An image x lies along (x, 1 + radial |x|^2), the division model: with s for `radial`
/// in the second image and t in the first. Then x2^T F x1 = 0 is, with f23 = 1, linear in f11, f12,
/// f21, f22, t f13, t, t f33, s t f33, f13 and in s f31, s f32, s f33, f31, f32, f33, 1: nine
/// points give the former as combinations of these. The second image is turned, which turns (f13,
/// f23): for usual motions one of these is 0 if it is not. Both vanish where the first camera moves
/// along its optical axis; without a rotation such points tell nothing of the distortions.
fn fundamental_9pt_two_radials(first: [[f64; 2]; 9], second: [[f64; 2]; 9]) -> (s, f_31, f_32, f_33) {
    let [cos, sin] = TURN;
    let turned = second * [[cos, -sin], [sin, cos]];
    let mut leading = [[0; 9]; 9];
    let mut others = [[0; 7]; 9];
    for k in 0..9 {
        let [a, b] = first[k];
        let [c, d] = turned[k];
        let [p, q] = [a * a + b * b, c * c + d * d];
        leading[k] = [c * a, c * b, d * a, d * b, c * p, d * p, p, p * q, c];
        others[k] = [-a * q, -b * q, -q, -a, -b, -1, -d];
    }
    let [f11, f12, f21, f22, t_f13, t, t_f33, s_t_f33, f13] =
        solve(leading, others) * [s * f_31, s * f_32, s * f_33, f_31, f_32, f_33, 1];
    let own = [[f11, f12, f13], [f21, f22, 1], [f_31, f_32, f_33]];
    t * f13 == t_f13;
    t * f_33 == t_f33;
    s * t_f33 == s_t_f33;
    det(own) == 0;
    // These follow, and have a lower degree than the products that they follow from.
    det([own[0], own[1], [s * f_31, s * f_32, s * f_33]]) == 0;
    det([[f11, f12, t_f13], [f21, f22, t], [f_31, f_32, t_f33]]) == 0;
    det([[f11, f12, t_f13], [f21, f22, t], [s * f_31, s * f_32, s_t_f33]]) == 0;
    t_f33 * f13 == t_f13 * f_33;
    s_t_f33 * f13 == s * t_f13 * f_33;
    s * t * f_33 == s_t_f33;
    RadialEpipolar { #[projective] fundamental: [[cos, -sin, 0], [sin, cos, 0], [0, 0, 1]] * own, radials: [t, s] }
}

/// Cosine and sine of the angle by which the second image is turned.
const TURN: [f64; 2] = [5 / 13, 12 / 13];

/// Two cameras that look from about 4 away at points in a cube of side 2, from any sides.
#[scene]
fn scene(
    #[rotation] rotation: [[f64; 3]; 3],
    shift: [f64; 3],
    zooms: [f64; 2],
    distortions: [f64; 2],
    points: [[f64; 3]; 9],
) -> (Data, RadialEpipolar) {
    let centre = [0, 0, 4];
    let [f, g] = [3 / 2 + zooms[0] / 2, 3 / 2 + zooms[1] / 2];
    let radials = [(distortions[0] - 1) / 4, (distortions[1] - 1) / 4];
    let mut first = [[0; 2]; 9];
    let mut second = [[0; 2]; 9];
    for k in 0..9 {
        let [x, y, depth] = points[k] + centre;
        first[k] = distorted(f * [x, y] / depth, radials[0]);
        let [x, y, depth] = rotation * points[k] + centre + shift;
        second[k] = distorted(g * [x, y] / depth, radials[1]);
    }
    let essential = skew(centre + shift - rotation * centre) * rotation;
    let of_first = [[1, 0, 0], [0, 1, 0], [0, 0, f]];
    let of_second = [[1, 0, 0], [0, 1, 0], [0, 0, g]];
    let fundamental = of_second * essential * of_first;
    (Data { first, second }, RadialEpipolar { fundamental, radials })
}

/// The image p of which p / (1 + radial |p|^2) is given.
fn distorted(image: [f64; 2], radial: f64) -> [f64; 2] {
    2 * image / (1 + sqrt(1 - 4 * radial * dot(image, image)))
}
