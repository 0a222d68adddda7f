fn names(a: f64, x: f64, a: f64, det: f64) -> (x, y, y, dot, Z, gen, [f64; 3]) {
    x + y == a;
}
