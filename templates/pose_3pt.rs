/// Pose of a calibrated camera from three points: at most 4 of 8 solutions, in front of the camera.
///
/// The problem `pose_3pt_depths` from measurements. `rays[k]` is the ray of point k in the camera,
/// of any length, and `points[k]` its position. The unknowns are the distances of the points from
/// the centre of the camera. A point x has the coordinates `rotation` x + `translation` in the
/// camera: the rotation takes the differences of positions, and their cross product, to those in
/// the camera.
fn pose_3pt(rays: [[f64; 3]; 3], points: [[f64; 3]; 3]) -> (distances: [f64; 3]) {
    let rays = [normalise(rays[0]), normalise(rays[1]), normalise(rays[2])];
    let positions = [distances[0] * rays[0], distances[1] * rays[1], distances[2] * rays[2]];
    for [i, j] in [[0, 1], [1, 2], [2, 0]] {
        let [seen, known] = [positions[i] - positions[j], points[i] - points[j]];
        dot(seen, seen) == dot(known, known);
    }
    for distance in distances {
        distance > 0;
    }
    let seen = [positions[1] - positions[0], positions[2] - positions[0]];
    let known = [points[1] - points[0], points[2] - points[0]];
    let seen = [seen[0], seen[1], cross(seen[0], seen[1])].t();
    let known = [known[0], known[1], cross(known[0], known[1])].t();
    let rotation = seen * inverse(known);
    Pose { rotation: rotation, translation: positions[0] - rotation * points[0] }
}

/// A camera that looks from about 4 away at points in a cube of side 2.
#[scene]
fn scene(
    #[rotation] rotation: [[f64; 3]; 3],
    shift: [f64; 3],
    points: [[f64; 3]; 3],
) -> (Data, Pose) {
    let translation = [0, 0, 4] + shift;
    let mut rays = points;
    for k in 0..3 {
        let seen = rotation * points[k] + translation;
        rays[k] = seen / seen[2];
    }
    (Data { rays, points }, Pose { rotation, translation })
}
