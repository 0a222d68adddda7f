/// `b` is not mentioned, `u` cancels, `c` is read by an unread name, `d` by an exclusion only.
fn unused(a: f64, b: [f64; 2], #[unit] u: [f64; 3], c: f64, d: f64, e: [f64; 3]) -> (x, y) {
    let name = c * x;
    x * x + y * dot(u, u) == a;
    x * y + (c - c) * x == e[1];
    x - d * y != 0;
}
