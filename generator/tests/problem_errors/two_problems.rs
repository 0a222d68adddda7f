fn first(a: f64) -> x {
    x * x == a;
}

fn second(a: f64) -> (x, y) {
    x * y == a;
    x == y;
}
