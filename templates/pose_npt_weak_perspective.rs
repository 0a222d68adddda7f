/// Pose of a weak-perspective camera from n points, all stationary points of the least-squares
/// cost: 16 solutions.
///
/// Larsson, Åström, "Uncovering symmetries in polynomial systems", ECCV 2016. Published as `wpnp`.
///
/// The image of a point X is P X + t, with P the first two rows of a rotation times a scale, that
/// is, of the rotation of a quaternion q that is not normalised. With the best t the mean square of
/// the differences is a quadratic form in P, whose matrix is the covariance of the points. Since q
/// and -q are the same rotation, the unknowns are the ratios in q = root (w, 1, y, z), and
/// `square`, that of the root. Points are turned before, so that the entry of 1 is not 0 for poses
/// that scenes are made of. Published templates take the principal axes of the points instead, in
/// which the covariance is diagonal.
///
/// `means` are those of `of_point` over 4 points or more. Rounding errors are smallest if the
/// origin is amid the points.
fn pose_npt_weak_perspective(#[mean(of_point)] means: [f64; 17]) -> (w, square, y, z) {
    let mean = [means[3], means[6], means[8]];
    let [xx, xy, xz, yy, yz, zz] = [
        means[0] - mean[0] * mean[0], means[1] - mean[0] * mean[1], means[2] - mean[0] * mean[2],
        means[4] - mean[1] * mean[1], means[5] - mean[1] * mean[2], means[7] - mean[2] * mean[2],
    ];
    let covariance = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
    let centre = [means[12], means[16]];
    let target = [
        [means[9], means[10], means[11]] - centre[0] * mean,
        [means[13], means[14], means[15]] - centre[1] * mean,
    ];
    let rows = [
        [w * w + 1 - y * y - z * z, 2 * (y - w * z), 2 * (z + w * y)],
        [2 * (y + w * z), w * w - 1 + y * y - z * z, 2 * (y * z - w)],
    ];
    let a = square * (covariance * rows[0]) - target[0];
    let b = square * (covariance * rows[1]) - target[1];
    // The derivatives by the four entries of q, divided by the root: a and b are those by the
    // entries of P.
    let slope = [
        [a[0] + b[1], -b[2], a[2], b[0] - a[1]],
        [-b[2], a[0] - b[1], a[1] + b[0], a[2]],
        [a[2], a[1] + b[0], b[1] - a[0], b[2]],
        [b[0] - a[1], a[2], b[2], -a[0] - b[1]],
    ];
    slope * [w, 1, y, z] == 0;
    // What follows for a turn about the optical axis, in which the scale cancels.
    dot(target[0], rows[1]) - dot(target[1], rows[0]) == 0;
    let length = w * w + 1 + y * y + z * z;
    let turned = [rows[0], rows[1], [2 * (z - w * y), 2 * (y * z + w), w * w - 1 - y * y + z * z]];
    WeakPose {
        rotation: turned * frame() / length,
        scale: square * length,
        translation: [
            centre[0] - square * dot(rows[0], mean), centre[1] - square * dot(rows[1], mean),
        ],
    }
}

/// What a point and its image give: the products of two of the point's coordinates and 1, then
/// those of the coordinates and 1 with those of the image.
fn of_point(image: [f64; 2], point: [f64; 3]) -> [f64; 17] {
    let [u, v] = image;
    let [x, y, z] = frame() * point;
    let with_1 = [x, y, z, 1];
    concat([x * x, x * y, x * z, x, y * y, y * z, y, z * z, z], concat(u * with_1, v * with_1))
}

/// The quaternion of the rotation to the frame in which unknowns are solved for.
const FRAME: [f64; 4] = [23, 14, 3, 19];

/// Its rotation.
fn frame() -> [[f64; 3]; 3] {
    let [w, x, y, z] = FRAME;
    [
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ] / dot(FRAME, FRAME)
}

/// A camera that looks from far away at 8 points in a cube of side 2.
#[scene]
fn scene(
    #[rotation] rotation: [[f64; 3]; 3],
    translation: [f64; 2],
    zoom: f64,
    points: [[f64; 3]; 8],
) -> (Data, WeakPose) {
    let scale = 3 / 2 + zoom;
    let mut means = [0; 17];
    for point in points {
        let image = scale * [dot(rotation[0], point), dot(rotation[1], point)] + translation;
        means += of_point(image, point) / 8;
    }
    (Data { means }, WeakPose { rotation, scale, translation })
}
