/// The cyclic 5-roots: 70 solutions.
///
/// Björck and Fröberg, "A faster way to count the solutions of inhomogeneous systems of algebraic
/// equations, with applications to cyclic n-roots", Journal of Symbolic Computation 1991. They
/// count functions on five points whose Fourier transform has constant modulus, too.
fn cyclic_5() -> (z: [f64; 5]) {
    let [a, b, c, d, e] = z;
    a + b + c + d + e == 0;
    a * b + b * c + c * d + d * e + e * a == 0;
    a * b * c + b * c * d + c * d * e + d * e * a + e * a * b == 0;
    a * b * c * d + b * c * d * e + c * d * e * a + d * e * a * b + e * a * b * c == 0;
    a * b * c * d * e == 1;
}
