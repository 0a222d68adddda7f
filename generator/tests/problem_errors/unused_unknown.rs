fn two_of_three(a: f64, b: f64) -> (x, y, z) {
    x + y == a;
    x * y + z - z == b;
    x - y != 0;
}
