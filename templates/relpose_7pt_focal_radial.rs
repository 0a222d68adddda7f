/// Relative pose, focal length and radial distortion common to two cameras from seven point
/// correspondences: 68 solutions, of which those with a real focal length are returned.
///
/// Jiang, Kuang, Solem, Åström, "A minimal solution to relative pose with unknown focal length and
/// radial distortion", ACCV 2014. Published as `relpose_7p_fr`, with f33 = 1, which loses
/// planar motions and those without a rotation: f33 is 0.
///
/// `first[k]` and `second[k]` are the distorted images of point k, relative to the principal point.
/// An image x lies along (x, 1 + radial |x|^2), the division model. Then x1^T F x2 = 0 is, with f23
/// = 1, linear in f11, f21, f12, f22, radial f31, radial^2 f33, f31 and the monomials f32, radial
/// f32, f13, radial f13, 1, radial, radial f33, f33: seven points give the former as combinations
/// of these. How well depends on which image is the first, and on how the second one is turned
/// about its centre: the best of eight choices is taken. The first image is turned, too, which
/// turns (f13, f23): for usual motions one of these is 0 if it is not. With the focal length,
/// diag(focal, focal, 1) F diag(focal, focal, 1) is an essential matrix; `w` is 1 / focal^2.
fn relpose_7pt_focal_radial(first: [[f64; 2]; 7], second: [[f64; 2]; 7]) -> (w, f_13, f_32, f_33, radial) {
    let mut sizes = [0; 8];
    let mut choices = [[[[0; 2]; 8]; 2]; 8];
    for exchange in 0..2 {
        for turn in 0..4 {
            let [a, b] = if exchange == 0 { [first, second] } else { [second, first] };
            let turned = b * [[TURNS[turn][0], -TURNS[turn][1]], [TURNS[turn][1], TURNS[turn][0]]];
            let all = reshape(combinations(a, turned), [56]);
            sizes[4 * exchange + turn] = dot(all, all);
            choices[4 * exchange + turn] = [concat(a, [[exchange, 0]]), concat(turned, [TURNS[turn]])];
        }
    }
    let [one, other] = least(sizes, choices);
    let exchange = one[7][0];
    let turn = other[7];
    let [cos, sin] = TURN;
    let affine = combinations(one[0..7] * [[cos, -sin], [sin, cos]], other[0..7]);

    let [f11, f21, f12, f22, radial_f31, square, f31] =
        affine * [f_32, radial * f_32, f_13, radial * f_13, 1, radial, radial * f_33, f_33];
    let f = [[f11, f12, f_13], [f21, f22, 1], [f31, f_32, f_33]];
    radial * f31 == radial_f31;
    radial.pow(2) * f_33 == square;
    det(f) == 0;
    let weights = [[1, 0, 0], [0, 1, 0], [0, 0, w]];
    2 * f * weights * f.t() * weights * f == trace(f * weights * f.t() * weights) * f;
    // These follow, and have a lower degree than the products that they follow from.
    radial * f_33 * radial_f31 == f31 * square;
    det([f[0], f[1], [radial_f31, radial * f_32, radial * f_33]]) == 0;
    det([f[0], f[1], [radial * radial_f31, radial.pow(2) * f_32, square]]) == 0;

    w > 0;
    let fundamental = about_axis([cos, sin]) * f * about_axis(turn).t();
    RadialFocalPose {
        fundamental: exchange * fundamental + (1 - exchange) * fundamental.t(),
        focal: sqrt(1 / w),
        radial: radial,
    }
}

/// Cosine and sine of the angles by which an image is turned, of a half circle about every eighth.
const TURNS: [[f64; 2]; 4] = [[1, 0], [0.8, 0.6], [0, 1], [-0.8, 0.6]];

/// Cosine and sine of the angle by which the first image is turned.
const TURN: [f64; 2] = [5 / 13, 12 / 13];

/// The coefficients of the linear unknowns: a row for each of f11, f21, f12, f22, radial f31,
/// radial^2 f33, f31.
fn combinations(first: [[f64; 2]; 7], second: [[f64; 2]; 7]) -> [[f64; 8]; 7] {
    let mut leading = [[0; 7]; 7];
    let mut others = [[0; 8]; 7];
    for k in 0..7 {
        let [a, b] = first[k];
        let [c, d] = second[k];
        let [r, s] = [a * a + b * b, c * c + d * d];
        leading[k] = [a * c, b * c, a * d, b * d, c * r, r * s, c];
        others[k] = [-d, -d * r, -a, -a * s, -b, -b * s, -r - s, -1];
    }
    solve(leading, others)
}

/// The rotation about the optical axis by an angle of this cosine and sine.
fn about_axis(angle: [f64; 2]) -> [[f64; 3]; 3] {
    let [c, s] = angle;
    [[c, -s, 0], [s, c, 0], [0, 0, 1]]
}
