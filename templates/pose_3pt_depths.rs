/// Pose of a calibrated camera from three points: their distances from the centre of the camera, 8
/// solutions, which are 4 with both signs.
///
/// Grunert, "Das Pothenotische Problem in erweiterter Gestalt", 1841; in this form Haralick, Lee,
/// Ottenberg, Nölle, "Review and analysis of solutions of the three point perspective pose
/// estimation problem", IJCV 1994, equation (1).
///
/// `cosines` are those of the angles between the viewing rays of the points b and c, a and c, a and
/// b; `squares` the squared distances of these points. Those of the solutions are poses in which
/// all depths are positive.
fn pose_3pt_depths(cosines: [f64; 3], squares: [f64; 3]) -> (a, b, c) {
    b * b + c * c - 2 * cosines[0] * b * c == squares[0];
    a * a + c * c - 2 * cosines[1] * a * c == squares[1];
    a * a + b * b - 2 * cosines[2] * a * b == squares[2];
}
