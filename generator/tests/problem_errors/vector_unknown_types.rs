const N: f64 = 2;

fn types(a: f64) -> (t: [f64], u: [f64; 0], v: [_; N], w: [i32; N], [f64; 3], x: [f64; M], det: [f64; N], Y: f64) {
    a == 1;
}
