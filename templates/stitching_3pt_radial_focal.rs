/// Rotation between two photographs with common unknown focal length and radial distortion, a
/// panorama, from three points: 18 solutions, of which those with a real focal length are returned.
///
/// Naroditsky, Daniilidis, "Optimizing polynomial solvers for minimal geometry problems", ICCV
/// 2011, after Byröd, Brown, Åström, "Minimal solutions for panoramic stitching with radial
/// distortion", BMVC 2009. Published as `stitching`.
///
/// `first[k]` and `second[k]` are the distorted images of point k, relative to the principal point.
/// A point p lies along (p, focal (1 + radial |p|^2)), the division model. Two points with the
/// inner product xy of their rays, in the first image, and x'y' in the second, satisfy xy^2 x'x'
/// y'y' = x'y'^2 xx yy. With w = 1/focal^2 both sides divided by focal^8 are polynomials in w whose
/// difference has no term without w; it is divided by w.
fn stitching_3pt_radial_focal(first: [[f64; 2]; 3], second: [[f64; 2]; 3]) -> (radial, w) {
    for k in 1..3 {
        let [p, q] = [stretched(first[0], radial), stretched(first[k], radial)];
        let [r, s] = [stretched(second[0], radial), stretched(second[k], radial)];
        let left = side(dot(first[0], first[k]), p, q, r, s);
        let right = side(dot(second[0], second[k]), r, s, p, q);
        let difference = left - right;
        difference[0] + difference[1] * w + difference[2] * w.pow(2) + difference[3] * w.pow(3) == 0;
    }
    w > 0;
    Panorama { focal: sqrt(1 / w), radial: radial }
}

/// The square of the length of an image and the third coordinate of its ray, divided by the focal
/// length.
fn stretched(point: [f64; 2], radial: _) -> [f64; 2] {
    let square = dot(point, point);
    [square, 1 + radial * square]
}

/// The coefficients of w, w^2, w^3 and w^4 in (z + along w)^2 (r_z^2 + r_s w) (s_z^2 + s_s w),
/// where z is the product of the third coordinates of p and q.
fn side(along: f64, p: [f64; 2], q: [f64; 2], r: [f64; 2], s: [f64; 2]) -> [f64; 4] {
    let z = p[1] * q[1];
    let [f, g] = [r[1] * r[1], s[1] * s[1]];
    let mixed = r[0] * g + s[0] * f;
    let both = r[0] * s[0];
    [
        2 * along * z * f * g + z * z * mixed,
        along * along * f * g + 2 * along * z * mixed + z * z * both,
        along * along * mixed + 2 * along * z * both,
        along * along * both,
    ]
}

/// A camera that turns by up to 40 degrees about its centre.
#[scene]
fn scene(turn: [f64; 3], zoom: f64, distortion: f64, sights: [[f64; 2]; 3]) -> (Data, Panorama) {
    let quaternion = concat([1], turn / 5);
    let focal = 3 / 2 + zoom / 2;
    let radial = (distortion - 1) / 10;
    let [mut first, mut second] = [[[0; 2]; 3], [[0; 2]; 3]];
    for k in 0..3 {
        let ray = concat(sights[k] / 2, [1]);
        let turned = of_quaternion(quaternion) * ray;
        turned[2] > 1 / 5;
        first[k] = distorted(focal * [ray[0], ray[1]], radial);
        second[k] = distorted(focal * [turned[0], turned[1]] / turned[2], radial);
    }
    (Data { first, second }, Panorama { focal, radial })
}

/// The image p of which p / (1 + radial |p|^2) is given.
fn distorted(image: [f64; 2], radial: f64) -> [f64; 2] {
    2 * image / (1 + sqrt(1 - 4 * radial * dot(image, image)))
}

fn of_quaternion(q: [f64; 4]) -> [[f64; 3]; 3] {
    let [w, x, y, z] = q;
    [
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ] / dot(q, q)
}
