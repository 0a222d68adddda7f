fn sphere(a: f64) -> (v: [f64, 3], s) {
    dot(v, v) == s * a;
}
