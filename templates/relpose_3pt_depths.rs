/// Relative pose of two calibrated cameras from three points with depths that are known up to scale
/// and shift, as a network estimates them from each image: at most 4 solutions.
///
/// Ding, Kocur, Vávra, Berger Haladová, Yang, Sattler, Kukelova, "RePoseD: Efficient relative pose
/// estimation with known depth information", ICCV 2025; Yu, Liu, Pautrat, Pollefeys, Larsson,
/// "Relative pose estimation through affine corrections of monocular depth priors", CVPR 2025.
///
/// `first[k]` and `second[k]` are the images of point k, (x, y) of the ray (x, y, 1), and
/// `first_depths[k]` and `second_depths[k]` its depths, the third coordinates, as estimated. The
/// point is at (`first_depths[k]` + u) (x, y, 1) in the first camera and at `scale`
/// (`second_depths[k]` + v) (x, y, 1) in the second; `shifts` are u and v. Squared distances of the
/// points are quadratic in the shifts, and those in the second camera are 1 / `scale`^2 of those in
/// the first. Three of them, solved for 1, u and u^2, give these times 1 / `scale`^2 as `powers`,
/// which are quadratic in v: the first times the third is the square of the second. A point X in
/// the first camera is at `rotation` X + `translation` in the second.
fn relpose_3pt_depths(
    first: [[f64; 2]; 3],
    first_depths: [f64; 3],
    second: [[f64; 2]; 3],
    second_depths: [f64; 3],
) -> (v) {
    let by_shift = solve(squares(first, first_depths), squares(second, second_depths));
    let powers = by_shift * [1, v, v * v];
    powers[1] * powers[1] == powers[0] * powers[2];
    powers[0] > 0;
    for k in 0..3 {
        first_depths[k] * powers[0] + powers[1] > 0;
        second_depths[k] + v > 0;
    }
    let images = [first, second];
    let depths = [first_depths, second_depths];
    DepthPose {
        rotation: rotation_of(images, depths, powers[1] / powers[0], v, sqrt(1 / powers[0])),
        translation: translation_of(images, depths, powers[1] / powers[0], v, sqrt(1 / powers[0])),
        scale: sqrt(1 / powers[0]),
        shifts: [powers[1] / powers[0], v],
    }
}

/// Takes two vectors between points, and their cross product, to those in the second camera.
fn rotation_of(images: _, depths: _, u: f64, v: f64, scale: f64) -> [[f64; 3]; 3] {
    let mut sides = [[[0; 3]; 2]; 2];
    for k in 0..2 {
        sides[0][k] = at(images[0], depths[0], u, k + 1) - at(images[0], depths[0], u, 0);
        sides[1][k] = scale * (at(images[1], depths[1], v, k + 1) - at(images[1], depths[1], v, 0));
    }
    let [[p, q], [r, s]] = sides;
    let normal = cross(p, q);
    [r, s, cross(r, s)].t() * [cross(q, normal), cross(normal, p), normal] / dot(normal, normal)
}

fn translation_of(images: _, depths: _, u: f64, v: f64, scale: f64) -> [f64; 3] {
    let rotation = rotation_of(images, depths, u, v, scale);
    scale * at(images[1], depths[1], v, 0) - rotation * at(images[0], depths[0], u, 0)
}

/// The squared distances of pairs of points: coefficients of 1, the shift, and its square.
fn squares(images: [[f64; 2]; 3], depths: [f64; 3]) -> [[f64; 3]; 3] {
    let mut rows = [[0; 3]; 3];
    for k in 0..3 {
        let [i, j] = [(k + 1) % 3, (k + 2) % 3];
        let apart = at(images, depths, 0, i) - at(images, depths, 0, j);
        let slope = ray(images[i]) - ray(images[j]);
        rows[k] = [dot(apart, apart), 2 * dot(apart, slope), dot(slope, slope)];
    }
    rows
}

fn at(images: [[f64; 2]; 3], depths: [f64; 3], shift: f64, k: f64) -> [f64; 3] {
    (depths[k] + shift) * ray(images[k])
}

fn ray(image: [f64; 2]) -> [f64; 3] {
    [image[0], image[1], 1]
}

/// Two cameras that look from about 4 away at points in a cube of side 2, from any sides.
#[scene]
fn scene(
    #[rotation] rotation: [[f64; 3]; 3],
    shift: [f64; 3],
    zoom: f64,
    off: [f64; 2],
    points: [[f64; 3]; 3],
) -> (Data, DepthPose) {
    let centre = [0, 0, 4];
    let scale = 3 / 2 + zoom;
    let shifts = off / 2;
    let [mut first, mut second] = [[[0; 2]; 3], [[0; 2]; 3]];
    let [mut first_depths, mut second_depths] = [[0; 3], [0; 3]];
    for k in 0..3 {
        let [x, y, depth] = points[k] + centre;
        first[k] = [x, y] / depth;
        first_depths[k] = depth - shifts[0];
        let [x, y, depth] = rotation * points[k] + centre + shift;
        second[k] = [x, y] / depth;
        second_depths[k] = depth / scale - shifts[1];
    }
    let translation = centre + shift - rotation * centre;
    (
        Data { first, first_depths, second, second_depths },
        DepthPose { rotation, translation, scale, shifts },
    )
}
