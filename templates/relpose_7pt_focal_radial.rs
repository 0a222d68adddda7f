/// Relative pose, focal length and radial distortion common to two cameras from seven point
/// correspondences: 68 solutions, of which those with a real focal length are returned.
///
/// Jiang, Kuang, Solem, Åström, "A minimal solution to relative pose with unknown focal length and
/// radial distortion", ACCV 2014. Published as `relpose_7p_fr`.
///
/// `first[k]` and `second[k]` are the distorted images of point k, relative to the principal point.
/// An image x lies along (x, 1 + radial |x|^2), the division model. Then x1^T F x2 = 0 is, with f33
/// = 1, linear in f11, f21, f12, f22, radial f31, radial^2, f31 and the monomials f32, radial f32,
/// f13, radial f13, f23, radial f23, radial, 1: seven points give the former as combinations of
/// these. How well depends on which image is the first, and on how the second one is turned about
/// its centre: the best of eight choices is taken. The first image may be turned, too, which turns
/// (f13, f23), and `radial` may have any unit: they are such that in f31 radial f23 has the
/// coefficient 0 and radial f13 the coefficient 1. With the focal length, diag(focal, focal, 1) F
/// diag(focal, focal, 1) is an essential matrix; `w` is 1 / focal^2.
///
/// Everything is p + radial q, two polynomials without `radial`, modulo the equation that gives
/// radial^2, and most equations are stated times `radial`, too. There are points at infinity, near
/// which residuals are small; there the factors that are stated not to vanish are small beside
/// their terms.
fn relpose_7pt_focal_radial(first: [[f64; 2]; 7], second: [[f64; 2]; 7]) -> (w, f_32, f_13, f_23, radial) {
    let mut sizes = [0; 8];
    let mut choices = [[[[0; 2]; 8]; 2]; 8];
    for exchange in 0..2 {
        for turn in 0..4 {
            let [a, b] = if exchange == 0 { [first, second] } else { [second, first] };
            let turned = b * [[TURNS[turn][0], -TURNS[turn][1]], [TURNS[turn][1], TURNS[turn][0]]];
            let all = reshape(combinations(a, turned, 1), [56]);
            sizes[4 * exchange + turn] = dot(all, all);
            choices[4 * exchange + turn] = [concat(a, [[exchange, 0]]), concat(turned, [TURNS[turn]])];
        }
    }
    let [one, other] = least(sizes, choices);
    let exchange = one[7][0];
    let turn = other[7];
    let r = combinations(one[0..7], other[0..7], 1)[6];
    let unit = norm([r[3], r[5]]);
    let [cos, sin] = [r[3] / unit, r[5] / unit];
    let affine = combinations(one[0..7] * [[cos, -sin], [sin, cos]], other[0..7], unit);

    let mut entries = [[0; 2]; 6];
    for i in 0..6 {
        let r = affine[i];
        entries[i] = [r[0] * f_32 + r[2] * f_13 + r[4] * f_23 + r[7], r[1] * f_32 + r[3] * f_13 + r[5] * f_23 + r[6]];
    }
    let [f11, f21, f12, f22, radial_f31, square] = entries;
    let s = affine[6];
    let f31 = [s[0] * f_32 + s[2] * f_13 + s[4] * f_23 + s[7], s[1] * f_32 + f_13 + s[6]];
    let f = [[f11, f12, [f_13, 0]], [f21, f22, [f_23, 0]], [f31, [f_32, 0], [1, 0]]];
    // The last row of F times radial.
    let last = [radial_f31, [0, f_32], [0, 1]];
    let one = [0, 1];
    let minor1 = times(f12, f[1][2], square) - times(f22, f[0][2], square);
    let minor2 = times(f11, f[1][2], square) - times(f21, f[0][2], square);
    let minor3 = times(f11, f22, square) - times(f21, f12, square);
    let same = times(one, f31, square) - radial_f31;
    let det = times(f31, minor1, square) - f_32 * minor2 + minor3;
    let det_times = times(radial_f31, minor1, square) - f_32 * times(one, minor2, square) + times(one, minor3, square);
    for e in [same, det, det_times] {
        e[0] + radial * e[1] == 0;
        let t = times(one, e, square);
        t[0] + radial * t[1] == 0;
    }
    let weight = [1, 1, w];
    let mut left = [[[0; 2]; 3]; 3];
    for i in 0..3 {
        for j in 0..3 {
            for k in 0..3 {
                left[i][j] += weight[k] * times(f[i][k], f[j][k], square);
            }
            left[i][j] = weight[j] * left[i][j];
        }
    }
    let tr = left[0][0] + left[1][1] + left[2][2];
    for i in 0..3 {
        for j in 0..3 {
            let mut e = -times(tr, f[i][j], square);
            for k in 0..3 {
                e += 2 * times(left[i][k], f[k][j], square);
            }
            e[0] + radial * e[1] == 0;
        }
    }
    for i in 0..2 {
        for j in 0..3 {
            let mut e = -times(tr, f[i][j], square);
            for k in 0..3 {
                e += 2 * times(left[i][k], f[k][j], square);
            }
            let t = times(one, e, square);
            t[0] + radial * t[1] == 0;
        }
    }
    let mut scaled = [[0; 2]; 3];
    for j in 0..3 {
        for k in 0..3 {
            scaled[j] += weight[k] * times(last[k], f[j][k], square);
        }
        scaled[j] = weight[j] * scaled[j];
    }
    for j in 0..3 {
        let mut e = -times(tr, last[j], square);
        for k in 0..3 {
            e += 2 * times(scaled[k], f[k][j], square);
        }
        e[0] + radial * e[1] == 0;
    }
    radial.pow(2) == square[0] + radial * square[1];

    let t = affine[5];
    (radial - dot([t[1], t[3], t[5]], [f_32, f_13, f_23])) * (s[1] * f_32 + f_13) != 0;
    dot([t[0] + radial * t[1], t[2] + radial * t[3], t[4] + radial * t[5]], [f_32, f_13, f_23]) != 0;

    w > 0;
    let whole = [
        [f11[0] + radial * f11[1], f12[0] + radial * f12[1], f_13],
        [f21[0] + radial * f21[1], f22[0] + radial * f22[1], f_23],
        [f31[0] + radial * f31[1], f_32, 1],
    ];
    let fundamental = about_axis([cos, sin]) * whole * about_axis(turn).t();
    RadialFocalPose {
        #[projective] fundamental: exchange * fundamental + (1 - exchange) * fundamental.t(),
        focal: sqrt(1 / w),
        radial: radial / unit,
    }
}

/// The product of a\[0\] + radial a\[1\] and b\[0\] + radial b\[1\], where radial^2 = square\[0\] +
/// radial square\[1\].
fn times(a: [f64; 2], b: [f64; 2], square: [f64; 2]) -> [f64; 2] {
    let both = a[1] * b[1];
    [a[0] * b[0] + both * square[0], a[0] * b[1] + a[1] * b[0] + both * square[1]]
}

/// Cosine and sine of the angles by which an image is turned, of a half circle about every eighth.
const TURNS: [[f64; 2]; 4] = [[1, 0], [0.8, 0.6], [0, 1], [-0.8, 0.6]];

/// The coefficients of the linear unknowns: a row for each of f11, f21, f12, f22, radial f31,
/// radial^2, f31.
fn combinations(first: [[f64; 2]; 7], second: [[f64; 2]; 7], unit: f64) -> [[f64; 8]; 7] {
    let mut leading = [[0; 7]; 7];
    let mut others = [[0; 8]; 7];
    for k in 0..7 {
        let [a, b] = first[k];
        let [c, d] = second[k];
        let [r, s] = [(a * a + b * b) / unit, (c * c + d * d) / unit];
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
        second[k] = distorted(focal * [x, y] / depth, radial);
    }
    let essential = skew(centre + shift - rotation * centre) * rotation;
    let inverse_calibration = [[1, 0, 0], [0, 1, 0], [0, 0, focal]];
    let fundamental = inverse_calibration * essential * inverse_calibration;
    (Data { first, second }, RadialFocalPose { fundamental, focal, radial })
}

/// The image p of which p / (1 + radial |p|^2) is given.
fn distorted(image: [f64; 2], radial: f64) -> [f64; 2] {
    2 * image / (1 + sqrt(1 - 4 * radial * dot(image, image)))
}
