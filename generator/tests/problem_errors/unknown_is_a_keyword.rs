/// A keyword that begins no type.
fn circles(a: f64) -> (x, type) {
    x * x + type * type == 1;
    x == a;
}
