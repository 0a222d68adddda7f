fn attributes(
    #[symetric] a: [[f64; 2]; 2],
    #[positive] b: f64,
    #[unit] #[integer] c: [f64; 3],
    #[rank] d: [[f64; 3]; 3],
    #[rank(0)] e: [[f64; 3]; 3],
    #[unit(2)] f: [f64; 3],
) -> (x, y) {
    a * [x, y] == [b, c[0]];
}
