fn attributes(
    #[symmetric] a: [[f64; 2]; 3],
    #[rotation] b: [[f64; 2]; 2],
    #[unit] c: f64,
    #[rank(2)] d: [[f64; 3]; 2],
    #[rank(1)] e: [f64; 3],
    #[plucker] f: [f64; 6],
) -> (x, y) {
    a * [x, y] == [1, 2];
}
