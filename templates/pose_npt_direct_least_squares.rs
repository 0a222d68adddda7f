/// Pose of a calibrated camera from n points, all stationary points of a least-squares cost in
/// Cayley parameters: 27 solutions.
///
/// Hesch, Roumeliotis, "A direct least-squares (DLS) method for PnP", ICCV 2011. Published as
/// `opt_pnp_hesch`.
///
/// For a given rotation the best translation is linear in the rotation. Without the common
/// denominator 1 + x^2 + y^2 + z^2 of the rotation of the quaternion (1, x, y, z), the sum of
/// squares that remains is a polynomial of degree four; its coefficients are data, those of one
/// degree in lexicographic order. Of the constant nothing depends.
fn pose_npt_direct_least_squares(
    linear: [f64; 3],
    quadratic: [f64; 6],
    cubic: [f64; 10],
    quartic: [f64; 15],
) -> (x, y, z) {
    let squares = [x * x, x * y, x * z, y * y, y * z, z * z];
    let by_x = x * squares;
    let by_y = y * [squares[3], squares[4], squares[5]];
    let cubes = [
        by_x[0], by_x[1], by_x[2], by_x[3], by_x[4], by_x[5], by_y[0], by_y[1], by_y[2], z * z * z,
    ];
    let fourth = x * cubes;
    let rest = y * [cubes[6], cubes[7], cubes[8], cubes[9]];
    let fourths = [
        fourth[0], fourth[1], fourth[2], fourth[3], fourth[4], fourth[5], fourth[6], fourth[7], fourth[8], fourth[9],
        rest[0], rest[1], rest[2], rest[3], z * cubes[9],
    ];
    let cost = dot(linear, [x, y, z]) + dot(quadratic, squares) + dot(cubic, cubes) + dot(quartic, fourths);
    gradient(cost) == 0;
    let turned = [
        [1 + x * x - y * y - z * z, 2 * (x * y - z), 2 * (x * z + y)],
        [2 * (x * y + z), 1 - x * x + y * y - z * z, 2 * (y * z - x)],
        [2 * (x * z - y), 2 * (y * z + x), 1 - x * x - y * y + z * z],
    ];
    Orientation { rotation: turned / (1 + x * x + y * y + z * z) }
}
