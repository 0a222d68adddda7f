fn attributes(
    #[symetric] a: [[f64; 2]; 2],
    #[positive] b: f64,
    #[unit] #[integer] c: [f64; 3],
) -> (x, y) {
    a * [x, y] == [b, c[0]];
}
