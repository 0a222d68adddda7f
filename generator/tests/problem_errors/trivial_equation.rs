fn trivial(a: f64, b: f64) -> (x, y) {
    (x + y).pow(2) == x * x + 2 * x * y + y * y;
    x == a;
    y == b;
}
