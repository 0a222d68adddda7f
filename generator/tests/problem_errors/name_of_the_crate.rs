fn eliminant(a: f64) -> (x, y) {
    x * x + y == a;
    x * y == 1;
}
