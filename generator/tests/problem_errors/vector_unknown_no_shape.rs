fn sphere(a: f64) -> (s, v:) {
    dot(v, v) == s * a;
}
