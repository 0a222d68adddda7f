/// Habits: a type and `_` where names are expected.
fn circles(a: f64) -> (x, f64, f32, _) {
    x * x + a == 1;
}
