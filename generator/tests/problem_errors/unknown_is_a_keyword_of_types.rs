/// A keyword that may begin a type: Rust complains about what follows.
fn circles(a: f64) -> (x, fn) {
    x * x + fn * fn == 1;
    x == a;
}
