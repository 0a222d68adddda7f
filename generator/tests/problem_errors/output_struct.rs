fn helper(x: f64) -> f64 {
    Inner { x: x }
}

fn outputs(a: f64, b: f64) -> (x, y) {
    x * y == a;
    x == y * b + helper(b);
    Solution { x: x };
    Result { x: x };
    S { x: x };
    pose { x: x };
    Pose { Type: x, x: x, x: y, y: sqrt(x) + 1, z: sqrt([x, y]), v: 1 / [x, y] };
    Pose { x: x }
}
