/// Everything with x = 0, and everything with y = 0, solves these.
fn algebra_unwanted_components(a: f64, b: f64, c: f64) -> (x, y, z) {
    x * y * (x + a * y - z) == 0;
    x * y * (b * x * x - y) == 0;
    z == c * x;
}
