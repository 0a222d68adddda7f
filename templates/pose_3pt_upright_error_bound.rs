/// Poses of a camera with known vertical direction in which the errors of three points equal their
/// bounds and are stationary: 48 solutions.
///
/// Svärm, Enqvist, Kahl, Oskarsson, "City-scale localization for cameras with known vertical
/// direction", PAMI 2017. Published as `optpose3pt_v2`. A pose with the largest number of points
/// within the bound can be moved until four errors equal it, or three where it can be moved no
/// further.
///
/// The camera is turned about its first axis by the angle of the cosine y and the sine z, and
/// shifted by (u, v, w). A point of `points`, one a row, in the camera's coordinates (X, Y, Z),
/// lies on the cone a X^2 + a Y^2 + 2 b X Z + 2 c Y Z + d Z^2 = 0 with (a, b, c, d) a row of
/// `cones`: for an image point (p, q) and a bound e that is (1, -p, -q, p^2 + q^2 - e^2). The
/// derivatives of the three left sides by w, y and z are linearly dependent.
fn pose_3pt_upright_error_bound(points: [[f64; 3]; 3], cones: [[f64; 4]; 3]) -> (u, v, w, y, z) {
    let mut derivatives = [[0; 3]; 3];
    for k in 0..3 {
        let [p1, p2] = [points[k][1], points[k][2]];
        let seen = [points[k][0] + u, y * p1 - z * p2 + v, z * p1 + y * p2 + w];
        let [a, b, c, d] = cones[k];
        let [to_x, to_y, to_z] = [[a, 0, b], [0, a, c], [b, c, d]] * seen;
        dot([to_x, to_y, to_z], seen) == 0;
        derivatives[k] = [to_z, to_y * p1 + to_z * p2, to_z * p1 - to_y * p2];
    }
    y * y + z * z - 1 == 0;
    det(derivatives) == 0;
}
