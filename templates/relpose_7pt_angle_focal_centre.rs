/// Focal length and principal point common to two cameras from their fundamental matrix and the
/// angle of rotation between them: 6 solutions.
///
/// Martyushev, "Self-calibration of cameras with Euclidean image plane in case of two views and
/// known relative rotation angle", ECCV 2018. Published as `relpose_7p_fuv_angle`.
///
/// `fundamental` comes from seven points or more, in pixels or any other unit; `half_angle` holds
/// the cosine and the sine of half the angle. The principal point is (x, y), `z` the square of the
/// focal length. With the matrix K of these K^T F K is an essential matrix. F is a multiple of
/// `left`\[0\] `right`\[0\]^T + `left`\[1\] `right`\[1\]^T: with the products A of the left vectors
/// in the quadratic form K K^T, and B of the right ones, B A is a multiple of the identity. With
/// z = 0 all points of a conic are solutions; four combinations of the equations that are divisible
/// by z are stated divided.
fn relpose_7pt_angle_focal_centre(
    #[rank(2)] fundamental: [[f64; 3]; 3],
    #[unit] half_angle: [f64; 2],
) -> (x, y, z) {
    // The epipole e of the second image is perpendicular to the columns, of which two may be
    // parallel. Times its largest element F is made of two of its rows.
    let [p, q, r] = fundamental.t();
    let e = least([-squared(cross(p, q)), -squared(cross(q, r)), -squared(cross(r, p))],
        [cross(p, q), cross(q, r), cross(r, p)]);
    let [p, q, r] = fundamental;
    let [left, right] = least([-e[0] * e[0], -e[1] * e[1], -e[2] * e[2]], [
        [[[-e[1], e[0], 0], [-e[2], 0, e[0]]], [q, r]],
        [[[e[1], -e[0], 0], [0, -e[2], e[1]]], [p, r]],
        [[[e[2], 0, -e[0]], [0, e[2], -e[1]]], [p, q]],
    ]);
    let rotation_trace = 4 * half_angle[0].pow(2) - 1;
    let centre = [x, y, 1];
    // Polynomials in z as lists of their coefficients, which are polynomials in x and y.
    let mut a = [[[0; 2]; 2]; 2];
    let mut b = a;
    let mut c = a;
    for i in 0..2 {
        for j in 0..2 {
            a[i][j] = product_of(left[i], left[j], centre);
            b[i][j] = product_of(right[i], right[j], centre);
            c[i][j] = product_of(right[i], left[j], centre);
        }
    }
    let e12 = times(b[0][0], a[0][1]) + times(b[0][1], a[1][1]);
    let e21 = times(b[0][1], a[0][0]) + times(b[1][1], a[0][1]);
    let difference = times(b[0][0], a[0][0]) - times(b[1][1], a[1][1]);
    let trace_of_square = times(b[0][0], a[0][0]) + 2 * times(b[0][1], a[0][1]) + times(b[1][1], a[1][1]);
    let trace_squared = times(c[0][0] + c[1][1], c[0][0] + c[1][1]);
    let determinant = times(c[0][0], c[1][1]) - times(c[0][1], c[1][0]);
    // (trace R)^2 + 1 at z = 0
    let angle = (rotation_trace.pow(2) - 1) * trace_of_square + 2 * trace_squared
        - 4 * (rotation_trace + 1) * determinant;
    let scale = rotation_trace.pow(2) + 1;
    let e11 = angle + scale * difference;
    let e22 = angle - scale * difference;
    for e in [e12, e21, e11, e22] {
        e[0] + z * e[1] + z * z * e[2] == 0;
    }
    let [l1, l2] = [dot(left[0], centre), dot(left[1], centre)];
    let [r1, r2] = [dot(right[0], centre), dot(right[1], centre)];
    let divisible = [
        r2 * e11 - 2 * scale * r1 * e21,
        2 * scale * r2 * e12 - r1 * e22,
        l2 * e11 - 2 * scale * l1 * e12,
        2 * scale * l2 * e21 - l1 * e22,
    ];
    for e in divisible {
        e[1] + z * e[2] == 0;
    }
    z != 0;
    z > 0;
    Camera { focal: sqrt(z), centre: [x, y] }
}

fn product_of(p: [f64; 3], q: [f64; 3], centre: [f64; 3]) -> [f64; 2] {
    [dot(p, centre) * dot(q, centre), p[0] * q[0] + p[1] * q[1]]
}

fn times(p: [f64; 2], q: [f64; 2]) -> [f64; 3] {
    [p[0] * q[0], p[0] * q[1] + p[1] * q[0], p[1] * q[1]]
}

fn squared(v: [f64; 3]) -> f64 {
    dot(v, v)
}

/// Two cameras that are turned by the angle about any axis, a unit apart in any direction.
#[scene]
fn scene(
    #[unit] half_angle: [f64; 2],
    #[unit] axis: [f64; 3],
    #[unit] baseline: [f64; 3],
    zoom: f64,
    centre: [f64; 2],
) -> (Data, Camera) {
    let focal = 3 / 2 + zoom / 2;
    let [w, s] = half_angle;
    let [x, y, z] = s * axis;
    let rotation = [
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ];
    let [x, y, z] = baseline;
    let essential = [[0, -z, y], [z, 0, -x], [-y, x, 0]] * rotation;
    let calibration = [[1, 0, -centre[0]], [0, 1, -centre[1]], [0, 0, focal]];
    (Data { fundamental: calibration.t() * essential * calibration, half_angle }, Camera { focal, centre })
}
