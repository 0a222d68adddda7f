/// Pose, focal length and radial distortion of a camera from four points: 16 solutions.
///
/// Josephson, Byröd, "Pose estimation with radial distortion and unknown focal length", CVPR 2009,
/// in the form of Bujnak, Kukelova, Pajdla, "New efficient solution to the absolute pose problem
/// for camera with unknown focal length and radial distortion", ACCV 2010. Published as `p4p_fr`.
///
/// `points[k]` is the position of point k, `images[k]` its distorted image, relative to the
/// principal point. The points must not lie in a plane, nor an image be at that point. An image (u,
/// v) lies along (u, v, 1 + radial (u^2 + v^2)), the division model, of P X with P = diag(1, 1,
/// 1/f) \[R t\]. That v times the first row of P minus u times the second vanishes at X leaves a
/// null space of dimension four: these rows are the sum of its vectors, each times its weight. The
/// third row follows from the four points. `projection` is P up to scale.
fn pose_4pt_focal_radial(points: [[f64; 3]; 4], images: [[f64; 2]; 4]) -> (#[projective] weights: [f64; 4], radial) {
    // Positions relative to the first point, in units in which they are about 1.
    let offsets = [points[1] - points[0], points[2] - points[0], points[3] - points[0]];
    let unit = norm(offsets);
    let mut positions = [[0, 0, 0, 1]; 4];
    for k in 0..3 {
        for i in 0..3 {
            positions[k + 1][i] = offsets[k][i] / unit;
        }
    }
    let mut rows = [[0; 8]; 4];
    for k in 0..4 {
        let [u, v] = images[k];
        for i in 0..4 {
            rows[k][i] = v * positions[k][i];
            rows[k][4 + i] = -u * positions[k][i];
        }
    }
    let basis = null_space(rows);
    // The third row at the points, in the weights, then in these times `radial`.
    let mut depths = [[0; 8]; 4];
    for k in 0..4 {
        let [u, v] = images[k];
        for c in 0..4 {
            let mut along = 0;
            for i in 0..4 {
                along += (u * basis[c][i] + v * basis[c][4 + i]) * positions[k][i];
            }
            depths[k][c] = along / (u * u + v * v);
            depths[k][4 + c] = along;
        }
    }
    let lower = solve(positions, depths);
    let [a, b, c, d] = weights;
    let upper = weights * basis;
    let third = lower * [a, b, c, d, radial * a, radial * b, radial * c, radial * d];
    let p1 = [upper[0], upper[1], upper[2]];
    let p2 = [upper[4], upper[5], upper[6]];
    let p3 = [third[0], third[1], third[2]];
    dot(p1, p2) == 0;
    dot(p1, p3) == 0;
    dot(p2, p3) == 0;
    dot(p1, p1) - dot(p2, p2) == 0;
    // Of positions as they are given.
    let mut projection = [[0; 4]; 3];
    for i in 0..3 {
        let row = [p1, p2, p3][i];
        let moved = unit * [upper[3], upper[7], third[3]][i] - dot(row, points[0]);
        projection[i] = [row[0], row[1], row[2], moved];
    }
    RadialPose { projection: projection, focal: sqrt(dot(p1, p1) / dot(p3, p3)), radial: radial }
}

/// A camera that looks from about 4 away at points in a cube of side 2.
#[scene]
fn scene(
    #[rotation] rotation: [[f64; 3]; 3],
    shift: [f64; 3],
    zoom: f64,
    distortion: f64,
    points: [[f64; 3]; 4],
) -> (Data, RadialPose) {
    let focal = 3 / 2 + zoom / 2;
    let radial = (distortion - 1) / 4;
    let mut images = [[0; 2]; 4];
    for k in 0..4 {
        let [x, y, depth] = rotation * points[k] + [0, 0, 4] + shift;
        images[k] = distorted(focal * [x, y] / depth, radial);
    }
    (Data { points, images }, RadialPose { focal, radial })
}

/// The image p of which p / (1 + radial |p|^2) is given.
fn distorted(image: [f64; 2], radial: f64) -> [f64; 2] {
    2 * image / (1 + sqrt(1 - 4 * radial * dot(image, image)))
}
