/// A keyword in an equation.
fn circles(a: f64) -> (x, y) {
    let in_ = 2;
    x * x + y * in == 1;
    x == a;
}
