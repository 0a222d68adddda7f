fn circle(radius: f64) -> (x, y) {
    let height = y - 1;
    x * x + heigth * y == radus;
    x * height == z;
}
