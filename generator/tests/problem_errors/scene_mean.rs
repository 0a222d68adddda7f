fn problem(#[mean(of_point)] a: [f64; 2]) -> (x, y) {
    x * x + y == a[0];
    x * y == a[1];
}

fn of_point(p: [f64; 2]) -> [f64; 2] {
    [p[0], p[1] * p[1]]
}

#[scene]
fn scene(#[mean(of_point)] a: [f64; 2]) -> Data {
    Data { a }
}
