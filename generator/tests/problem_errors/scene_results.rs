fn problem(a: [f64; 2]) -> (x, y) {
    x * x + y == a[0];
    x * y == a[1];
    Place { spot: [x, y] }
}

#[scene]
fn scene(x: f64, y: f64) -> (Data, Solution) {
    (Data { a: [x * x + y, x * y] }, Place { spot: [x, y] })
}
