/// Triangulation from three views with two of the three epipolar constraints, all stationary points
/// of the least-squares cost: 27 solutions.
///
/// Kukelova, Pajdla, Bujnak, "Fast and stable algebraic solution to L2 three-view triangulation",
/// 3DV 2013. Published as `l2_3view_triang`, for matrices of full rank, which give 31 solutions.
/// Fundamental and essential matrices have rank 2, and with them four of the 31 are at infinity.
///
/// `image` holds the measured image points, one a row. The corrected ones (x1, x2), (x3, x4) and
/// (x5, x6) are the closest to these that satisfy p1^T `first` p2 = 0 and p2^T `second` p3 = 0,
/// with the multipliers x7 and x8. The cost is the sum of the squared distances.
fn triangulation_3view_relaxed(
    #[rank(2)]
    first: [[f64; 3]; 3],
    #[rank(2)]
    second: [[f64; 3]; 3],
    image: [[f64; 2]; 3],
) -> (x1, x2, x3, x4, x5, x6, x7, x8) {
    let corrected = [[x1, x2], [x3, x4], [x5, x6]];
    let offset = corrected - image;
    let cost = dot(offset[0], offset[0]) + dot(offset[1], offset[1]) + dot(offset[2], offset[2]);
    let [p1, p2, p3] = [[x1, x2, 1], [x3, x4, 1], [x5, x6, 1]];
    gradient(cost + x7 * dot(p1, first * p2) + x8 * dot(p2, second * p3)) == 0;
    Corrected { images: corrected, cost: cost }
}

/// Three cameras at random that look from about 4 away at a point in a cube of side 2.
#[scene]
fn scene(#[rotation] rotations: [[[f64; 3]; 3]; 3], shifts: [[f64; 3]; 3], point: [f64; 3]) -> (Data, Corrected) {
    let mut image = [[0; 2]; 3];
    for k in 0..3 {
        let [x, y, depth] = rotations[k] * point + [0, 0, 4] + shifts[k];
        image[k] = [x, y] / depth;
    }
    let first = between(rotations[0], [0, 0, 4] + shifts[0], rotations[1], [0, 0, 4] + shifts[1]);
    let second = between(rotations[1], [0, 0, 4] + shifts[1], rotations[2], [0, 0, 4] + shifts[2]);
    (Data { first, second, image }, Corrected { images: image, cost: 0 })
}

/// The matrix E of which p^T E q = 0 for the images p in the first camera and q in the second.
fn between(r: [[f64; 3]; 3], t: [f64; 3], s: [[f64; 3]; 3], u: [f64; 3]) -> [[f64; 3]; 3] {
    let rotation = r * s.t();
    let [x, y, z] = t - rotation * u;
    [[0, -z, y], [z, 0, -x], [-y, x, 0]] * rotation
}
