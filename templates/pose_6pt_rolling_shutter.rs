/// Pose and motion of a camera with rolling shutter from six points: 20 solutions.
///
/// Albl, Kukelova, Pajdla, "R6P - rolling shutter absolute camera pose", CVPR 2015. Published as
/// `r6p`.
///
/// `points[k]` is the position of a point and `images[k]` its image, in units of the focal length.
/// A point X is seen at q, in the row q\[0\], where (q, 1) and (I + q\[0\] \[(x, y, z)\]x) (I +
/// \[(u, v, w)\]x) X + C + q\[0\] t are parallel: both rotations linearised, the first for an
/// angular velocity. Three of the points, linear in the position C and the velocity t, give them as
/// position m and velocity m, m being the products of x, y, z (slower) with u, v, w, and then u, v,
/// w, x, y, z, 1.
fn pose_6pt_rolling_shutter(points: [[f64; 3]; 6], images: [[f64; 2]; 6]) -> (u, v, w, x, y, z) {
    let mut leading = [[0; 6]; 6];
    let mut others = [[0; 16]; 6];
    for k in 0..3 {
        let [row, column] = images[3 + k];
        let turned = turned(points[3 + k], row);
        leading[2 * k] = [0, -1, column, 0, -row, row * column];
        leading[2 * k + 1] = [1, 0, -row, row, 0, -row * row];
        others[2 * k] = turned[1] - column * turned[2];
        others[2 * k + 1] = row * turned[2] - turned[0];
    }
    let solved = solve(leading, others);
    let monomials = [u * x, v * x, w * x, u * y, v * y, w * y, u * z, v * z, w * z, u, v, w, x, y, z, 1];
    let [position, velocity] =
        [[solved[0], solved[1], solved[2]] * monomials, [solved[3], solved[4], solved[5]] * monomials];
    for k in 0..3 {
        let [row, column] = images[k];
        let turned = points[k] + cross([u, v, w], points[k]);
        let seen = turned + row * cross([x, y, z], turned) + position + row * velocity;
        column * seen[2] - seen[1] == 0;
        seen[0] - row * seen[2] == 0;
    }
    RollingPose {
        rotation: identity(3) + skew([u, v, w]),
        position: position,
        angular_velocity: [x, y, z],
        velocity: velocity,
    }
}

/// The coefficients of the monomials in (I + row \[(x, y, z)\]x) (I + \[(u, v, w)\]x) X, one row
/// for each coordinate.
fn turned(point: [f64; 3], row: f64) -> [[f64; 16]; 3] {
    let axes = identity(3);
    let mut columns = [[0; 3]; 16];
    for i in 0..3 {
        let turned = cross(axes[i], point);
        for j in 0..3 {
            columns[3 * j + i] = row * cross(axes[j], turned);
        }
        columns[9 + i] = turned;
        columns[12 + i] = row * turned;
    }
    columns[15] = point;
    columns.t()
}

/// Points 3 to 5 away from a camera that turns and moves little while it takes the image.
#[scene]
fn scene(
    turn: [f64; 3],
    angular: [f64; 3],
    position: [f64; 3],
    moved: [f64; 3],
    depths: [f64; 6],
    places: [[f64; 2]; 6],
) -> (Data, RollingPose) {
    let rotation = identity(3) + skew(turn / 20);
    let angular_velocity = angular / 20;
    let velocity = moved / 20;
    let images = places / 2;
    let mut points = [[0; 3]; 6];
    for k in 0..6 {
        let [row, column] = images[k];
        let seen = (4 + depths[k]) * [row, column, 1] - position - row * velocity;
        points[k] = solve((identity(3) + row * skew(angular_velocity)) * rotation, seen);
    }
    (Data { points, images }, RollingPose { rotation, position, angular_velocity, velocity })
}
