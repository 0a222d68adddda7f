fn problem(a: [f64; 2], b: f64) -> (x, y) {
    x * x + y == a[0];
    x * y == a[1] + b;
}

#[scene]
fn scene(place: [f64; 2], b: f64) -> Data {
    let [x, y] = place;
    x == y;
    x != 0;
    Data { a: place, b };
    place > 0;
    x > 0;
    (Data { a: [x, y, 1], c: b, a: place }, Solution { x })
}
