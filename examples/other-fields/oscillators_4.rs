/// The phases at which four coupled oscillators keep time (Kuramoto's model): 20 solutions.
///
/// Coss, Hauenstein, Hong, Molzahn, "Locating and counting equilibria of the Kuramoto model with
/// rank-one coupling", SIAM Journal on Applied Algebra and Geometry, 2018; general coupling has
/// C(6, 3) = 20 equilibria (Baillieul and Byrnes 1982). The phase of oscillator 0 is 0.
///
/// `coupling` are those of the pairs 01, 02, 03, 12, 13, 23, `drift` the natural frequencies of
/// oscillators 1 to 3, less their mean. The unknowns are sines and cosines of the phases.
fn oscillators_4(coupling: [f64; 6], drift: [f64; 3]) -> (s: [f64; 3], c: [f64; 3]) {
    for i in 0..3 {
        s[i].pow(2) + c[i].pow(2) == 1;
    }
    let to_first = coupling[3] * (s[0] * c[1] - c[0] * s[1]);
    let to_second = coupling[4] * (s[0] * c[2] - c[0] * s[2]);
    let to_third = coupling[5] * (s[1] * c[2] - c[1] * s[2]);
    coupling[0] * s[0] + to_first + to_second == drift[0];
    coupling[1] * s[1] - to_first + to_third == drift[1];
    coupling[2] * s[2] - to_second - to_third == drift[2];
}
