fn line(a: f64) -> (x, y) {
    a x + y == 1;
    x == y;
}
