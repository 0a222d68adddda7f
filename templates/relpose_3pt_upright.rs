/// Relative pose of two cameras whose vertical is known, as by an inertial sensor, from three
/// points: 4 solutions.
///
/// Fraundorfer, Tanskanen, Pollefeys, "A minimal case solution to the calibrated relative pose
/// problem for the case of two known orientation angles", ECCV 2010.
///
/// `first[k]` and `second[k]` are the rays of point k in frames of the cameras whose y axes are
/// vertical, of any length. The unknowns are cosine and sine of the turn about the vertical. A pose
/// X -> rotation X + translation takes the frame of the first camera to that of the second. The
/// length of the translation is open, and so is its sign: with one of them the points are in front.
fn relpose_3pt_upright(first: [[f64; 3]; 3], second: [[f64; 3]; 3]) -> (c, s) {
    let rotation = [[c, 0, s], [0, 1, 0], [-s, 0, c]];
    let normals = [
        cross(second[0], rotation * first[0]),
        cross(second[1], rotation * first[1]),
        cross(second[2], rotation * first[2]),
    ];
    c * c + s * s == 1;
    det(normals) == 0;
    RelativePose { rotation: rotation, translation: cross(normals[0], normals[1]) }
}
