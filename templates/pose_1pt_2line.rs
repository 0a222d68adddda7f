/// Pose of a calibrated camera from a point and two lines: 8 solutions, of which those with the
/// point in front of the camera are returned.
///
/// Ramalingam, Bouaziz, Sturm, "Pose estimation using both points and lines for geo-localization",
/// ICRA 2011; in this form Zhou, Ye, Kaess, "A stable algebraic camera pose estimation for minimal
/// configurations of 2D/3D point and line correspondences", ACCV 2018.
///
/// `ray` is the ray of the point in the camera, of any length, and `point` its position.
/// `normals[k]` is the image of line k: the plane through it and the centre of the camera is
/// perpendicular to that vector, of any length. It is the cross product of the rays of two points
/// of the image. `lines[k]` are two points of the line in space, other ones than the rays are of,
/// if need be. A point X has the coordinates `rotation` X + `translation` in the camera, and
/// `quaternion` is that of the rotation. The depth of the point along its ray is eliminated.
fn pose_1pt_2line(
    ray: [f64; 3],
    point: [f64; 3],
    normals: [[f64; 3]; 2],
    lines: [[[f64; 3]; 2]; 2],
) -> (#[projective] quaternion: [f64; 4]) {
    let rotation = rotation_of(quaternion);
    let mut across = [0; 2];
    let mut heights = [0; 2];
    for k in 0..2 {
        dot(normals[k], rotation * (lines[k][1] - lines[k][0])) == 0;
        across[k] = dot(normals[k], ray);
        heights[k] = dot(normals[k], rotation * (lines[k][0] - point));
    }
    // Line k is in its plane at this depth: heights[k] + depth across[k] = 0.
    across[1] * heights[0] - across[0] * heights[1] == 0;
    let depth = -dot(across, heights) / dot(across, across);
    depth > 0;
    Pose { rotation: rotation, translation: depth * ray - rotation * point }
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

/// A camera that looks from about 4 away at a point and lines in a cube of side 2.
#[scene]
fn scene(
    #[rotation] rotation: [[f64; 3]; 3],
    shift: [f64; 3],
    point: [f64; 3],
    lines: [[[f64; 3]; 2]; 2],
) -> (Data, Pose) {
    let translation = [0, 0, 4] + shift;
    let ray = normalise(rotation * point + translation);
    let mut normals = [[0; 3]; 2];
    for k in 0..2 {
        let [from, to] = lines[k];
        normals[k] = normalise(cross(rotation * from + translation, rotation * to + translation));
    }
    (Data { ray, point, normals, lines }, Pose { rotation, translation })
}
