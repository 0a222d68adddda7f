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

/// A triangle in a cube of side 2, about 4 in front of the camera.
#[scene]
fn scene(points: [[f64; 3]; 3]) -> (Data, Solution) {
    let mut depths = [0; 3];
    let [mut cosines, mut squares] = [[0; 3], [0; 3]];
    for k in 0..3 {
        depths[k] = norm(points[k] + [0, 0, 4]);
    }
    for k in 0..3 {
        let [i, j] = [(k + 1) % 3, (k + 2) % 3];
        cosines[k] = dot(points[i] + [0, 0, 4], points[j] + [0, 0, 4]) / (depths[i] * depths[j]);
        squares[k] = dot(points[i] - points[j], points[i] - points[j]);
    }
    let [a, b, c] = depths;
    (Data { cosines, squares }, Solution { a, b, c })
}
