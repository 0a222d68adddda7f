fn problem(a: [f64; 2], z: Complex<f64>) -> (x, y) {
    x * x + y == a[0];
    x * y == a[1] + z.re + z.im;
}

#[scene]
fn scene(x: f64, y: f64) -> (Data, Solution) {
    (Data { b: [x * x + y, x * y], a: [x, y, 1], z: [x, y] }, Solution { x: x })
}
