/// Pose of a calibrated camera that looks at five points through a plane at which light is
/// refracted: 16 solutions.
///
/// Haner, Åström, "Absolute pose for cameras under flat refractive interfaces", CVPR 2015.
/// Published as `refract5p`.
///
/// The plane is Z = 0, with the camera on one side of it and the points on the other. `rays[k]` is
/// the ray of point k in the camera, of any length, and `points[k]` its position; `index` is the
/// index of refraction on the side of the points, relative to that on the side of the camera.
/// Refraction keeps a ray in its plane with the normal, so that R ray and the point X minus the
/// centre (v, w, ..) of the camera are parallel in their first two coordinates:
/// (r1 ray) (X2 - w) - (r2 ray) (X1 - v) = 0 with the rows r1, r2, r3 of R, that of the quaternion.
/// This is linear in r1, r2 and u = v r2 - w r1. Five such equations are combined so that u
/// vanishes; otherwise they give u, which is across r3. Of a rotation and the same turned by a half
/// about the normal one has the points ahead of the camera.
///
/// `rotation` takes rays to the frame of the points, and `centre` is that of the camera. Its height
/// follows from how much the rays are bent, by least squares.
fn pose_5pt_refraction(rays: [[f64; 3]; 5], points: [[f64; 3]; 5], index: f64) -> (
    #[projective] quaternion: [f64; 4],
) {
    // Relative to the first point, in units in which they are about 1.
    let mut offsets = [[0; 2]; 5];
    for k in 0..5 {
        offsets[k] = [points[k][0] - points[0][0], points[k][1] - points[0][1]];
    }
    let unit = norm([offsets[1], offsets[2], offsets[3], offsets[4]]);
    let mut of_u = [[0; 3]; 5];
    let mut of_rotation = [[0; 6]; 5];
    for k in 0..5 {
        of_u[k] = normalise(rays[k]);
        let [x, y] = offsets[k] / unit;
        for i in 0..3 {
            of_rotation[k][i] = y * of_u[k][i];
            of_rotation[k][3 + i] = -x * of_u[k][i];
        }
    }
    let [w, x, y, z] = quaternion;
    let r1 = [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)];
    let r2 = [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)];
    let third = [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z];
    let entries = reshape([r1, r2], [6]);
    null_space(of_u.t()) * of_rotation * entries == 0;
    let u = -solve(of_u.t() * of_u, of_u.t() * of_rotation) * entries;
    dot(third, u) == 0;
    let foot = [dot(u, r2), -dot(u, r1)];
    let size = dot(quaternion, quaternion).pow(2);
    let [mut down, mut across, mut gap, mut depth] = [[0; 5]; 4];
    for k in 0..5 {
        let ray = [dot(r1, of_u[k]), dot(r2, of_u[k])];
        down[k] = dot(third, of_u[k]);
        across[k] = dot(ray, ray);
        gap[k] = dot(size * offsets[k] / unit - foot, ray);
        depth[k] = norm([points[k][2]]) / unit;
    }
    gap[0] + gap[1] + gap[2] + gap[3] + gap[4] > 0;
    dot(down, points.t()[2]) > 0;
    // Beyond its depth times the slope of the bent ray, a point is away by the height times the
    // slope of the ray.
    let n = index * index;
    RefractedPose {
        rotation: [r1, r2, third],
        centre: [
            points[0][0] + unit * foot[0],
            points[0][1] + unit * foot[1],
            unit
                * (down[0] * (depth[0] * across[0] / sqrt(n - across[0]) - gap[0])
                    + down[1] * (depth[1] * across[1] / sqrt(n - across[1]) - gap[1])
                    + down[2] * (depth[2] * across[2] / sqrt(n - across[2]) - gap[2])
                    + down[3] * (depth[3] * across[3] / sqrt(n - across[3]) - gap[3])
                    + down[4] * (depth[4] * across[4] / sqrt(n - across[4]) - gap[4]))
                / (across[0] + across[1] + across[2] + across[3] + across[4]),
        ],
    }
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
