fn choices(keys: [f64; 2], values: [[f64; 3]; 3], other: [[f64; 3]; 2]) -> (x, y) {
    let a = least(keys, values);
    let b = least([x, y], other);
    let c = least(keys, [[x, y], [y, x]]);
    let d = least(other, keys);
    let e = least(keys);
    let f = min(keys[0], keys[1]);
    x == least(keys, other)[0];
    y == least(keys, keys);
}
