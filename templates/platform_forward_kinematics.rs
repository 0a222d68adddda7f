/// Forward kinematics of the general Stewart-Gough platform, all poses with given lengths of its
/// six legs: 40 solutions.
///
/// Husty, "An algorithm for solving the direct kinematics of general Stewart-Gough-type platforms",
/// Mechanism and Machine Theory 31, 1996. Published as `parallel_robot_66`.
///
/// Leg k joins `base[k]`, in the frame of the base, and `platform[k]`, in that of the platform, and
/// has the length `lengths[k]`. Base or platform may be flat, but not both. Returned is the pose
/// x -> rotation x + translation that takes the platform to the frame of the base.
///
/// Joints are taken relative to those of the first leg. Let t be that leg in the base's
/// coordinates, s = R^T t in the platform's. The length of the leg from X to x, less that of the
/// first, gives x s - X t as a linear combination of the entries of R and 1: five equations for s
/// and t. The null vector of these has a part p of s and a part q of t, and the longer one is p,
/// else base and platform are exchanged. Both are turned so that p and q are along their third
/// axes. R is that of the quaternion 1 + a i + b j + c k, so n s and n t, with n = 1 + a a + b b +
/// c c, are quadratic polynomials: `sums` has the coefficients of n (s_i + t_i), `differences`
/// those of n (s_i - t_i), for i = 1, 2, and s_3 + t_3 = `ratio` (s_3 - t_3) + `shift`.
///
/// That t q = q s gives n (s_3 - t_3) times 1, a, b and c as cubic polynomials, and that |s| = |t|
/// its square: with these |t|^2 = `square` and its product with n (s_3 - t_3) have degrees of four
/// and six.
fn platform_forward_kinematics(base: [[f64; 3]; 6], platform: [[f64; 3]; 6], lengths: [f64; 6]) -> (a, b, c) {
    // Relative to the first leg, in units in which joints are about 1.
    let mut offsets = [[[0; 3]; 5]; 2];
    for k in 0..5 {
        offsets[0][k] = platform[k + 1] - platform[0];
        offsets[1][k] = base[k + 1] - base[0];
    }
    let unit = norm(offsets);
    let joints = offsets / unit;
    let mut parts = [[0; 3]; 2];
    let null = null_space(equations(joints))[0];
    for i in 0..3 {
        parts[0][i] = null[i];
        parts[1][i] = null[3 + i];
    }
    let lead = dot(parts[0], parts[0]) - dot(parts[1], parts[1]);
    let stay = concat(joints[0], concat(joints[1], [parts[0], parts[1], [0, 0, 0]]));
    let exchange = concat(joints[1], concat(joints[0], [parts[1], parts[0], [1, 1, 1]]));
    let chosen = least([-lead, lead], [stay, exchange]);
    let [p, q] = [chosen[10], chosen[11]];
    let exchanged = chosen[12][0];
    let frames = [frame(p), frame(least([-dot(q, q), -NOTHING * NOTHING], [q, [0, 0, 1]]))];
    let turned = [chosen[0..5] * frames[0].t(), chosen[5..10] * frames[1].t()];
    let [long, short] = [norm(p), norm(q)];
    let square = (lengths[0] / unit).pow(2);
    let mut constants = [0; 5];
    for k in 0..5 {
        let [x, origin] = [turned[0][k], turned[1][k]];
        constants[k] = ((lengths[k + 1] / unit).pow(2) - square - dot(x, x) - dot(origin, origin)) / 2;
    }
    let solved = halves(turned, constants, long, short);
    // |p| t_3 - |q| s_3 is given.
    let ratio = (long + short) / (long - short);
    let shift = 2 * (long * solved[5] - short * solved[2]) / (long - short);
    let sums = [solved[0] + solved[3], solved[1] + solved[4]];
    let differences = [solved[0] - solved[3], solved[1] - solved[4]];
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

    // n t and n s in the turned frames.
    let [t3, s3] = [((ratio - 1) * by_1 + e) / 2, ((ratio + 1) * by_1 + e) / 2];
    let [from_base, from_platform] = [[t1 / 2, t2 / 2, t3], [t1 / 2 + difference[0], t2 / 2 + difference[1], s3]];
    let rotation = reshape(ENTRIES * monomials, [3, 3]);
    let stays = frames[1].t() * rotation * frames[0];
    let of_platform = exchanged * stays.t() + (1 - exchanged) * stays;
    let leg = (1 - exchanged) * frames[1].t() * from_base - exchanged * frames[0].t() * from_platform;
    Pose {
        rotation: of_platform / n,
        translation: (n * base[0] + unit * leg - of_platform * platform[0]) / n,
    }
}

/// A length that is taken for 0.
const NOTHING: f64 = 1 / 100000000000000;

/// The square of the norm of a quaternion, and the entries of its rotation times that, row by row.
const NORM: [f64; 10] = [1, 0, 0, 0, 1, 0, 0, 1, 0, 1];
const ENTRIES: [[f64; 10]; 9] = [
    [1, 0, 0, 0, 1, 0, 0, -1, 0, -1],
    [0, 0, 0, -2, 0, 2, 0, 0, 0, 0],
    [0, 0, 2, 0, 0, 0, 2, 0, 0, 0],
    [0, 0, 0, 2, 0, 2, 0, 0, 0, 0],
    [1, 0, 0, 0, -1, 0, 0, 1, 0, -1],
    [0, -2, 0, 0, 0, 0, 0, 0, 2, 0],
    [0, 0, -2, 0, 0, 0, 2, 0, 0, 0],
    [0, 2, 0, 0, 0, 0, 0, 0, 2, 0],
    [1, 0, 0, 0, -1, 0, 0, -1, 0, 1],
];

/// What s and t are multiplied by: a row x, -X for each leg.
fn equations(joints: [[[f64; 3]; 5]; 2]) -> [[f64; 6]; 5] {
    let mut rows = [[0; 6]; 5];
    for k in 0..5 {
        rows[k] = concat(joints[0][k], -joints[1][k]);
    }
    rows
}

/// Axes of which the third is along v.
fn frame(v: [f64; 3]) -> [[f64; 3]; 3] {
    let [x, y, z] = normalise(v);
    let across = normalise(least([x * x, y * y, z * z], [[0, z, -y], [-z, 0, x], [y, -x, 0]]));
    [across, cross([x, y, z], across), [x, y, z]]
}

/// The shortest n s and n t that satisfy the five equations, with the null vector (0, 0, `long`, 0,
/// 0, `short`): six rows of coefficients.
fn halves(joints: [[[f64; 3]; 5]; 2], constants: [f64; 5], long: f64, short: f64) -> [[f64; 10]; 6] {
    let rows = equations(joints);
    let mut left = [[0; 6]; 6];
    let mut right = [[0; 10]; 6];
    for k in 0..5 {
        let [x, origin] = [joints[0][k], joints[1][k]];
        left[k] = rows[k];
        right[k] = ENTRIES.t() * concat(origin[0] * x, concat(origin[1] * x, origin[2] * x)) + constants[k] * NORM;
    }
    left[5] = [0, 0, long, 0, 0, short];
    solve(left, right)
}

/// The quadratic polynomial with the given coefficients, times what has the given products with 1,
/// a, b and c.
fn times(q: [f64; 10], products: [f64; 4], a: f64, b: f64, c: f64) -> f64 {
    let [by_1, by_a, by_b, by_c] = products;
    by_1 * (q[0] + q[1] * a + q[2] * b + q[3] * c)
        + by_a * (q[4] * a + q[5] * b + q[6] * c)
        + by_b * (q[7] * b + q[8] * c)
        + by_c * q[9] * c
}

/// A base in a cube of side 2, and a smaller platform in front of it.
#[scene]
fn scene(
    base: [[f64; 3]; 6],
    joints: [[f64; 3]; 6],
    #[rotation] rotation: [[f64; 3]; 3],
    shift: [f64; 3],
) -> (Data, Pose) {
    let platform = 2 * joints / 5;
    let translation = [0, 0, 3 / 2] + shift / 2;
    let mut lengths = [0; 6];
    for k in 0..6 {
        lengths[k] = norm(rotation * platform[k] + translation - base[k]);
    }
    (Data { base, platform, lengths }, Pose { rotation, translation })
}
