fn arguments(m: [[f64; 3]; 2], v: [f64; 2]) -> (x, y) {
    det(m) == x;
    trace(v) == x;
    dot(v, [x, y, 1]) == 0;
    cross(v, v) == 0;
    skew(m) == 0;
    identity(x) == 0;
    gradient([x, y]) == 0;
    gradient(x * y, [x, v[0]]) == 0;
    dot(v) == x;
    v.t() == [x, y];
    m.transpose() == x;
    v.dot(v) == y;
}
