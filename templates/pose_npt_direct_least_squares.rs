/// Pose of a calibrated camera from n points, all stationary points of a least-squares cost in
/// Cayley parameters: 27 solutions.
///
/// Hesch, Roumeliotis, "A direct least-squares (DLS) method for PnP", ICCV 2011. Published as
/// `opt_pnp_hesch`.
///
/// The cost is the mean squared distance of the points from the rays along which the camera sees
/// them, with the best translation, which is linear in the rotation. Without the common denominator
/// 1 + x^2 + y^2 + z^2 of the rotation of the quaternion (1, x, y, z) it is a polynomial of degree
/// four. `means` are those of `of_point` over 3 points or more. Rounding errors are smallest if the
/// origin is amid the points. Half turns would be at infinity. Points are turned before, so that
/// none of the poses that are at infinity is one that scenes are made of.
fn pose_npt_direct_least_squares(#[mean(of_point)] means: [[f64; 10]; 6]) -> (x, y, z) {
    let turned = [
        [1 + x * x - y * y - z * z, 2 * (x * y - z), 2 * (x * z + y)],
        [2 * (x * y + z), 1 - x * x + y * y - z * z, 2 * (y * z - x)],
        [2 * (x * z - y), 2 * (y * z + x), 1 - x * x - y * y + z * z],
    ];
    let entries = reshape(turned, [9]);
    let best = best_translation(means);
    let cost = cost_of_rotation(means, best);
    gradient(dot(entries, cost * entries)) == 0;
    let length = 1 + x * x + y * y + z * z;
    Pose { rotation: turned * frame() / length, translation: best * entries / length }
}

/// What a point gives: the products of its coordinates and 1, times the entries of the projection
/// across its ray. `ray` is the ray of the point in the camera, of any length.
fn of_point(ray: [f64; 3], point: [f64; 3]) -> [[f64; 10]; 6] {
    let [a, b, c] = ray;
    let [x, y, z] = frame() * point;
    let square = dot(ray, ray);
    let across = [square - a * a, -a * b, -a * c, square - b * b, -b * c, square - c * c] / square;
    let products = [x * x, x * y, x * z, x, y * y, y * z, y, z * z, z, 1];
    let mut given = [[0; 10]; 6];
    for i in 0..6 {
        given[i] = across[i] * products;
    }
    given
}

/// The quaternion of the rotation to the frame in which unknowns are solved for.
const FRAME: [f64; 4] = [23, 14, 3, 19];

/// Its rotation.
fn frame() -> [[f64; 3]; 3] {
    let [w, x, y, z] = FRAME;
    [
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ] / dot(FRAME, FRAME)
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
