fn square(v: [f64; 3]) -> f64 {
    dot(v, v) + offset
}

fn doubled(a: _) -> [f64; 2] {
    [a, 2 * a, 3 * a]
}

fn states(a: _) -> f64 {
    a == 0;
    a
}

fn valueless(a: _) {
    let b = a;
}

fn endless(a: _) -> f64 {
    a * endless(a - 1)
}

fn problem(a: f64) -> (x, y) {
    square([x, y, a]) == 1;
    square([x, y]) == 1;
    square(x, y) == 1;
    doubled(x) == [0, 1];
    states(x) == 1;
    valueless(x) == 1;
    endless(x) == 1;
}
