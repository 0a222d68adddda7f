fn positive(a: f64, b: [f64; 2]) -> (x, y) {
    x * y == a;
    x == y * b[0] + b[1];
    x >= 0;
    a > 0;
    [x, y] > b;
    let z = x > 0;
}
