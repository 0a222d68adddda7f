/// Pose of a calibrated camera that looks at five points through a known refracting plane: 16
/// solutions.
///
/// Haner, Åström, "Absolute pose for cameras under flat refractive interfaces", CVPR 2015.
/// Published as `refract5p`.
///
/// The plane is Z = 0. Refraction keeps a ray in its plane with the normal, so that R ray and the
/// point X minus the camera centre (v, w, ..) are parallel in their first two coordinates: (r1 ray)
/// (X2 - w) - (r2 ray) (X1 - v) = 0 with the rows r1, r2, r3 of R, that of the quaternion (1, x, y,
/// z) times 1 + x^2 + y^2 + z^2. Linear combinations of five such equations have the leading terms
/// r2\[i\] v - r1\[i\] w with i = 0, 1, 2, then x y, and x^2 - y^2, and otherwise the terms 1 -
/// z^2, z, x z + y and x - y z, with the coefficients `affine`. These are large where the image's
/// frame is unfortunate: turn the rays so that another axis is the third.
fn pose_5pt_refraction(affine: [[f64; 4]; 5]) -> (x, y, z) {
    let rest = affine * [1 - z * z, z, x * z + y, x - y * z];
    // The determinant of the coefficients of v, w and 1, divided by 1 + x^2 + y^2 + z^2: r1 x r2 is
    // that times r3.
    let r3 = [2 * (x * z - y), 2 * (y * z + x), 1 - x * x - y * y + z * z];
    dot(r3, [rest[0], rest[1], rest[2]]) == 0;
    x * y + rest[3] == 0;
    x * x - y * y + rest[4] == 0;
}
