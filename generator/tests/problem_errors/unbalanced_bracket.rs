fn equal(a: f64) -> (x, y) {
    x * (y + a] == 1;
}
