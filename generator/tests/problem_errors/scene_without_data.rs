fn problem(a: [f64; 2]) -> (x, y) {
    x * x + y == a[0];
    x * y == a[1];
}

#[scene]
fn scene(x: f64, y: f64) -> Data {
    [x * x + y, x * y]
}
