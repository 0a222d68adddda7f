fn outputs(a: f64, b: f64) -> (x, y) {
    x * y == a;
    x == y * b;
    Pose { #[projective] direction: [x, y] }
}

#[scene]
fn scene(x: f64, y: f64) -> (Data, Pose) {
    (Data { a: x * y, b: x / y }, Pose { #[projective] direction: [x, y] })
}
