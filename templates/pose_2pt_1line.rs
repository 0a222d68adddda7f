/// Pose of a calibrated camera from two points and a line: at most 2 solutions, those with the
/// points in front of the camera.
///
/// Ramalingam, Bouaziz, Sturm, "Pose estimation using both points and lines for geo-localization",
/// ICRA 2011, who have 4 solutions, which are 2 with both signs of the depths.
///
/// `rays[k]` is the ray of point k in the camera, of any length, and `points[k]` its position.
/// `normal` is the image of the line: the plane through it and the centre of the camera is
/// perpendicular to that vector, of any length. It is the cross product of the rays of two points
/// of the image. `line` are two points of the line in space, other ones than the rays are of, if
/// need be. A point X has the coordinates `rotation` X + `translation` in the camera. In the frame
/// of the points the normal is perpendicular to the line: it is the sum of two vectors that are,
/// each times its weight. The depths of the points along their rays are linear in it, since it is
/// perpendicular to the plane, and the distance of the points gives a quadratic equation. The
/// points must not lie on the line, nor their images on its image.
fn pose_2pt_1line(
    rays: [[f64; 3]; 2],
    points: [[f64; 3]; 2],
    normal: [f64; 3],
    line: [[f64; 3]; 2],
) -> (#[projective] weights: [f64; 2]) {
    let known = weights * null_space([line[1] - line[0]]);
    let length = norm(normal);
    let depths = [
        length * dot(known, points[0] - line[0]) / dot(normal, rays[0]),
        length * dot(known, points[1] - line[0]) / dot(normal, rays[1]),
    ];
    let seen = normal / length;
    let known_side = points[1] - points[0];
    let side = depths[1] * rays[1] - depths[0] * rays[0];
    dot(side, side) == dot(weights, weights) * dot(known_side, known_side);
    depths[0] * depths[1] > 0;
    Pose {
        rotation: rotation_of(known, seen, known_side, side, sign_of(depths[0])),
        translation: depths[0] * sign_of(depths[0]) * rays[0]
            - rotation_of(known, seen, known_side, side, sign_of(depths[0])) * points[0],
    }
}

fn sign_of(x: f64) -> f64 {
    x * sqrt(1 / (x * x))
}

/// Takes a normal and a side in the frame of the points to those in the camera, which are known up
/// to a sign.
fn rotation_of(known: _, seen: _, known_side: _, side: _, sign: f64) -> [[f64; 3]; 3] {
    let across = cross(known, known_side);
    let to_dual = [cross(known_side, across), cross(across, known), across];
    [sign * seen, sign * side, cross(seen, side)].t() * to_dual / dot(across, across)
}

/// A camera that looks from about 4 away at points and a line in a cube of side 2.
#[scene]
fn scene(
    #[rotation] rotation: [[f64; 3]; 3],
    shift: [f64; 3],
    points: [[f64; 3]; 2],
    line: [[f64; 3]; 2],
) -> (Data, Pose) {
    let translation = [0, 0, 4] + shift;
    let rays = [
        normalise(rotation * points[0] + translation), normalise(rotation * points[1] + translation),
    ];
    let normal = normalise(cross(rotation * line[0] + translation, rotation * line[1] + translation));
    (Data { rays, points, normal, line }, Pose { rotation, translation })
}
