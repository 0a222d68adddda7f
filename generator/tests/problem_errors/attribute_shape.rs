fn attributes(
    #[symmetric] a: [[f64; 2]; 3],
    #[rotation] b: [[f64; 2]; 2],
    #[unit] c: f64,
) -> (x, y) {
    a * [x, y] == [1, 2];
}
