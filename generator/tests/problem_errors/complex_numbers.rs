// Complex numbers where real ones are meant, and their habits from Rust.
fn p(
    a: Complex<f64>,
    b: Complex<f32>,
    c: Complex64,
    #[symmetric] d: [[Complex<f64>; 2]; 2],
) -> (z: Complex<f64>, #[projective] v: [Complex<f64>; 3]) {
    z * a == 1;
}
