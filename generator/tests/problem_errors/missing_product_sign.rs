fn line(a: f64) -> (x, y, e1) {
    2x + y == a;
    2.5y == 1;
    3(x + y) == 2;
    x - 2e1 == 0;
}
