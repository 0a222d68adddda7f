/// Relative pose and radial distortion of the first camera, whose focal length is unknown, too, and
/// eliminated, the second calibrated, from seven points: 19 solutions.
///
/// Kukelova, Kileel, Sturmfels, Pajdla, "A clever elimination strategy for efficient minimal
/// solvers", CVPR 2017. Published as `relpose_7p_fr_1s_elr`.
///
/// `first[k]` is the distorted image of point k in the first camera, relative to the principal
/// point, `second[k]` that in the calibrated one, in units of its focal length. A point x1 of the
/// first image lies along (x1, 1 + radial |x1|^2), the division model. Then x2^T F x1 = 0 is linear
/// in radial f33, the first two columns of F and the monomials radial f13, radial f23, f13, f23,
/// f33: seven points give the former as combinations of these. `third` is the third column of F,
/// which is given up to scale. It vanishes where the first camera moves along its optical axis:
/// then the points tell nothing of the distortion. With f33 = 1, as published, planar motions and
/// those without a rotation are lost. F diag(focal, focal, 1) is an essential matrix for some focal
/// length: with A the first two columns of F, the third is an eigenvector of A A^T, and where mu is
/// its eigenvalue, |third column|^2 / focal^2 = trace(A A^T) - 2 mu.
fn relpose_7pt_focal_radial_one_side_eliminated(first: [[f64; 2]; 7], second: [[f64; 2]; 7]) -> (
    #[projective] third: [f64; 3],
    radial,
) {
    let mut leading = [[0; 7]; 7];
    let mut others = [[0; 5]; 7];
    for k in 0..7 {
        let [a, b] = first[k];
        let [c, d] = second[k];
        let r = a * a + b * b;
        leading[k] = [r, a * c, a * d, a, b * c, b * d, b];
        others[k] = [-c * r, -d * r, -c, -d, -1];
    }
    let [radial_f33, f11, f21, f31, f12, f22, f32] =
        solve(leading, others) * [radial * third[0], radial * third[1], third[0], third[1], third[2]];
    let left = [[f11, f12], [f21, f22], [f31, f32]];
    let fundamental = [[f11, f12, third[0]], [f21, f22, third[1]], [f31, f32, third[2]]];
    radial * third[2] == radial_f33;
    det(fundamental) == 0;
    cross(third, left * left.t() * third) == 0;
    RadialEpipolar { #[projective] fundamental: fundamental, radial: radial }
}

/// Two cameras that look from about 4 away at points in a cube of side 2, from any sides.
#[scene]
fn scene(
    #[rotation] rotation: [[f64; 3]; 3],
    shift: [f64; 3],
    zoom: f64,
    distortion: f64,
    points: [[f64; 3]; 7],
) -> (Data, RadialEpipolar) {
    let centre = [0, 0, 4];
    let focal = 3 / 2 + zoom / 2;
    let radial = (distortion - 1) / 4;
    let mut first = [[0; 2]; 7];
    let mut second = [[0; 2]; 7];
    for k in 0..7 {
        let [x, y, depth] = points[k] + centre;
        first[k] = distorted(focal * [x, y] / depth, radial);
        let [x, y, depth] = rotation * points[k] + centre + shift;
        second[k] = [x, y] / depth;
    }
    let essential = skew(centre + shift - rotation * centre) * rotation;
    let fundamental = essential * [[1, 0, 0], [0, 1, 0], [0, 0, focal]];
    (Data { first, second }, RadialEpipolar { fundamental, radial })
}

/// The image p of which p / (1 + radial |p|^2) is given.
fn distorted(image: [f64; 2], radial: f64) -> [f64; 2] {
    2 * image / (1 + sqrt(1 - 4 * radial * dot(image, image)))
}
