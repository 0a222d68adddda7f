fn sphere(a: [f64; 3]) -> (#[unit] v: [f64; 3], s) {
    s * v == a;
}
