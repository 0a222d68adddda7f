/// An economy of six quantities: 16 solutions.
///
/// Morgan, "Solving Polynomial Systems Using Continuation for Engineering and Scientific Problems",
/// Prentice-Hall 1987, page 148: the test system `eco6`.
///
/// `c` are the constants of the right-hand sides.
fn economy_6(c: [f64; 5]) -> (x: [f64; 6]) {
    (x[0] + x[0] * x[1] + x[1] * x[2] + x[2] * x[3] + x[3] * x[4]) * x[5] == c[0];
    (x[1] + x[0] * x[2] + x[1] * x[3] + x[2] * x[4]) * x[5] == c[1];
    (x[2] + x[0] * x[3] + x[1] * x[4]) * x[5] == c[2];
    (x[3] + x[0] * x[4]) * x[5] == c[3];
    x[4] * x[5] == c[4];
    x[0] + x[1] + x[2] + x[3] + x[4] + 1 == 0;
}
