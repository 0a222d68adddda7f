fn lines(a: [f64; 2]) -> (x, y) {
    [x, [y]] == a;
}
