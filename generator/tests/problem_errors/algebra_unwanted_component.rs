/// Everything with x = 0 solves these.
fn algebra_unwanted_component(p: [f64; 3], q: [f64; 3]) -> (x, y) {
    x * dot(p, [x, y, 1]) == 0;
    x * dot(q, [x, y, 1]) == 0;
}
