/// Relative pose of a camera with unknown focal length and a calibrated one from six points: 9
/// solutions, of which those with a real focal length are returned.
///
/// Bujnak, Kukelova, Pajdla, "3D reconstruction from image collections with a single known focal
/// length", ICCV 2009. Published as `focal6p_1s`.
///
/// `first[k]` is the image of point k in the camera with unknown focal length, relative to the
/// principal point, `second[k]` its ray in the calibrated one, of any length. A fundamental matrix
/// F satisfies `second[k] . F (first[k], 1) = 0`; it is the sum of the matrices that span the null
/// space of these equations, each times its weight. w is 1 / focal^2 in units of the length of all
/// images.
fn relpose_6pt_focal_one_side(first: [[f64; 2]; 6], second: [[f64; 3]; 6]) -> (#[projective] weights: [f64; 3], w) {
    // In units in which images are about 1, so that all entries of the matrix keep their digits.
    let unit = norm(first);
    let mut rows = [[0; 9]; 6];
    for k in 0..6 {
        let [x, y] = [[first[k][0], first[k][1], unit], second[k]];
        for i in 0..3 {
            for j in 0..3 {
                rows[k][3 * i + j] = y[i] * x[j];
            }
        }
    }
    let basis = reshape(null_space(rows), [3, 3, 3]);
    let f = weights[0] * basis[0] + weights[1] * basis[1] + weights[2] * basis[2];
    let omega = [[1, 0, 0], [0, 1, 0], [0, 0, w]];
    let left = f * omega * f.t();
    det(f) == 0;
    2 * left * f - trace(left) * f == 0;
    w > 0;
    let to_unit = [[1, 0, 0], [0, 1, 0], [0, 0, unit]];
    FocalPose { #[projective] fundamental: f * to_unit, focal: sqrt(unit * unit / w) }
}

/// Two cameras that look from about 4 away at points in a cube of side 2, from any sides.
#[scene]
fn scene(
    #[rotation] rotation: [[f64; 3]; 3],
    shift: [f64; 3],
    zoom: f64,
    points: [[f64; 3]; 6],
) -> (Data, FocalPose) {
    let centre = [0, 0, 4];
    let focal = 3 / 2 + zoom / 2;
    let mut first = [[0; 2]; 6];
    let mut second = [[0; 3]; 6];
    for k in 0..6 {
        let [x, y, depth] = points[k] + centre;
        first[k] = focal * [x, y] / depth;
        let [x, y, depth] = rotation * points[k] + centre + shift;
        second[k] = [x, y, depth];
    }
    let essential = skew(centre + shift - rotation * centre) * rotation;
    (Data { first, second }, FocalPose { fundamental: essential * [[1, 0, 0], [0, 1, 0], [0, 0, focal]], focal })
}
