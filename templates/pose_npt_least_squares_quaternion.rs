/// Pose of a calibrated camera from n points, all stationary points of a least-squares cost in a
/// quaternion that is not normalised: 40 solutions.
///
/// Zheng, Kuang, Sugimoto, Åström, Okutomi, "Revisiting the PnP problem: a fast, general and
/// optimal solution", ICCV 2013. Published as `opt_pnp_zheng`.
///
/// With depths relative to their mean, and P the rotation over the mean depth, the image (u, v) of
/// a point satisfies (u, v) (1 + P3 X) = (P1 X, P2 X) + constants, X relative to the mean of the
/// points. With the best constants the mean square of the differences is a quadratic form in 1 and
/// the entries of P, which are the products of two entries of a quaternion. The square of its
/// length, the inverse of the mean depth, is free: it is an unknown scale s times the unknown
/// direction q below. The derivatives, divided by s, are linear in the square of s, with the
/// coefficients `cubic` and `linear`: it follows from any of them, and is eliminated here.
///
/// `means` are those of `of_point` over 4 points or more. Rounding errors are smallest if the
/// origin is amid the points.
fn pose_npt_least_squares_quaternion(#[mean(of_point)] means: [f64; 39]) -> (#[projective] q: [f64; 4]) {
    let mean = [means[3], means[6], means[8]];
    let [squares, squares_u, squares_v, squares_q] = [
        moved(concat(means[0..9], 1), mean), moved(means[9..19], mean), moved(means[19..29], mean),
        moved(means[29..39], mean),
    ];
    let [u, v] = [squares_u[3], squares_v[3]];
    // The quadratic form: its coefficients of 1 and an entry of P, and of two entries.
    let mut mixed = [[0; 3]; 3];
    let mut form = [[0; 9]; 9];
    for i in 0..3 {
        mixed[0][i] = -u[i];
        mixed[1][i] = -v[i];
        mixed[2][i] = squares_q[3][i] - u[3] * u[i] - v[3] * v[i];
        for j in 0..3 {
            form[i][j] = squares[i][j];
            form[3 + i][3 + j] = squares[i][j];
            form[i][6 + j] = -squares_u[i][j];
            form[6 + j][i] = -squares_u[i][j];
            form[3 + i][6 + j] = -squares_v[i][j];
            form[6 + j][3 + i] = -squares_v[i][j];
            form[6 + i][6 + j] = squares_q[i][j] - u[i] * u[j] - v[i] * v[j];
        }
    }
    let [w, x, y, z] = q;
    let rotation = [
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ];
    let entries = reshape(rotation, [9]);
    let cubic = slopes(q) * (form * entries);
    let linear = slopes(q) * reshape(mixed, [9]);
    for i in 0..4 {
        for j in 0..i {
            cubic[i] * linear[j] - cubic[j] * linear[i] == 0;
        }
    }
    let slope = dot(reshape(mixed, [9]), entries);
    let square = dot(entries, form * entries);
    let shift = [dot(rotation[2], [u[0], u[1], u[2]]), dot(rotation[2], [v[0], v[1], v[2]])];
    let centre = [u[3], v[3]];
    Pose {
        rotation: rotation,
        translation: translation(-square / slope, concat(centre, 1), concat(shift, 0), rotation * mean),
    }
}

/// What a point and its image give: the products of two of the point's coordinates and 1, then
/// those with 1 times the coordinates of the image and times the square of its distance from the
/// principal point.
fn of_point(image: [f64; 2], point: [f64; 3]) -> [f64; 39] {
    let [u, v] = image;
    let [x, y, z] = point;
    let without_1 = [x * x, x * y, x * z, x, y * y, y * z, y, z * z, z];
    let products = concat(without_1, 1);
    concat(without_1, concat(u * products, concat(v * products, (u * u + v * v) * products)))
}

/// The means of products as a symmetric matrix, for points from which `mean` is subtracted.
fn moved(means: [f64; 10], mean: [f64; 3]) -> [[f64; 4]; 4] {
    let [xx, xy, xz, x, yy, yz, y, zz, z, one] = means;
    let products = [[xx, xy, xz, x], [xy, yy, yz, y], [xz, yz, zz, z], [x, y, z, one]];
    let [a, b, c] = mean;
    let shift = [[1, 0, 0, -a], [0, 1, 0, -b], [0, 0, 1, -c], [0, 0, 0, 1]];
    shift * products * shift.t()
}

/// Half of the derivatives of the entries of the rotation by the entries of its quaternion.
fn slopes(q: [f64; 4]) -> [[f64; 9]; 4] {
    let [w, x, y, z] = q;
    [
        [w, -z, y, z, w, -x, -y, x, w],
        [x, y, z, y, -x, -w, z, w, -x],
        [-y, x, w, x, y, z, -w, z, -y],
        [-z, -w, x, w, -z, y, x, y, z],
    ]
}

/// The translation from the mean depth.
fn translation(depth: f64, centre: [f64; 3], shift: [f64; 3], turned_mean: [f64; 3]) -> [f64; 3] {
    depth * centre + shift - turned_mean
}

/// A camera that looks from about 4 away at 8 points in a cube of side 2.
#[scene]
fn scene(
    #[rotation] rotation: [[f64; 3]; 3],
    shift: [f64; 3],
    points: [[f64; 3]; 8],
) -> (Data, Pose) {
    let translation = [0, 0, 4] + shift;
    let mut means = [0; 39];
    for point in points {
        let seen = rotation * point + translation;
        means += of_point([seen[0], seen[1]] / seen[2], point) / 8;
    }
    (Data { means }, Pose { rotation, translation })
}
