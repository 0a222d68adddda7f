/// Pose and focal length of a camera from five points that calibrated cameras of known poses see,
/// too, and one point of known position: 56 solutions.
///
/// Bhayani, Sattler, Larsson, Heikkilä, Kukelova, "Partially calibrated semi-generalized pose from
/// hybrid point correspondences", WACV 2023. Published as `hyb51f`.
///
/// The known point is the origin; `centres` and `directions` are a point and the direction of the
/// ray that a calibrated camera sees each of the others along. `images` are those of the other
/// points, turned and scaled so that the image of the known point is (1, 0). Its depth is the
/// unknown `depth`. The camera's rotation is that of the quaternion 1 + x i + y j, and a turn about
/// its axis after it, by the angle of which c and s are cosine and sine, times the focal length. An
/// image lies on that of the ray: det(M) M^-T, the cofactors of M, maps moments of rays to lines of
/// the image where M maps directions to points of it. The squared norm of the quaternion, which
/// divides all cofactors, is left out.
fn relpose_5pt_semi_generalized_focal(
    images: [[f64; 2]; 5],
    directions: [[f64; 3]; 5],
    centres: [[f64; 3]; 5],
) -> (x, y, c, s, depth) {
    let norm = 1 + x * x + y * y;
    let rotation = [
        [1 + x * x - y * y, 2 * x * y, 2 * y],
        [2 * x * y, 1 - x * x + y * y, -2 * x],
        [-2 * y, 2 * x, 1 - x * x - y * y],
    ];
    let m = [[c, -s, 0], [s, c, 0], [0, 0, 1]] * rotation;
    let cofactors = [[c, -s, 0], [s, c, 0], [0, 0, c * c + s * s]] * rotation;
    for i in 0..5 {
        let image = [images[i][0], images[i][1], 1];
        let through_rotation = cofactors * cross(centres[i], directions[i]);
        let through_position = cross([depth, 0, depth], m * directions[i]);
        dot(image, through_rotation + through_position) == 0;
    }
    depth != 0;
    norm != 0;
}
