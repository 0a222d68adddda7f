/// Triangulation from three views, all stationary points of the sum of squared reprojection errors:
/// 47 solutions.
///
/// Stewénius, Schaffalitzky, Nistér, "How hard is 3-view triangulation really?", ICCV 2005.
/// Published as `3v_triang_laurent`.
///
/// `cameras` are the projection matrices of the views and `images` where they see the point. The
/// unknowns are projective coordinates (x, y, z, 1) of the point: x and y its depths in the first
/// and second view over that in the third, each times a constant, and z its first error in the
/// third view. Every image is turned so that its second error does not depend on z, and scales are
/// such that in the errors of the first two views over their depths, x and y, z has the
/// coefficient 1. The planes of depth zero must meet in one point: the three images must not all be
/// parallel, as rectified ones are.
///
/// Stated are derivatives towards seven points. Where the depth of a view vanishes, so does a power
/// of it in the denominators; where the errors of a view vanish, too, at its centre, they do not
/// change at all.
fn triangulation_3view(cameras: [[[f64; 4]; 3]; 3], images: [[f64; 2]; 3]) -> (x, y, z) {
    // The point at depth zero in all views: what it changes in an image is the first direction.
    let axis = null_space([cameras[0][2], cameras[1][2], cameras[2][2]])[0];
    let mut turned = [[[0; 4]; 2]; 3];
    let mut scales = [0; 3];
    for k in 0..3 {
        let [across, down, depth] = cameras[k];
        let errors = [across - images[k][0] * depth, down - images[k][1] * depth];
        let along = errors * axis;
        let [cos, sin] = normalise(along);
        turned[k] = [[cos, sin], [-sin, cos]] * errors;
        scales[k] = norm(along);
    }
    let units = [scales[2] / scales[0], scales[2] / scales[1]];
    let to_world = inverse([units[0] * cameras[0][2], units[1] * cameras[1][2], turned[2][0], cameras[2][2]]);
    let first = units[0] * turned[0] * to_world;
    let second = units[1] * turned[1] * to_world;
    let third = turned[2][1] * to_world;
    let a = [[first[0][0], first[0][1], 1, first[0][3]], [first[1][0], first[1][1], 0, first[1][3]]];
    let b = [[second[0][0], second[0][1], 1, second[0][3]], [second[1][0], second[1][1], 0, second[1][3]]];
    let c = [[0, 0, 1, 0], [third[0], third[1], 0, third[3]]];
    let [by_x, by_y, by_z, by_1] = identity(4);
    slope(a, by_z, x, y, z) * y * y + slope(b, by_z, x, y, z) * x * x + slope(c, by_z, x, y, z) * x * x * y * y == 0;

    // Centres.
    let [e, f] = a;
    let to = [0, -f[3], e[1] * f[3] - e[3] * f[1], f[1]];
    change(b, to, y, to[1], x, y, z) + y.pow(3) * change(c, to, 1, to[3], x, y, z) == 0;
    let [e, f] = b;
    let to = [-f[3], 0, e[0] * f[3] - e[3] * f[0], f[0]];
    change(a, to, x, to[0], x, y, z) + x.pow(3) * change(c, to, 1, to[3], x, y, z) == 0;
    let to = [third[1], -third[0], 0, 0];
    y.pow(3) * change(a, to, x, to[0], x, y, z) + x.pow(3) * change(b, to, y, to[1], x, y, z) == 0;

    // Points at which two depths vanish.
    y * y * change(a, by_x, x, 1, x, y, z)
        + x.pow(3) * slope(b, by_x, x, y, z)
        + x.pow(3) * y * y * slope(c, by_x, x, y, z)
        == 0;
    y.pow(3) * slope(a, by_y, x, y, z)
        + x * x * change(b, by_y, y, 1, x, y, z)
        + x * x * y.pow(3) * slope(c, by_y, x, y, z)
        == 0;
    y * y * slope(a, by_1, x, y, z)
        + x * x * slope(b, by_1, x, y, z)
        + x * x * y * y * change(c, by_1, 1, 1, x, y, z)
        == 0;
    x != 0;
    y != 0;
    let point = to_world * [x, y, z, 1];
    Point { position: [point[0], point[1], point[2]] / point[3] }
}

/// Half the derivative of the squared errors of a view towards a point at which its depth vanishes,
/// times the square of the depth.
fn slope(view: [[f64; 4]; 2], to: [f64; 4], x: f64, y: f64, z: f64) -> f64 {
    dot(view * [x, y, z, 1], view * to)
}

/// The same towards any point, times the cube of the depth.
fn change(view: [[f64; 4]; 2], to: [f64; 4], depth: f64, depth_there: f64, x: f64, y: f64, z: f64) -> f64 {
    let error = view * [x, y, z, 1];
    depth * dot(error, view * to) - depth_there * dot(error, error)
}

/// Three cameras at random that look from about 4 away at a point in a cube of side 2.
#[scene]
fn scene(#[rotation] rotations: [[[f64; 3]; 3]; 3], shifts: [[f64; 3]; 3], position: [f64; 3]) -> (Data, Point) {
    let mut cameras = [[[0; 4]; 3]; 3];
    let mut images = [[0; 2]; 3];
    for k in 0..3 {
        let translation = [0, 0, 4] + shifts[k];
        for i in 0..3 {
            cameras[k][i] = concat(rotations[k][i], translation[i]);
        }
        let [x, y, depth] = rotations[k] * position + translation;
        images[k] = [x, y] / depth;
    }
    (Data { cameras, images }, Point { position })
}
