fn conics(a: [f64; 6], b: [f64; 6]) -> (#[projective] point: [f64; 3]) {
    let [x, y, z] = point;
    dot(a, [x * x, x * y, y * y, x * z, y * z, z * z]) == 0;
    dot(b, [x * x, x * y, y * y, x, y, 1]) == 0;
    x + y * y != 0;
}
