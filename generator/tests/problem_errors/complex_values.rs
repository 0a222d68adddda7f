fn p(a: Complex<f64>, m: [[Complex<f64>; 3]; 2], k: f64) -> (z: Complex<f64>, x) {
    z * a == Complex::new(1, 2);
    z > 0;
    z.norm() == 1;
    z.arg() == k;
    sqrt(a) * x == 1;
    null_space(m)[0][0] * x == k;
    x == complex(a, 1);
    x == complex([k, 1], 1);
    length(z) == x;
    let real: f64 = a;
    let [first, second] = gradient(x * x, [z, x]);
    z.conj() * z == x;
    z.real == x;
}

fn length(v: f64) -> f64 { v }
