fn distance(a: f64, b: f64) -> (x, y) {
    sqrt(x * x + y * y) == a;
    x.sin() + y.powi(2) == b;
    x.abs() == y.recip();
}
