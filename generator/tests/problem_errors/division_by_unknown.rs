fn ratio(a: f64, v: [f64; 2]) -> (x, y) {
    1 / x + y == 2;
    x / a == 3;
    y / (a - a) == 1;
    y / v == 1;
}
