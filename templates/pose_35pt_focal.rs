/// Pose and focal length of a camera from three points and one image coordinate of a fourth: 10
/// solutions.
///
/// Wu, "P3.5P: Pose estimation with unknown focal length", CVPR 2015. Published as `pose_35pt`.
///
/// `points` holds the points, one a row; `horizontal` and `vertical` their image coordinates,
/// centred at the principal point. The rotation is, up to scale, that about the optical axis times
/// that of the quaternion (1, x, y, 0). Each row of the matrix eliminates the rotation about the
/// optical axis, and what is unknown of the focal length, from three points: it annihilates (cos,
/// sin, 1/f). Where the camera looks against the third axis x and y are infinite. Points are turned
/// before, so that this is no direction in which one would look. A point X has the coordinates
/// `rotation` X + `translation` in the camera.
fn pose_35pt_focal(points: [[f64; 3]; 4], horizontal: [f64; 4], vertical: [f64; 3]) -> (x, y) {
    let points = points * frame().t();
    let rotation = [
        [1 + x * x - y * y, 2 * x * y, 2 * y],
        [2 * x * y, 1 - x * x + y * y, -2 * x],
        [-2 * y, 2 * x, 1 - x * x - y * y],
    ];
    let rows = [
        row(rotation, points, horizontal, vertical, 0, 1, 2),
        row(rotation, points, horizontal, vertical, 0, 2, 1),
        row(rotation, points, horizontal, vertical, 1, 3, 2),
        row(rotation, points, horizontal, vertical, 2, 3, 1),
    ];
    for left_out in 0..4 {
        det([rows[(left_out + 1) % 4], rows[(left_out + 2) % 4], rows[(left_out + 3) % 4]]) == 0;
    }
    let gram = rows.t() * rows;
    let images = [horizontal, [vertical[0], vertical[1], vertical[2], 0]];
    Pose {
        rotation: turned(turn(gram), rotation / (1 + x * x + y * y)) * frame(),
        translation: translation(
            turned(turn(gram), rotation / (1 + x * x + y * y)), turn(gram)[2], points, images,
        ),
        focal: turn(gram)[2],
    }
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

/// Cosine, sine and focal length, from the Gram matrix of the rows with rank 2: the third column of
/// its adjugate is a positive multiple of (cos, sin, 1/f).
fn turn(gram: [[f64; 3]; 3]) -> [f64; 3] {
    let [a, b, c] = gram;
    turn_of(a[0], a[1], b[1], c[0], c[1])
}

fn turn_of(a: f64, b: f64, c: f64, d: f64, e: f64) -> [f64; 3] {
    along(b * e - c * d, b * d - a * e, a * c - b * b)
}

fn along(p: f64, q: f64, r: f64) -> [f64; 3] {
    let length = sqrt(p * p + q * q);
    [p / length, q / length, length / r]
}

/// The rotation about the optical axis times another one.
fn turned(turn: [f64; 3], rotation: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    about_axis(turn[0], turn[1]) * rotation
}

fn about_axis(cos: f64, sin: f64) -> [[f64; 3]; 3] {
    [[cos, -sin, 0], [sin, cos, 0], [0, 0, 1]]
}

/// Image coordinate h of a point with the rotated coordinates r satisfies r\[axis\] - h r\[2\] /
/// focal = h t\[2\] / focal - t\[axis\]: points of two lines with the same slope.
fn translation(rotation: [[f64; 3]; 3], focal: f64, points: _, images: _) -> [f64; 3] {
    let rotated = points * rotation.t();
    let mut means = [[0; 2]; 2];
    let mut sums = [0; 2];
    for axis in 0..2 {
        let count = 4 - axis;
        for k in 0..count {
            means[axis] += at(rotated[k], focal, images[axis][k], axis) / count;
        }
        for k in 0..count {
            let [h, other] = at(rotated[k], focal, images[axis][k], axis);
            sums += (h - means[axis][0]) * [h, other];
        }
    }
    slope(means, focal, sums[1] / sums[0])
}

fn at(rotated: [f64; 3], focal: f64, image: f64, axis: f64) -> [f64; 2] {
    [image, rotated[axis] - image * rotated[2] / focal]
}

fn slope(means: [[f64; 2]; 2], focal: f64, slope: f64) -> [f64; 3] {
    [slope * means[0][0] - means[0][1], slope * means[1][0] - means[1][1], slope * focal]
}

fn row(rotation: _, points: _, horizontal: _, vertical: _, i: f64, j: f64, k: f64) -> [f64; 3] {
    let to_j = rotation * (points[j] - points[i]);
    let to_k = rotation * (points[k] - points[i]);
    let across = horizontal[i] - horizontal[j];
    let down = vertical[i] - vertical[k];
    [
        down * to_j[0] - across * to_k[1],
        -down * to_j[1] - across * to_k[0],
        -down * horizontal[j] * to_j[2] + across * vertical[k] * to_k[2],
    ]
}

/// A camera that looks from about 4 away at points in a cube of side 2.
#[scene]
fn scene(
    #[rotation] rotation: [[f64; 3]; 3],
    shift: [f64; 3],
    zoom: f64,
    points: [[f64; 3]; 4],
) -> (Data, Pose) {
    let translation = [0, 0, 4] + shift;
    let focal = 3 / 2 + zoom / 2;
    let mut images = [[0; 2]; 4];
    for k in 0..4 {
        let [x, y, depth] = rotation * points[k] + translation;
        images[k] = focal * [x, y] / depth;
    }
    let [horizontal, vertical] = images.t();
    (Data { points, horizontal, vertical: vertical[0..3] }, Pose { rotation, translation, focal })
}
