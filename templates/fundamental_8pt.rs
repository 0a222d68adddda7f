/// Fundamental matrix of two cameras from eight points: 1 solution.
///
/// Hartley, Zisserman, "Multiple view geometry in computer vision", 2003, section 11.1.
///
/// `first[k]` and `second[k]` are the images of point k. A fundamental matrix F satisfies
/// `(second[k], 1) . F (first[k], 1) = 0`. It is the sum of the two matrices that span the null
/// space of the first seven of these equations, each times its weight, which the last one gives. Of
/// images with errors F has rank 3; that of seven points, `fundamental_7pt`, has rank 2.
fn fundamental_8pt(first: [[f64; 2]; 8], second: [[f64; 2]; 8]) -> (#[projective] weights: [f64; 2]) {
    // In units in which images are about 1, so that all entries of the matrix keep their digits.
    let unit = norm([first, second]);
    let mut rows = [[0; 9]; 8];
    for k in 0..8 {
        let [x, y] = [[first[k][0], first[k][1], unit], [second[k][0], second[k][1], unit]];
        for i in 0..3 {
            for j in 0..3 {
                rows[k][3 * i + j] = y[i] * x[j];
            }
        }
    }
    let of_seven = [rows[0], rows[1], rows[2], rows[3], rows[4], rows[5], rows[6]];
    let f = weights * null_space(of_seven);
    dot(rows[7], f) == 0;
    let f = reshape(f, [3, 3]);
    let to_unit = [[1, 0, 0], [0, 1, 0], [0, 0, unit]];
    Epipolar { #[projective] fundamental: to_unit * f * to_unit }
}

/// Two cameras that look from about 4 away at points in a cube of side 2, from any sides.
#[scene]
fn scene(
    #[rotation] rotation: [[f64; 3]; 3],
    shift: [f64; 3],
    zooms: [f64; 2],
    points: [[f64; 3]; 8],
) -> (Data, Epipolar) {
    let centre = [0, 0, 4];
    let [f, g] = [3 / 2 + zooms[0] / 2, 3 / 2 + zooms[1] / 2];
    let [mut first, mut second] = [[[0; 2]; 8], [[0; 2]; 8]];
    for k in 0..8 {
        let [x, y, depth] = points[k] + centre;
        first[k] = f * [x, y] / depth;
        let [x, y, depth] = rotation * points[k] + centre + shift;
        second[k] = g * [x, y] / depth;
    }
    let essential = skew(centre + shift - rotation * centre) * rotation;
    let of_first = [[1, 0, 0], [0, 1, 0], [0, 0, f]];
    let of_second = [[1, 0, 0], [0, 1, 0], [0, 0, g]];
    let fundamental = of_second * essential * of_first;
    (Data { first, second }, Epipolar { fundamental })
}
