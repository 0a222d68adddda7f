const N: f64 = 2;

fn problem(
    #[mean] a: [f64; 3],
    #[mean(of_pont)] b: [f64; 3],
    #[mean(absent)] c: [f64; 3],
    #[mean(of_point)] #[mean(of_point)] d: [f64; 3],
    #[mean(of_point)] e: [Complex<f64>; 3],
) -> (x, y) {
    x + y == a[0] + b[0] + c[0];
    x * y == d[0];
}

fn of_point(p: [f64; N]) -> [f64; 3] {
    [p[0], p[1], 1]
}
