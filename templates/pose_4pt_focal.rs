/// Pose and focal lengths of a camera from four points: 8 solutions, of which those with the points
/// in front of the camera are returned.
///
/// Bujnak, Kukelova, Pajdla, "A general solution to the P4P problem for camera with unknown focal
/// length", CVPR 2008, by three quadrics as Kukelova, Heller, Fitzgibbon, "Efficient intersection
/// of three quadrics and applications in computer vision", CVPR 2016.
///
/// `points[k]` is the position of point k, in a plane or not, and `images[k]` its image, relative
/// to the principal point. Eight equations leave a null space of dimension four of the camera
/// diag(f_x, f_y, 1) \[R t\], which is the sum of its vectors, each times its weight, up to scale.
/// Its first three columns have perpendicular rows. One focal length would be one equation too
/// many: it is left out, and of the results that one is wanted whose two `focal` lengths differ
/// least. A point X has the coordinates `rotation` X + `translation` in the camera.
fn pose_4pt_focal(points: [[f64; 3]; 4], images: [[f64; 2]; 4]) -> (
    #[projective] weights: [f64; 4],
) {
    // Positions relative to the first point, and images, in units in which they are about 1.
    let offsets = [points[1] - points[0], points[2] - points[0], points[3] - points[0]];
    let [unit, image_unit] = [norm(offsets), norm(images)];
    let mut positions = [[0, 0, 0, 1]; 4];
    for k in 0..3 {
        for i in 0..3 {
            positions[k + 1][i] = offsets[k][i] / unit;
        }
    }
    let mut rows = [[0; 12]; 8];
    for k in 0..4 {
        for i in 0..2 {
            for j in 0..4 {
                rows[2 * k + i][4 * i + j] = image_unit * positions[k][j];
                rows[2 * k + i][8 + j] = -images[k][i] * positions[k][j];
            }
        }
    }
    let camera = reshape(weights * null_space(rows), [3, 4]);
    let [a, b, c] = [left_of(camera[0]), left_of(camera[1]), left_of(camera[2])];
    dot(a, b) == 0;
    dot(a, c) == 0;
    dot(b, c) == 0;
    // Positive for a positive multiple of the camera.
    let sign = det([a, b, c]);
    for k in 0..4 {
        sign * dot(camera[2], positions[k]) > 0;
    }
    let squares = [dot(a, a), dot(b, b), dot(c, c)];
    FocalPose {
        rotation: rotation_of(scaled(camera, squares[0], squares[1], squares[2], sign)),
        translation: translation_of(
            scaled(camera, squares[0], squares[1], squares[2], sign), unit, points[0],
        ),
        focal: focal_of(squares[0], squares[1], squares[2], image_unit),
    }
}

/// The rows of \[R t\], from those of a multiple of the camera and the squares of their lengths.
fn scaled(camera: [[f64; 4]; 3], a: f64, b: f64, c: f64, sign: f64) -> [[f64; 4]; 3] {
    let sign = sign * sqrt(1 / (sign * sign));
    [sign * sqrt(1 / a) * camera[0], sign * sqrt(1 / b) * camera[1], sign * sqrt(1 / c) * camera[2]]
}

fn rotation_of(pose: [[f64; 4]; 3]) -> [[f64; 3]; 3] {
    [left_of(pose[0]), left_of(pose[1]), left_of(pose[2])]
}

/// That of positions as they are given.
fn translation_of(pose: [[f64; 4]; 3], unit: f64, origin: [f64; 3]) -> [f64; 3] {
    unit * [pose[0][3], pose[1][3], pose[2][3]] - rotation_of(pose) * origin
}

fn focal_of(a: f64, b: f64, c: f64, unit: f64) -> [f64; 2] {
    [unit * sqrt(a / c), unit * sqrt(b / c)]
}

fn left_of(row: [f64; 4]) -> [f64; 3] {
    [row[0], row[1], row[2]]
}

/// A camera that looks from about 4 away at points in a cube of side 2.
#[scene]
fn scene(
    #[rotation] rotation: [[f64; 3]; 3],
    shift: [f64; 3],
    zoom: f64,
    points: [[f64; 3]; 4],
) -> (Data, FocalPose) {
    let translation = [0, 0, 4] + shift;
    let focal = 3 / 2 + zoom / 2;
    let mut images = [[0; 2]; 4];
    for k in 0..4 {
        let [x, y, depth] = rotation * points[k] + translation;
        images[k] = focal * [x, y] / depth;
    }
    (Data { points, images }, FocalPose { rotation, translation, focal: [focal, focal] })
}
