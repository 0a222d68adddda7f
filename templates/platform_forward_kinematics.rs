/// Forward kinematics of the general Stewart-Gough platform, all poses with given lengths of its
/// six legs: 40 solutions.
///
/// Husty, "An algorithm for solving the direct kinematics of general Stewart-Gough-type platforms",
/// Mechanism and Machine Theory 31, 1996. Published as `parallel_robot_66`.
///
/// The first leg joins the origins of base and platform. Let t be that leg in the base's
/// coordinates, s = R^T t in the platform's. The length of the leg from X to x, less that of the
/// first, gives x s - X t as a linear combination of the entries of R and 1: five equations for s
/// and t, solved after base and platform are turned so that only the third coordinates remain
/// together. R is that of the quaternion q = 1 + a i + b j + c k, so n s and n t, with n = |q|^2,
/// are quadratic polynomials, with coefficients of 1, a, b, c, a a, a b, a c, b b, b c, c c: `sums`
/// has those of s_i + t_i, `differences` those of s_i - t_i, for i = 1, 2, and s_3 + t_3 = (2 +
/// `excess`) (s_3 - t_3) + `shift`. `excess` exceeds -1 if the null vector of the five equations is
/// longer in s than in t, as where the base is larger; else base and platform are exchanged.
/// `square` is the square of the length of the first leg.
///
/// That t q = q s gives n (s_3 - t_3) times 1, a, b and c as cubic polynomials, and that |s| = |t|
/// its square: with these |t|^2 = `square` and its product with n (s_3 - t_3) have degrees of four
/// and six.
fn platform_forward_kinematics(
    sums: [[f64; 10]; 2],
    differences: [[f64; 10]; 2],
    shift: [f64; 10],
    excess: f64,
    square: f64,
) -> (a, b, c) {
    let ratio = 2 + excess;
    let monomials = [1, a, b, c, a * a, a * b, a * c, b * b, b * c, c * c];
    let sum = sums * monomials;
    let difference = differences * monomials;
    let e = dot(shift, monomials);
    let n = dot(NORM, monomials);

    // n (s_3 - t_3) times 1 and c, n (s_3 + t_3) times a and b.
    let by_1 = b * sum[0] - a * sum[1];
    let by_c = -a * difference[0] - b * difference[1];
    let by_a = difference[1] + c * sum[0];
    let by_b = c * sum[1] - difference[0];
    c * by_1 == by_c;
    a * (ratio * by_1 + e) == by_a;
    b * (ratio * by_1 + e) == by_b;
    a * (ratio * by_c + c * e) == c * by_a;
    b * (ratio * by_c + c * e) == c * by_b;

    // ratio n (s_3 - t_3) times 1, a, b, c.
    let products = [ratio * by_1, by_a - a * e, by_b - b * e, ratio * by_c];
    // ratio (n (s_3 - t_3))^2 is -both - n (s_3 - t_3) e.
    let both = dot(sum, difference);
    let by_e = times(shift, products, a, b, c);
    // Four times n^2 (`square` - t_1^2 - t_2^2), less e^2.
    let t = sums - differences;
    let [t1, t2] = t * monomials;
    let rest = 4 * square * n * n - t1 * t1 - t2 * t2 - e * e;
    let less = ratio - 1;
    less * less * (ratio * both + by_e) - 2 * ratio * less * by_e + ratio * ratio * rest == 0;
    let by_both = times(sums[0], products, a, b, c) * difference[0] + times(sums[1], products, a, b, c) * difference[1];
    let by_rest = 4 * square * times(NORM, products, a, b, c) * n
        - times(t[0], products, a, b, c) * t1
        - times(t[1], products, a, b, c) * t2
        - by_e * e;
    let square_by_e = -ratio * both * e - by_e * e;
    less * less * (ratio * by_both + square_by_e) - 2 * ratio * less * square_by_e + ratio * ratio * by_rest == 0;
}

/// |q|^2.
const NORM: [f64; 10] = [1, 0, 0, 0, 1, 0, 0, 1, 0, 1];

/// The quadratic polynomial with the given coefficients, times what has the given products with 1,
/// a, b and c.
fn times(q: [f64; 10], products: [f64; 4], a: f64, b: f64, c: f64) -> f64 {
    let [by_1, by_a, by_b, by_c] = products;
    by_1 * (q[0] + q[1] * a + q[2] * b + q[3] * c)
        + by_a * (q[4] * a + q[5] * b + q[6] * c)
        + by_b * (q[7] * b + q[8] * c)
        + by_c * q[9] * c
}
