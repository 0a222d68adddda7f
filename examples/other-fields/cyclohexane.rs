/// The shapes of a ring of six atoms, cyclohexane: 16 solutions.
///
/// Emiris and Mourrain, "Computer algebra methods for studying and computing molecular
/// conformations", Algorithmica 1999: the bond lengths and angles leave three equations in the half
/// tangents of three flap angles.
///
/// `b` holds the coefficients of 1, t^2, u^2, t u, t^2 u^2 for each pair of neighbours.
fn cyclohexane(b: [[f64; 5]; 3]) -> (t: [f64; 3]) {
    for [i, j, k] in [[0, 1, 2], [1, 2, 0], [2, 0, 1]] {
        let [u, v] = [t[j], t[k]];
        dot(b[i], [1, u.pow(2), v.pow(2), u * v, u.pow(2) * v.pow(2)]) == 0;
    }
}
