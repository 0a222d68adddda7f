/// Two parallel lines.
fn algebra_inconsistent(a: f64, b: f64, c: f64) -> (x, y) {
    a * x + b * y + c == 0;
    a * x + b * y + c + 1 == 0;
}
