/// Homography of two images of a plane, or of two cameras with one centre, from four points: 1
/// solution.
///
/// Hartley, Zisserman, "Multiple view geometry in computer vision", 2003, section 4.1; here by the
/// projective bases of the four points, as Heckbert, "Fundamentals of texture mapping and image
/// warping", 1989.
///
/// `first[k]` and `second[k]` are the images of point k, in pixels or any other unit; no three of
/// either may lie on a line. The homography H takes (`first[k]`, 1) to a multiple of (`second[k]`,
/// 1): that of point k < 3 is `multiples[k]`. The fourth point is the sum of these three with
/// weights, which are known in both images and proportional when multiplied.
fn homography_4pt(first: [[f64; 2]; 4], second: [[f64; 2]; 4]) -> (
    #[projective] multiples: [f64; 3],
) {
    // In units in which images are about 1, so that all entries of the matrix keep their digits.
    let unit = norm([first, second]);
    let [m0, m1, m2] = multiples;
    let from = inverse(three_of(first, unit));
    let to = three_of(second, unit);
    let known = from * in_units(first[3], unit);
    let fourth = [m0 * known[0], m1 * known[1], m2 * known[2]];
    cross(fourth, solve(to, in_units(second[3], unit))) == 0;
    let matrix = to * ([[m0, 0, 0], [0, m1, 0], [0, 0, m2]] * from);
    let to_unit = [[1, 0, 0], [0, 1, 0], [0, 0, unit]];
    let from_unit = [[unit, 0, 0], [0, unit, 0], [0, 0, 1]];
    Homography { #[projective] homography: from_unit * matrix * to_unit }
}

/// The first three points, in the columns.
fn three_of(images: [[f64; 2]; 4], unit: f64) -> [[f64; 3]; 3] {
    [in_units(images[0], unit), in_units(images[1], unit), in_units(images[2], unit)].t()
}

fn in_units(image: [f64; 2], unit: f64) -> [f64; 3] {
    [image[0], image[1], unit]
}

/// Two cameras that look from about 4 away at points of a plane.
#[scene]
fn scene(
    #[rotation] rotation: [[f64; 3]; 3],
    shift: [f64; 3],
    #[rotation] plane: [[f64; 3]; 3],
    points: [[f64; 2]; 4],
) -> (Data, Homography) {
    let centre = [0, 0, 4];
    let [mut first, mut second] = [[[0; 2]; 4], [[0; 2]; 4]];
    for k in 0..4 {
        let point = plane * concat(points[k], 0);
        let [x, y, depth] = point + centre;
        first[k] = [x, y] / depth;
        let [x, y, depth] = rotation * point + centre + shift;
        second[k] = [x, y] / depth;
    }
    // (a, b, 1) of the plane, with its axes as columns, to either image.
    let [u, v, _] = plane.t();
    let from = [u, v, centre].t();
    let to = [rotation * u, rotation * v, centre + shift].t();
    (Data { first, second }, Homography { homography: to * inverse(from) })
}
