fn equal(a: f64) -> (x, y)
