fn shapes(m: [[f64; 3]; 4], v: [f64; 4]) -> (x, y) {
    let p = [x, y, 1];
    m * p - [x, y] == 0;
    m * v == 0;
    p + 1 == [0, 0, 0];
    p * p == 2;
    m == x;
}
