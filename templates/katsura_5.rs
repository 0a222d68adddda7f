/// Katsura's equations for the magnetic field of a spin glass with six unknowns: 32 solutions.
/// There are no data.
///
/// Katsura, "Spin glass problem by the method of integral equation of the effective field", in: New
/// Trends in Magnetism, 1990; as in the data base of PHCpack (Verschelde, ACM TOMS 795, 1999).
/// Published as `katsura5`.
fn katsura_5() -> (t, u, v, x, y, z) {
    2 * (x * x + y * y + z * z + t * t + u * u) + v * v == v;
    x * y + y * z + 2 * z * t + 2 * t * u + 2 * u * v == u;
    2 * x * z + 2 * y * t + 2 * z * u + u * u + 2 * t * v == t;
    2 * x * t + 2 * y * u + 2 * t * u + 2 * z * v == z;
    t * t + 2 * x * v + 2 * y * v + 2 * z * v == y;
    2 * (x + y + z + t + u) + v == 1;
}
