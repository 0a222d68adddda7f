fn counts(n: usize, p: [[f64; 2]; 4]) -> (x, y) {
    for k in 0..n {
        dot(p[k], [x, y]) == 1;
    }
}
