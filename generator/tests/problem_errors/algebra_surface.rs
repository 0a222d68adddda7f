/// Three quadrics with a common plane.
fn algebra_surface(p: [f64; 3], q: [f64; 3]) -> (x, y, z) {
    let plane = dot(p, [x, y, z]) + 1;
    plane * x == 0;
    plane * y == 0;
    plane * (dot(q, [x, y, z]) + 1) == 0;
}
