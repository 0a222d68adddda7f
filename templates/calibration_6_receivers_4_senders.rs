/// Positions of six receivers and four senders from all ranges between them: 38 solutions.
///
/// Kuang, Burgess, Torstensson, Åström, "A complete characterization and solution to the microphone
/// position self-calibration problem", ICASSP 2013. Published as `toa_46`.
///
/// Relative to the first sender let G be the Gram matrix of the other three and K its inverse, [k11
/// v w; v k22 x; w x y]. A receiver with the squares r of its range to the first sender and s of
/// those to the others satisfies 4 r = c K c + 2 c g + a with c_j = r - s_j, g = K n, a = n K n and
/// n = diag(G). Six receivers give k11, k22, g and a as combinations, `linear`, of v, w, x, y and
/// 1. With C = adj(K) and z = det(K), n is diag(C) / z. M = [K g; g a] is K times [1 n] from both
/// sides: its adjugate is z times the square of (n, -1). The receivers follow from K.
fn calibration_6_receivers_4_senders(linear: [[f64; 5]; 6]) -> (v, w, x, y, z) {
    let [k11, k22, g1, g2, g3, a] = linear * [v, w, x, y, 1];
    let c11 = k22 * y - x * x;
    let c22 = k11 * y - w * w;
    let c33 = k11 * k22 - v * v;
    let c12 = w * x - v * y;
    let c13 = v * x - w * k22;
    let c23 = v * w - k11 * x;
    let diagonal = [c11, c22, c33];
    let k = [[k11, v, w], [v, k22, x], [w, x, y]];
    let g = [g1, g2, g3];
    let adjoint = [[c11, c12, c13], [c12, c22, c23], [c13, c23, c33]];
    adjoint * g == diagonal;
    z * g == k * diagonal;
    z * a == dot(diagonal, g);
    z == k11 * c11 + v * c12 + w * c13;
    z != 0;
    let m = [[k11, v, w, g1], [v, k22, x, g2], [w, x, y, g3], [g1, g2, g3, a]];
    det(m) == 0;
    for i in 0..3 {
        for j in i..3 {
            let [p, q, r] = [m[(i + 1) % 3], m[(i + 2) % 3], m[3]];
            let [s, t] = [(j + 1) % 3, (j + 2) % 3];
            z * det([[p[s], p[t], p[3]], [q[s], q[t], q[3]], [r[s], r[t], r[3]]]) == diagonal[i] * diagonal[j];
        }
    }
}
