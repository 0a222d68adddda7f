/// Two dipoles that stand for the electric field of a heart: 4 solutions.
///
/// Nelsen and Hodgkin, "Determination of magnitudes, directions, and locations of two independent
/// dipoles in a circular conducting region from boundary potential measurements", IEEE Transactions
/// on Biomedical Engineering 1981; the test system `heart` of Morgan, Sommese and Watson 1989, in
/// complex numbers: moments m and n at places z and w, and the sums m z^k + n w^k, k = 0 .. 3.
///
/// `sums` are these four complex numbers, real parts first.
fn heart_dipole(sums: [[f64; 2]; 4]) -> (m: [f64; 2], n: [f64; 2], z: [f64; 2], w: [f64; 2]) {
    let z2 = times(z, z);
    let w2 = times(w, w);
    m + n == sums[0];
    times(m, z) + times(n, w) == sums[1];
    times(m, z2) + times(n, w2) == sums[2];
    times(m, times(z2, z)) + times(n, times(w2, w)) == sums[3];
}

fn times(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}
