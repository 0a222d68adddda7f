fn conic(a: f64) -> (x, y) {
    a * x^2 + y == 1;
    x**2 - y == 0;
}
