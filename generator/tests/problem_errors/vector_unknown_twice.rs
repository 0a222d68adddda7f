fn twice(a: [f64; 3], v: f64) -> (v: [f64; 3], x, v: [f64; 2]) {
    v == a;
}
