fn hyperbola(a: f64) -> (x, y) {
    x.pow(-1) + y == a;
    x.pow(y) == 1;
    x.pow(0.5) == 1;
    x.pow(1000) == y;
}
