fn derived(a: [[f64; 3]; 2], b: [[f64; 2]; 2], c: [f64; 3]) -> (x, y) {
    let n = null_space(a.t());
    let m = null_space([x, y]);
    let p = null_space([[x, y]]);
    let q = solve(b, c);
    let r = inverse(a);
    let s = solve([[a[0][0], a[0][0]], [b[0][0], b[0][0]]], [1, 2]);
    let t = reshape(c, [2, 2]);
    let u = c / (c[0] - c[0]);
    let v = sqrt(c);
    let w = norm([x, c[0]]);
    let z = sqrt(2);
    x == c[0] / c[1];
    y == dot(reshape(null_space(a), [3]), c) / a[0][0];
}
