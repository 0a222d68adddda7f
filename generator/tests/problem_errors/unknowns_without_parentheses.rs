fn circles(a: [f64; 2]) -> x, y {
    x * x + y * y == a[0];
    x * y == a[1];
}
