fn positive(a: f64) -> (x, y) {
    x * y == a;
    x == y;
    x > 0;
}
