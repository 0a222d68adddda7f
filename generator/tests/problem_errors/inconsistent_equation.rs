fn inconsistent(a: f64, b: f64) -> (x, y) {
    (x + 1) * (x - 1) == x * x;
    [x, a, y] == [y, b, 3];
    x * y == a;
}
