fn outputs(a: f64, b: f64) -> (x, y) {
    x * y == a;
    x == y * b;
    Pose {
        #[unit] direction: [x, y],
        #[projective] length: x,
        #[projective] pair: [complex(x, y), complex(y, x)],
        #[projective] #[rotation] line: [x, y],
    }
}
