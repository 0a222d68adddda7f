fn problem(a: [f64; 2], #[unit] b: [f64; 2]) -> (x, y) {
    x * x + y == a[0];
    x * y == dot(a, b);
    Place { spot: [x, y] }
}

#[scene]
fn scene(place: [f64; 2], #[unit] b: [f64; 2], #[mean(area)] size: f64) -> (Data, Place) {
    let [x, y] = place;
    (Data { a: [x * x + y, x * y], b }, Place { spot: place })
}

#[scene]
fn another(a: [f64; 2], b: [f64; 2]) -> Data {
    Data { a, b }
}

#[scenery]
fn area(a: f64) -> f64 {
    a * a
}
