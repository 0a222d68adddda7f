fn slices(v: [f64; 3], m: [[f64; 2]; 3]) -> (x, y) {
    let a = v[1..1];
    let b = v[2..=3];
    let c = x[0..1];
    let d = v[0..y];
    let e = concat(v, m);
    let f = concat(m, 1);
    let g = concat(v);
    let h = m[-1..2][0];
    let mut k = v;
    k[0..2] = [x, y];
    concat(x, y) == v[0..2];
}
