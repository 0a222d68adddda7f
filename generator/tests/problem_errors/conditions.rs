fn conditions(a: [f64; 2]) -> (x, y) {
    if x == 0 {
        y == 1;
    }
    for k in 0..2 {
        if a[k] > 0 {
            x == a[k];
        }
        if k {
            y == 0;
        }
        if k + 1 {
            y == 1;
        }
        if a == 0 {
            y == 2;
        }
        let c = if k < 2 { x };
        let d = if k > 2 { x };
        match k {
            0 => x,
            _ => y,
        }
        c * y == a[1];
    }
    if true {
        x * y == z;
    } else {
        y == w;
    }
}
