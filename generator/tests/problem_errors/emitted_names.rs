fn result(given_: f64, b: f64) -> (x, y_) {
    x + y_ == given_;
    x - y_ == b;
}
