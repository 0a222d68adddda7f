fn unsupported(v: [f64; 3]) -> (x, y) {
    let a = if x == 0 { 1 } else { 2 };
    let b = &v;
    let c = v[0] as f64;
    let (d, e) = (x, y);
    let f = v.iter();
    while x == y {
        x == 1;
    }
    for i in x {
        x == i;
    }
    for i in 0.. {
        x == i;
    }
    assert_eq!(x, y);
    return x;
    let g = |t| t * t;
    let h: [f64; 2] = v;
    let [k, l] = v;
    let pi = std::f64::consts::PI;
    x == "one";
}
