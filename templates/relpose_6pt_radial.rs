/// The essential matrix and the radial distortion common to two otherwise calibrated cameras from
/// six points: 52 solutions.
///
/// Kukelova, Byröd, Josephson, Pajdla, Åström, "Fast and robust numerical solutions to minimal
/// problems for cameras with radial distortion", CVIU 114, 2010. Published as `relpose_6p_rad`,
/// with e33 = 1, which loses planar motions and those without a rotation: e33 is 0.
///
/// `first[k]` and `second[k]` are the distorted images of point k, relative to the centre of
/// distortion and in units of the focal length. An image x lies along (x, 1 + radial |x|^2), the
/// division model. Then x1^T E x2 = 0 is, with e23 = 1, linear in e11, e21, e12, e22, radial e31,
/// e31 and the monomials e32, radial e32, e13, radial e13, 1, radial, radial^2 e33, radial e33,
/// e33: six points give the former as combinations of these. How well depends on which image is the
/// first, and on how the second one is turned about its centre: the best of eight choices is taken.
/// The first image is turned, too, which turns (e13, e23): for usual motions one of these is 0 if
/// it is not.
fn relpose_6pt_radial(first: [[f64; 2]; 6], second: [[f64; 2]; 6]) -> (e_13, e_32, e_33, radial) {
    let mut sizes = [0; 8];
    let mut choices = [[[[0; 2]; 7]; 2]; 8];
    for exchange in 0..2 {
        for turn in 0..4 {
            let [a, b] = if exchange == 0 { [first, second] } else { [second, first] };
            let turned = b * [[TURNS[turn][0], -TURNS[turn][1]], [TURNS[turn][1], TURNS[turn][0]]];
            let all = reshape(combinations(a, turned), [54]);
            sizes[4 * exchange + turn] = dot(all, all);
            choices[4 * exchange + turn] = [concat(a, [[exchange, 0]]), concat(turned, [TURNS[turn]])];
        }
    }
    let [one, other] = least(sizes, choices);
    let exchange = one[6][0];
    let turn = other[6];
    let [cos, sin] = TURN;
    let affine = combinations(one[0..6] * [[cos, -sin], [sin, cos]], other[0..6]);

    let [e11, e21, e12, e22, radial_e31, e31] =
        affine * [e_32, radial * e_32, e_13, radial * e_13, 1, radial, radial.pow(2) * e_33, radial * e_33, e_33];
    let e = [[e11, e12, e_13], [e21, e22, 1], [e31, e_32, e_33]];
    radial * e31 == radial_e31;
    det(e) == 0;
    2 * e * e.t() * e == trace(e * e.t()) * e;

    let essential = about_axis([cos, sin]) * e * about_axis(turn).t();
    RadialPose { #[projective] essential: exchange * essential + (1 - exchange) * essential.t(), radial: radial }
}

/// Cosine and sine of the angles by which an image is turned, of a half circle about every eighth.
const TURNS: [[f64; 2]; 4] = [[1, 0], [0.8, 0.6], [0, 1], [-0.8, 0.6]];

/// Cosine and sine of the angle by which the first image is turned.
const TURN: [f64; 2] = [5 / 13, 12 / 13];

/// The coefficients of the linear unknowns: a row for each of e11, e21, e12, e22, radial e31, e31.
fn combinations(first: [[f64; 2]; 6], second: [[f64; 2]; 6]) -> [[f64; 9]; 6] {
    let mut leading = [[0; 6]; 6];
    let mut others = [[0; 9]; 6];
    for k in 0..6 {
        let [a, b] = first[k];
        let [c, d] = second[k];
        let [r, s] = [a * a + b * b, c * c + d * d];
        leading[k] = [a * c, b * c, a * d, b * d, c * r, c];
        others[k] = [-d, -d * r, -a, -a * s, -b, -b * s, -r * s, -r - s, -1];
    }
    solve(leading, others)
}

/// The rotation about the optical axis by an angle of this cosine and sine.
fn about_axis(angle: [f64; 2]) -> [[f64; 3]; 3] {
    let [c, s] = angle;
    [[c, -s, 0], [s, c, 0], [0, 0, 1]]
}

/// Two cameras that look from about 4 away at points in a cube of side 2, from any sides.
#[scene]
fn scene(
    #[rotation] rotation: [[f64; 3]; 3],
    shift: [f64; 3],
    distortion: f64,
    points: [[f64; 3]; 6],
) -> (Data, RadialPose) {
    let centre = [0, 0, 4];
    let radial = (distortion - 1) / 4;
    let mut first = [[0; 2]; 6];
    let mut second = [[0; 2]; 6];
    for k in 0..6 {
        let [x, y, depth] = points[k] + centre;
        first[k] = distorted([x, y] / depth, radial);
        let [x, y, depth] = rotation * points[k] + centre + shift;
        second[k] = distorted([x, y] / depth, radial);
    }
    let essential = skew(centre + shift - rotation * centre) * rotation;
    (Data { first, second }, RadialPose { essential, radial })
}

/// The image p of which p / (1 + radial |p|^2) is given.
fn distorted(image: [f64; 2], radial: f64) -> [f64; 2] {
    2 * image / (1 + sqrt(1 - 4 * radial * dot(image, image)))
}
