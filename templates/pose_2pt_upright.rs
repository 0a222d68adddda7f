/// Pose of a camera whose vertical is known, as by an inertial sensor, from two points: 2
/// solutions.
///
/// Kukelova, Bujnak, Pajdla, "Closed-form solutions to minimal absolute pose problems with known
/// vertical direction", ACCV 2010; here by the depths, as Haralick, Lee, Ottenberg, Nölle, IJCV
/// 1994, state the pose from three points.
///
/// `rays[k]` is the ray of point k in a frame of the camera whose y axis is vertical, of any
/// length, and `points[k]` its position in a world with the same vertical. The unknowns are the
/// depths along the rays. A pose X -> rotation X + translation takes the world to the camera; the
/// rotation is about the y axis, and both points are in front. The points must not be above each
/// other, nor both rays level.
fn pose_2pt_upright(rays: [[f64; 3]; 2], points: [[f64; 3]; 2]) -> (a, b) {
    let seen = a * rays[0] - b * rays[1];
    let given = points[0] - points[1];
    let square = given[0].pow(2) + given[2].pow(2);
    seen[1] == given[1];
    seen[0].pow(2) + seen[2].pow(2) == square;
    a > 0;
    b > 0;
    let c = (seen[0] * given[0] + seen[2] * given[2]) / square;
    let s = (seen[0] * given[2] - seen[2] * given[0]) / square;
    let rotation = [[c, 0, s], [0, 1, 0], [-s, 0, c]];
    Pose { rotation: rotation, translation: a * rays[0] - rotation * points[0] }
}

/// A camera that looks from about 4 away at points in a cube of side 2.
#[scene]
fn scene(#[unit] turn: [f64; 2], shift: [f64; 3], points: [[f64; 3]; 2]) -> (Data, Pose) {
    let [c, s] = turn;
    let rotation = [[c, 0, s], [0, 1, 0], [-s, 0, c]];
    let translation = [0, 0, 4] + shift;
    let mut rays = points;
    for k in 0..2 {
        let seen = rotation * points[k] + translation;
        rays[k] = seen / seen[2];
    }
    (Data { rays, points }, Pose { rotation, translation })
}
