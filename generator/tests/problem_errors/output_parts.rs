fn output_parts(a: f64, b: f64) -> (x, y) {
    x * y == a;
    x + y == b + reciprocal(x);
    Parts {
        slope: gradient(reciprocal(x), x),
        powers: [
            1 / (x + 1), 1 / (x + 2), 1 / (x + 3), 1 / (x + 4), 1 / (x + 5), 1 / (x + 6), 1 / (x + 7), 1 / (x + 8),
            1 / (x + 9), 1 / (x + 10), 1 / (x + 11), 1 / (x + 12), 1 / (x + 13), 1 / (x + 14), 1 / (x + 15),
        ],
        again: reciprocal(x) + reciprocal(x),
        inner: inverse([[x, 1], [1, y]]),
        never: 1 / (square(x + y) - x * x - 2 * x * y - y * y),
        roots: sqrt([x + y, x - y]),
    }
}

fn reciprocal(x: f64) -> f64 {
    1 / x
}

fn square(x: f64) -> f64 {
    x * x
}
