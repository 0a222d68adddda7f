/// Pose of a calibrated camera that looks at five points through a plane at which light is
/// refracted: 8 solutions.
///
/// Haner, Åström, "Absolute pose for cameras under flat refractive interfaces", CVPR 2015.
/// Published as `refract5p`.
///
/// The plane is Z = 0, with the camera on one side of it and the points on the other. `rays[k]` is
/// the ray of point k in the camera, of any length, and `points[k]` its position; `index` is the
/// index of refraction on the side of the points, relative to that on the side of the camera.
/// Refraction keeps a ray in its plane with the normal, so that R ray and the point X minus the
/// centre (v, w, ..) of the camera are parallel in their first two coordinates:
/// (r1 ray) (X2 - w) - (r2 ray) (X1 - v) = 0 with the rows r1, r2, r3 of R. This is linear in r1,
/// r2 and u = v r2 - w r1, so these are a sum of four vectors, each times its weight. r1 and r2
/// have one length and are orthogonal, and u is in their plane: the determinant is 0. Four complex
/// solutions with r1 and r2 of length 0 satisfy that for any u. They are none of the other form, in
/// which u is the sum of its parts along r1 and r2. The two together are all cubic equations.
///
/// The published system is stated in a quaternion and has 16 solutions: with (r1, r2, r3) also
/// (-r1, -r2, r3), the same turned by a half about the normal. Both have the same weights here, up
/// to sign. Of the two, `rotation` is the one with the points ahead of the camera. It takes rays to
/// the frame of the points, and `centre` is that of the camera. Its height follows from how much
/// the rays are bent, by least squares.
fn pose_5pt_refraction(rays: [[f64; 3]; 5], points: [[f64; 3]; 5], index: f64) -> (
    #[projective] weights: [f64; 4],
) {
    // Relative to the first point, in units in which they are about 1.
    let mut offsets = [[0; 2]; 5];
    for k in 0..5 {
        offsets[k] = [points[k][0] - points[0][0], points[k][1] - points[0][1]];
    }
    let unit = norm([offsets[1], offsets[2], offsets[3], offsets[4]]);
    let mut directions = [[0; 3]; 5];
    let mut rows = [[0; 9]; 5];
    for k in 0..5 {
        directions[k] = normalise(rays[k]);
        let [x, y] = offsets[k] / unit;
        for i in 0..3 {
            rows[k][i] = y * directions[k][i];
            rows[k][3 + i] = -x * directions[k][i];
            rows[k][6 + i] = directions[k][i];
        }
    }
    let rows = reshape(weights * null_space(rows), [3, 3]);
    let [r1, r2, u] = rows;
    dot(r1, r1) == dot(r2, r2);
    dot(r1, r2) == 0;
    det(rows) == 0;
    dot(r1, r1) * u == dot(u, r1) * r1 + dot(u, r2) * r2;
    let third = cross(r1, r2);
    let [mut down, mut depths] = [[0; 5]; 2];
    for k in 0..5 {
        down[k] = dot(third, directions[k]);
        depths[k] = norm([points[k][2]]) / unit;
    }
    dot(down, points.t()[2]) > 0;
    RefractedPose {
        rotation: rotation(of_length_1(rows, directions, offsets / unit)),
        centre: concat(
            [points[0][0], points[0][1]] + unit * foot(of_length_1(rows, directions, offsets / unit)),
            unit * height(of_length_1(rows, directions, offsets / unit), directions, offsets / unit, depths, index),
        ),
    }
}

/// The first two rows of R, and u: divided by the length of a row, with the sign for which the
/// points are ahead of the camera.
fn of_length_1(rows: [[f64; 3]; 3], directions: [[f64; 3]; 5], offsets: [[f64; 2]; 5]) -> [[f64; 3]; 3] {
    let scaled = sqrt(1 / dot(rows[0], rows[0])) * rows;
    let mut ahead = 0;
    for k in 0..5 {
        ahead += gap(scaled, directions[k], offsets[k]);
    }
    ahead * sqrt(1 / (ahead * ahead)) * scaled
}

fn rotation(rows: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    [rows[0], rows[1], cross(rows[0], rows[1])]
}

/// The point of the plane below the camera.
fn foot(rows: [[f64; 3]; 3]) -> [f64; 2] {
    [dot(rows[2], rows[1]), -dot(rows[2], rows[0])]
}

/// How far a point is from there along its ray, times the length of the ray in the plane.
fn gap(rows: [[f64; 3]; 3], direction: [f64; 3], offset: [f64; 2]) -> f64 {
    dot(offset - foot(rows), [dot(rows[0], direction), dot(rows[1], direction)])
}

/// The height of the camera, by least squares. Beyond its depth times the slope of the bent ray, a
/// point is away by the height times the slope of the ray.
fn height(
    rows: [[f64; 3]; 3],
    directions: [[f64; 3]; 5],
    offsets: [[f64; 2]; 5],
    depths: [f64; 5],
    index: f64,
) -> f64 {
    let mut sum = 0;
    let mut weight = 0;
    for k in 0..5 {
        let ray = [dot(rows[0], directions[k]), dot(rows[1], directions[k])];
        let across = dot(ray, ray);
        let bent = depths[k] / sqrt(index * index - across);
        sum += dot(cross(rows[0], rows[1]), directions[k]) * (across * bent - gap(rows, directions[k], offsets[k]));
        weight += across;
    }
    sum / weight
}

/// A camera 1 to 3 above water that looks at points up to 3 deep in it, by Snell's law.
#[scene]
fn scene(
    #[rotation] rotation: [[f64; 3]; 3],
    foot: [f64; 2],
    up: f64,
    surface: [[f64; 2]; 5],
    deep: [f64; 5],
) -> (Data, RefractedPose) {
    let [height, index] = [2 + up, 4 / 3];
    let [mut rays, mut points] = [[[0; 3]; 5], [[0; 3]; 5]];
    for k in 0..5 {
        let ray = normalise(concat(2 * surface[k] - foot, height));
        let [x, y, down] = ray;
        let bent = [x, y] / sqrt(index * index - x * x - y * y);
        let depth = 2 + deep[k];
        rays[k] = rotation.t() * ray;
        points[k] = concat(2 * surface[k] + depth * bent, depth);
    }
    (Data { rays, points, index }, RefractedPose { rotation, centre: concat(foot, -height) })
}
