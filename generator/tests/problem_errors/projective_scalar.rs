fn line(a: [f64; 2]) -> (#[projective] x, y) {
    a[0] * x == a[1] * y;
    x * y == 1;
}
