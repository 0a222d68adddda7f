use std::f64;

struct Point;

#[inline]
unsafe fn generic<T>(a: f64) -> (x, y) {
    x == a;
    y == a;
}
