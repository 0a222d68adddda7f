fn saturated(a: f64) -> (x, y) {
    x * y == 1;
    x + y == a;
    x != y;
    a != 0;
    [x, y] != 0;
}
