/// The circles tangent to three lines: 4 solutions (the incircle and the three excircles of the
/// triangle).
///
/// Gummeson & Oskarsson, "Robust and Accurate Cylinder Triangulation", the minimal three-line
/// solver.
///
/// A line l = (a, b, c) is tangent to the circle with dual conic D = [d1 d2 d3; d2 d4 d5; d3 d5 d6]
/// if l^T D l = 0: one linear equation in d = (d1, .., d6), (a^2, 2ab, 2ac, b^2, 2bc, c^2) d = 0.
/// Three lines leave a null space of dimension three, d = a d_alpha + b d_beta + d_gamma, in which
/// the two constraints of a circle, d2 d6 = d3 d5 and (d1 - d4) d6 = d3^2 - d5^2, pick four points.
fn circle_minimal(d_alpha: [f64; 6], d_beta: [f64; 6], d_gamma: [f64; 6]) -> (a, b) {
    let d = a * d_alpha + b * d_beta + d_gamma;
    d[2] * d[4] - d[1] * d[5] == 0;
    d[4] * d[4] - d[2] * d[2] + d[0] * d[5] - d[3] * d[5] == 0;
}
