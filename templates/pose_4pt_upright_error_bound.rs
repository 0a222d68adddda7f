/// Poses of a camera with known vertical direction in which the errors of four points equal their
/// bounds: 28 solutions.
///
/// Svärm, Enqvist, Kahl, Oskarsson, "City-scale localization for cameras with known vertical
/// direction", PAMI 2017. Published as `optpose4pt_v2`. A pose with the largest number of points
/// within the bound can be moved until four errors equal it.
///
/// The camera is turned about its first axis by the angle of the cosine y and the sine z, and
/// shifted by (u, v, w). A point of `points`, one a row, in the camera's coordinates (X, Y, Z),
/// lies on the cone a X^2 + a Y^2 + 2 b X Z + 2 c Y Z + d Z^2 = 0 with (a, b, c, d) a row of
/// `cones`: for an image point (p, q) and a bound e that is (1, -p, -q, p^2 + q^2 - e^2).
fn pose_4pt_upright_error_bound(points: [[f64; 3]; 4], cones: [[f64; 4]; 4]) -> (u, v, w, y, z) {
    for k in 0..4 {
        let seen = [
            points[k][0] + u,
            y * points[k][1] - z * points[k][2] + v,
            z * points[k][1] + y * points[k][2] + w,
        ];
        let round = seen[0] * seen[0] + seen[1] * seen[1];
        let along = cones[k][1] * seen[0] + cones[k][2] * seen[1];
        cones[k][0] * round + 2 * along * seen[2] + cones[k][3] * seen[2] * seen[2] == 0;
    }
    y * y + z * z - 1 == 0;
}
