/// Pose of a calibrated camera from n points, all stationary points of a least-squares cost over
/// the rotations, by Cayley parameters: 40 solutions.
///
/// Nakano, "Globally optimal DLS method for PnP problem with Cayley parameterization", BMVC 2015.
/// Published as `opt_pnp_nakanoC`.
///
/// The cost is the mean squared distance of the points from the rays along which the camera sees
/// them, with the best translation, which is linear in the rotation: r^T `cost` r, r being the
/// entries of the rotation of the quaternion q, row by row. With r times |q|^2 in its place the
/// cost grows with the fourth power of the length of q, so q is stationary up to its length where
/// the gradient d is parallel to it. `means` are those of `of_point` over 3 points or more.
/// Rounding errors are smallest if the origin is amid the points.
fn pose_npt_least_squares_cayley(#[mean(of_point)] means: [[f64; 10]; 6]) -> (#[projective] q: [f64; 4]) {
    let [w, x, y, z] = q;
    let entries = [
        w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),
        2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x),
        2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z,
    ];
    // Half of their derivatives by the entries of q.
    let slopes = [
        [w, -z, y, z, w, -x, -y, x, w],
        [x, y, z, y, -x, -w, z, w, -x],
        [-y, x, w, x, y, z, -w, z, -y],
        [-z, -w, x, w, -z, y, x, y, z],
    ];
    let best = best_translation(means);
    let cost = cost_of_rotation(means, best);
    let d = slopes * (cost * entries);
    for i in 0..4 {
        for j in 0..i {
            d[i] * q[j] - d[j] * q[i] == 0;
        }
    }
    Pose { rotation: reshape(entries, [3, 3]), translation: best * entries }
}

/// What a point gives: the products of its coordinates and 1, times the entries of the projection
/// across its ray. `ray` is the ray of the point in the camera, of any length.
fn of_point(ray: [f64; 3], point: [f64; 3]) -> [[f64; 10]; 6] {
    let [a, b, c] = ray;
    let [x, y, z] = point;
    let square = dot(ray, ray);
    let across = [square - a * a, -a * b, -a * c, square - b * b, -b * c, square - c * c] / square;
    let products = [x * x, x * y, x * z, x, y * y, y * z, y, z * z, z, 1];
    let mut given = [[0; 10]; 6];
    for i in 0..6 {
        given[i] = across[i] * products;
    }
    given
}

/// Where the entries of symmetric matrices stand in the means.
const ACROSS: [[f64; 3]; 3] = [[0, 1, 2], [1, 3, 4], [2, 4, 5]];
const PRODUCTS: [[f64; 4]; 4] = [[0, 1, 2, 3], [1, 4, 5, 6], [2, 5, 7, 8], [3, 6, 8, 9]];

/// The translation that is best for a rotation, as a matrix times the entries of the latter.
fn best_translation(means: [[f64; 10]; 6]) -> [[f64; 9]; 3] {
    let mut of_translation = [[0; 3]; 3];
    let mut of_rotation = [[0; 9]; 3];
    for i in 0..3 {
        for j in 0..3 {
            of_translation[i][j] = means[ACROSS[i][j]][9];
            for k in 0..3 {
                of_rotation[i][3 * j + k] = -means[ACROSS[i][j]][PRODUCTS[k][3]];
            }
        }
    }
    solve(of_translation, of_rotation)
}

/// The cost as a quadratic form in the entries of the rotation.
fn cost_of_rotation(means: [[f64; 10]; 6], best: [[f64; 9]; 3]) -> [[f64; 9]; 9] {
    let mut cost = [[0; 9]; 9];
    for i in 0..3 {
        for j in 0..3 {
            for k in 0..3 {
                for l in 0..3 {
                    let of_translation = [
                        means[ACROSS[i][0]][PRODUCTS[j][3]], means[ACROSS[i][1]][PRODUCTS[j][3]],
                        means[ACROSS[i][2]][PRODUCTS[j][3]],
                    ];
                    let best_of_entry = [best[0][3 * k + l], best[1][3 * k + l], best[2][3 * k + l]];
                    cost[3 * i + j][3 * k + l] =
                        means[ACROSS[i][k]][PRODUCTS[j][l]] + dot(of_translation, best_of_entry);
                }
            }
        }
    }
    cost
}

/// A camera that looks from about 4 away at 8 points in a cube of side 2.
#[scene]
fn scene(
    #[rotation] rotation: [[f64; 3]; 3],
    shift: [f64; 3],
    points: [[f64; 3]; 8],
) -> (Data, Pose) {
    let translation = [0, 0, 4] + shift;
    let mut means = [[0; 10]; 6];
    for point in points {
        let seen = rotation * point + translation;
        means += of_point(seen / seen[2], point) / 8;
    }
    (Data { means }, Pose { rotation, translation })
}
