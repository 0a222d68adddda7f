/// Where a circle meets a parabola: 4 solutions.
///
/// `circle` holds its centre and the square of its radius, `parabola` the coefficients of x^2, x
/// and 1.
fn meet(circle: [f64; 3], parabola: [f64; 3]) -> (x, y) {
    (x - circle[0]).pow(2) + (y - circle[1]).pow(2) == circle[2];
    y == parabola[0] * x * x + parabola[1] * x + parabola[2];
}
