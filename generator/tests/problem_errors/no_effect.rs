fn forgotten(a: f64) -> (x, y) {
    x + y - a;
    let e = x == y;
    (x - y).pow(2);
    x * y == 1
}
