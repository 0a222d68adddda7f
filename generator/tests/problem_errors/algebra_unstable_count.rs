/// The constant is 1 modulo the first prime: only there the quadratic parts are the same.
fn algebra_unstable_count(a: f64, b: f64) -> (x, y) {
    x * x + x * y == a;
    x * x + 2147483648 * x * y + y == b;
}
