fn types(a: f32, b: &[f64], c: Vec<f64>, d: [f64; 0], e: _, (f, g): f64, h: [[f64; 200]; 200]) -> (x, y) {
    x + y == a;
    x * y == 1;
}
