/// Pose of a calibrated camera from n points, all stationary points of a least-squares cost over the rotations, by Cayley
/// parameters: 40 solutions.
///
/// Nakano, "Globally optimal DLS method for PnP problem with Cayley parameterization", BMVC 2015. Published as `opt_pnp_nakanoC`.
///
/// With the best translation and the best depths the cost is r^T `cost` r, r being the entries of the rotation R, row by row. Let G be the
/// matrix of the entries of `cost` r. R is stationary if R^T G and G R^T are symmetric; either implies the other. R is that of the quaternion
/// (1, x, y, z) times 1 + x^2 + y^2 + z^2.
fn pose_npt_least_squares_cayley(#[symmetric] cost: [[f64; 9]; 9]) -> (x, y, z) {
    let turn = [
        [1 + x * x - y * y - z * z, 2 * (x * y - z), 2 * (x * z + y)],
        [2 * (x * y + z), 1 - x * x + y * y - z * z, 2 * (y * z - x)],
        [2 * (x * z - y), 2 * (y * z + x), 1 - x * x - y * y + z * z],
    ];
    let entries = [
        turn[0][0], turn[0][1], turn[0][2], turn[1][0], turn[1][1], turn[1][2], turn[2][0], turn[2][1], turn[2][2],
    ];
    let g = cost * entries;
    let slope = [[g[0], g[1], g[2]], [g[3], g[4], g[5]], [g[6], g[7], g[8]]];
    let inner = turn.t() * slope;
    let outer = slope * turn.t();
    for i in 0..3 {
        inner[i][(i + 1) % 3] - inner[(i + 1) % 3][i] == 0;
        outer[i][(i + 1) % 3] - outer[(i + 1) % 3][i] == 0;
    }
}
