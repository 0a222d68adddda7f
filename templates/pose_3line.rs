/// Pose of a calibrated camera from three lines: 8 solutions.
///
/// Dhome, Richetin, Lapresté, Rives, "Determination of the attitude of 3D objects from a single
/// perspective view", PAMI 1989; in this form Zhou, Ye, Kaess, "A stable algebraic camera pose
/// estimation for minimal configurations of 2D/3D point and line correspondences", ACCV 2018.
///
/// `normals[k]` is the image of line k: the plane through it and the centre of the camera is
/// perpendicular to that vector, of any length. It is the cross product of the rays of two points
/// of the image. `lines[k]` are two points of the line in space, other ones than the rays are of,
/// if need be. A point X has the coordinates `rotation` X + `translation` in the camera, and
/// `quaternion` is that of the rotation: `normals[k]` is perpendicular to the turned direction of
/// line k. Three planes give the translation. The lines must not be parallel, nor the planes meet
/// in a line.
fn pose_3line(normals: [[f64; 3]; 3], lines: [[[f64; 3]; 2]; 3]) -> (
    #[projective] quaternion: [f64; 4],
) {
    let rotation = rotation_of(quaternion);
    for k in 0..3 {
        dot(normals[k], rotation * (lines[k][1] - lines[k][0])) == 0;
    }
    let mut offsets = [0; 3];
    for k in 0..3 {
        offsets[k] = dot(normals[k], rotation * lines[k][0]);
    }
    Pose { rotation: rotation, translation: -inverse(normals) * offsets }
}

/// The rotation of a quaternion of length 1.
fn rotation_of(quaternion: [f64; 4]) -> [[f64; 3]; 3] {
    let [w, x, y, z] = quaternion;
    [
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ]
}

/// A camera that looks from about 4 away at lines in a cube of side 2.
#[scene]
fn scene(
    #[rotation] rotation: [[f64; 3]; 3],
    shift: [f64; 3],
    lines: [[[f64; 3]; 2]; 3],
) -> (Data, Pose) {
    let translation = [0, 0, 4] + shift;
    let mut normals = [[0; 3]; 3];
    for k in 0..3 {
        let [from, to] = lines[k];
        normals[k] = normalise(cross(rotation * from + translation, rotation * to + translation));
    }
    (Data { normals, lines }, Pose { rotation, translation })
}
