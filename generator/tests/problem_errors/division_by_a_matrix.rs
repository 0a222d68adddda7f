fn affine(matrix: [[f64; 2]; 2], image: [f64; 2]) -> (x, y) {
    [x, y] == image / matrix;
    dot(image / [x, y], image) == 1;
}
