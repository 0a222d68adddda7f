/// Pose and focal length of a camera from five points that calibrated cameras of known poses see,
/// too, and one point of known position: 56 solutions.
///
/// Bhayani, Sattler, Larsson, Heikkilä, Kukelova, "Partially calibrated semi-generalized pose from
/// hybrid point correspondences", WACV 2023. Published as `hyb51f`.
///
/// `image` is that of the known `point`, relative to the principal point, and must not be there.
/// `images[k]` is that of point k, which a calibrated camera sees along the ray from `centres[k]`
/// in the direction `directions[k]`. Positions are relative to `point`; images are turned and
/// scaled so that that of `point` is (1, 0), and its depth is the unknown `depth`. The rotation of
/// the camera, which is turned with the images, is that of the quaternion 1 + x i + y j, and a turn
/// about its axis after it, by the angle of which c and s are cosine and sine, times the focal
/// length. An image lies on that of the ray: det(M) M^-T, the cofactors of M, maps moments of rays
/// to lines of the image where M maps directions to points of it. The squared norm of the
/// quaternion, which divides all cofactors, is left out.
///
/// A pose X -> rotation X + translation takes the world to the camera; `focal` is in the unit of
/// images. The known point is in front of the camera.
fn relpose_5pt_semi_generalized_focal(
    point: [f64; 3],
    image: [f64; 2],
    images: [[f64; 2]; 5],
    centres: [[f64; 3]; 5],
    directions: [[f64; 3]; 5],
) -> (x, y, c, s, depth) {
    let square = dot(image, image);
    let [right, down] = image / square;
    let turned = images * [[right, -down], [down, right]];
    let norm = 1 + x * x + y * y;
    let about = [
        [1 + x * x - y * y, 2 * x * y, 2 * y],
        [2 * x * y, 1 - x * x + y * y, -2 * x],
        [-2 * y, 2 * x, 1 - x * x - y * y],
    ];
    let m = [[c, -s, 0], [s, c, 0], [0, 0, 1]] * about;
    let cofactors = [[c, -s, 0], [s, c, 0], [0, 0, c * c + s * s]] * about;
    for k in 0..5 {
        let through_rotation = cofactors * cross(centres[k] - point, directions[k]);
        let through_position = cross([depth, 0, depth], m * directions[k]);
        dot([turned[k][0], turned[k][1], 1], through_rotation + through_position) == 0;
    }
    depth != 0;
    depth > 0;
    norm != 0;
    FocalPose {
        rotation: turned_back(m / norm, image, sqrt((c * c + s * s) * square)),
        translation: translation_of(m / norm, image, depth, point, sqrt((c * c + s * s) * square)),
        focal: sqrt((c * c + s * s) * square),
    }
}

/// The rotation in images as they are given, from the turned one, whose first two rows are times
/// the focal length in the unit of the turned images.
fn turned_back(m: [[f64; 3]; 3], image: [f64; 2], focal: f64) -> [[f64; 3]; 3] {
    [[image[0], -image[1], 0] / focal, [image[1], image[0], 0] / focal, [0, 0, 1]] * m
}

/// That of positions as they are given.
fn translation_of(m: [[f64; 3]; 3], image: [f64; 2], depth: f64, point: [f64; 3], focal: f64) -> [f64; 3] {
    depth * [image[0] / focal, image[1] / focal, 1] - turned_back(m, image, focal) * point
}

/// A camera that looks from about 4 away at points in a cube of side 2, and calibrated ones around
/// them.
#[scene]
fn scene(
    #[rotation] rotation: [[f64; 3]; 3],
    shift: [f64; 3],
    zoom: f64,
    point: [f64; 3],
    points: [[f64; 3]; 5],
    centres: [[f64; 3]; 5],
) -> (Data, FocalPose) {
    let translation = [0, 0, 4] + shift;
    let focal = 3 / 2 + zoom / 2;
    let [x, y, depth] = rotation * point + translation;
    let image = focal * [x, y] / depth;
    let mut images = [[0; 2]; 5];
    let [mut places, mut directions] = [points, points];
    for k in 0..5 {
        let [x, y, depth] = rotation * points[k] + translation;
        images[k] = focal * [x, y] / depth;
        places[k] = 4 * centres[k];
        directions[k] = points[k] - places[k];
    }
    (Data { point, image, images, centres: places, directions }, FocalPose { rotation, translation, focal })
}
