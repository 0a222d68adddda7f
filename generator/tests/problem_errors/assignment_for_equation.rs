fn assigned(a: f64) -> (x, y) {
    let sum = x + y;
    x = a;
    sum = 1;
    a += x;
    let y = 2;
    x + 1 = 3;
}
