fn large(a: f64) -> (x, y) {
    let s = 1 + x + y;
    let t = s.pow(16) * s.pow(16) * s;
    for i in 0..100000 {
        x == i;
    }
    let u = [[0; 200]; 200];
    let v = 99999999999999999999999 * x;
    for i in 0..10000 {
        for j in 0..10000 {
            let w = x * i;
        }
    }
    x == y;
}
