fn spaced(a__b: f64, S: f64, self_: f64) -> (x, x__1, T) {
    x * x + a__b * x__1 == S;
    x * x__1 == self_ * T;
}
