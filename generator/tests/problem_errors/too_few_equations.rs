fn underdetermined(
    a: f64,
    b: f64,
) -> (x, y, z) {
    x * y + z == a;
    x + y == b;
}
