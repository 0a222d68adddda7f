fn positive(a: [[f64; 3]; 2]) -> (#[projective] v: [f64; 3]) {
    a * v == 0;
    v[0] > 0;
    v[0] * v[1] > 0;
}
