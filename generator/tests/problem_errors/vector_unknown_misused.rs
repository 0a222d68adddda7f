fn misused(a: [f64; 2]) -> (v: [f64; 2], s) {
    v == 1;
    v[2] == s;
    v = a;
    let v = a;
    v.x == s;
    v * v == s;
    v != 0;
    gradient(v) == 0;
    gradient(s * s, 2 * v) == 0;
}
