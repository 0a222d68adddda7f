/// Relative pose, focal length and radial distortion common to two cameras from seven point
/// correspondences: 68 solutions.
///
/// Jiang, Kuang, Solem, Åström, "A minimal solution to relative pose with unknown focal length and
/// radial distortion", ACCV 2014. Published as `relpose_7p_fr`.
///
/// A point x lies along (x, 1 + radial |x|^2), the division model. Then x1^T F x2 = 0 is, with f33
/// = 1, linear in f11, f21, f12, f22, radial f31, radial^2, f31 and the monomials f32, radial f32,
/// f13, radial f13, f23, radial f23, radial, 1: seven points give the former as combinations of
/// these. The first image may be turned about its centre, which turns (f13, f23), and `radial` may
/// have any unit: they are such that in f31 radial f23 has the coefficient 0 and radial f13 the
/// coefficient 1. `affine` holds the coefficients of the first six, and `affine_f31` the other six
/// of f31. With the focal length, diag(focal, focal, 1) F diag(focal, focal, 1) is an essential
/// matrix; `w` is 1 / focal^2.
///
/// Everything is p + radial q, two polynomials without `radial`, modulo the equation that gives
/// radial^2, and most equations are stated times `radial`, too. There are points at infinity, near
/// which residuals are small; there the factors that are stated not to vanish are small beside
/// their terms.
fn relpose_7pt_focal_radial(affine: [[f64; 8]; 6], affine_f31: [f64; 6]) -> (w, f_32, f_13, f_23, radial) {
    let mut entries = [[0; 2]; 6];
    for i in 0..6 {
        let r = affine[i];
        entries[i] = [r[0] * f_32 + r[2] * f_13 + r[4] * f_23 + r[7], r[1] * f_32 + r[3] * f_13 + r[5] * f_23 + r[6]];
    }
    let [f11, f21, f12, f22, radial_f31, square] = entries;
    let s = affine_f31;
    let f31 = [s[0] * f_32 + s[2] * f_13 + s[3] * f_23 + s[5], s[1] * f_32 + f_13 + s[4]];
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
}

/// The product of a\[0\] + radial a\[1\] and b\[0\] + radial b\[1\], where radial^2 = square\[0\] +
/// radial square\[1\].
fn times(a: [f64; 2], b: [f64; 2], square: [f64; 2]) -> [f64; 2] {
    let both = a[1] * b[1];
    [a[0] * b[0] + both * square[0], a[0] * b[1] + a[1] * b[0] + both * square[1]]
}
