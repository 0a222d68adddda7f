fn plane(a: [f64; 3], b: [f64; 3]) -> (x, y, z) {
    let p = [x, y, z];
    doot(a, p) == 1;
    distance(b, p) == 2;
    x(y + 1) == z;
}
