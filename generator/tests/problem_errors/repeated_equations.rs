fn parallel(a: [f64; 3]) -> (x, y, z, w) {
    let p = [x, y * w, z];
    let s = skew(cross(a, p));
    s == 0;
}
