/// Poses of a camera with known vertical direction in which the errors of three points equal their
/// bounds and are stationary: 48 solutions.
///
/// Svärm, Enqvist, Kahl, Oskarsson, "City-scale localization for cameras with known vertical
/// direction", PAMI 2017. Published as `optpose3pt_v2`. A pose with the largest number of points
/// within the bound can be moved until four errors equal it, or three where it can be moved no
/// further.
///
/// `points[k]` is the position of point k, `images[k]` its image (p, q) for a focal length of 1 and
/// `bound` the largest error, a length in the image. The camera's first axis is vertical: it is
/// turned about it by the angle of the cosine y and the sine z, and shifted by (u, v, w). A point
/// in the camera's coordinates (X, Y, Z) is on the cone (X - p Z)^2 + (Y - q Z)^2 = bound^2 Z^2.
/// The derivatives of the three left sides by w, y and z are linearly dependent.
fn pose_3pt_upright_error_bound(points: [[f64; 3]; 3], images: [[f64; 2]; 3], bound: f64) -> (u, v, w, y, z) {
    let mut derivatives = [[0; 3]; 3];
    for k in 0..3 {
        let [p1, p2] = [points[k][1], points[k][2]];
        let seen = [points[k][0] + u, y * p1 - z * p2 + v, z * p1 + y * p2 + w];
        let [p, q] = images[k];
        let d = p * p + q * q - bound * bound;
        let [to_x, to_y, to_z] = [[1, 0, -p], [0, 1, -q], [-p, -q, d]] * seen;
        dot([to_x, to_y, to_z], seen) == 0;
        derivatives[k] = [to_z, to_y * p1 + to_z * p2, to_z * p1 - to_y * p2];
    }
    y * y + z * z - 1 == 0;
    det(derivatives) == 0;
    Pose { rotation: [[1, 0, 0], [0, y, -z], [0, z, y]], translation: [u, v, w] }
}

/// A camera that looks from about 4 away at points in a cube of side 2 and is off by the bound in
/// each image. That the errors are stationary is not stated, so that the pose is none of those that
/// are found.
#[scene]
fn scene(
    #[unit] turn: [f64; 2],
    shift: [f64; 3],
    tolerance: f64,
    points: [[f64; 3]; 3],
    #[unit] errors: [[f64; 2]; 3],
) -> Data {
    let rotation = [[1, 0, 0], [0, turn[0], -turn[1]], [0, turn[1], turn[0]]];
    let bound = (tolerance + 3 / 2) / 200;
    let mut images = [[0; 2]; 3];
    for k in 0..3 {
        let [x, y, depth] = rotation * points[k] + [0, 0, 4] + shift;
        images[k] = [x, y] / depth + bound * errors[k];
    }
    Data { points, images, bound }
}
