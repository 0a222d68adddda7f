fn problem(
    #[mean(of_shape)] a: [f64; 3],
    #[mean(of_root)] b: [f64; 1],
    #[mean(of_nothing)] c: f64,
    #[mean(of_any)] d: f64,
    #[mean(stating)] e: f64,
    #[mean(untyped)] f: f64,
    #[mean(of_complex)] g: f64,
    #[mean(calling)] h: f64,
) -> (x) {
    x == a[0] + b[0] + c + d + e + f + g + h;
}

fn of_shape(p: [f64; 2]) -> [f64; 2] {
    p
}

fn of_root(p: f64) -> [f64; 1] {
    [sqrt(p)]
}

fn of_nothing() -> f64 {
    1
}

fn of_any(p: _) -> f64 {
    p
}

fn stating(p: f64) -> f64 {
    p == 1;
    p
}

fn untyped(p: f64) {
    p
}

fn of_complex(p: Complex<f64>) -> f64 {
    p.re
}

fn calling(p: f64) -> f64 {
    calling(p)
}
