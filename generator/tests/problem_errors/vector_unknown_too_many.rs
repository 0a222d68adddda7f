fn rotations(a: [[f64; 3]; 3]) -> (s, first: [[f64; 3]; 3], second: [[f64; 3]; 3]) {
    first * second == s * a;
}
