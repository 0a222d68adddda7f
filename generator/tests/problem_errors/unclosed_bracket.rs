fn equal(a: f64) -> (x, y) {
    // a comment with a ( does not count
    x * (y + a == 1;
    x == y;
