/// Poses of a camera with known vertical direction in which the errors of four points equal their
/// bounds: 28 solutions.
///
/// Svärm, Enqvist, Kahl, Oskarsson, "City-scale localization for cameras with known vertical
/// direction", PAMI 2017. Published as `optpose4pt_v2`. A pose with the largest number of points
/// within the bound can be moved until four errors equal it.
///
/// `points[k]` is the position of point k, `images[k]` its image (p, q) for a focal length of 1 and
/// `bound` the largest error, a length in the image. The camera's first axis is vertical: it is
/// turned about it by the angle of the cosine y and the sine z, and shifted by (u, v, w). A point
/// in the camera's coordinates (X, Y, Z) is on the cone (X - p Z)^2 + (Y - q Z)^2 = bound^2 Z^2.
fn pose_4pt_upright_error_bound(points: [[f64; 3]; 4], images: [[f64; 2]; 4], bound: f64) -> (u, v, w, y, z) {
    for k in 0..4 {
        let seen = [points[k][0] + u, y * points[k][1] - z * points[k][2] + v, z * points[k][1] + y * points[k][2] + w];
        let [p, q] = images[k];
        let round = seen[0] * seen[0] + seen[1] * seen[1];
        let along = p * seen[0] + q * seen[1];
        round - 2 * along * seen[2] + (p * p + q * q - bound * bound) * seen[2] * seen[2] == 0;
    }
    y * y + z * z - 1 == 0;
    Pose { rotation: [[1, 0, 0], [0, y, -z], [0, z, y]], translation: [u, v, w] }
}

/// A camera that looks from about 4 away at points in a cube of side 2 and is off by the bound in
/// each image.
#[scene]
fn scene(
    #[unit] turn: [f64; 2],
    shift: [f64; 3],
    tolerance: f64,
    points: [[f64; 3]; 4],
    #[unit] errors: [[f64; 2]; 4],
) -> (Data, Pose) {
    let rotation = [[1, 0, 0], [0, turn[0], -turn[1]], [0, turn[1], turn[0]]];
    let translation = [0, 0, 4] + shift;
    let bound = (tolerance + 3 / 2) / 200;
    let mut images = [[0; 2]; 4];
    for k in 0..4 {
        let [x, y, depth] = rotation * points[k] + translation;
        images[k] = [x, y] / depth + bound * errors[k];
    }
    (Data { points, images, bound }, Pose { rotation, translation })
}
