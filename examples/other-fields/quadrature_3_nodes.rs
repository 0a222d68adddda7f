/// The quadrature with three nodes that is exact up to degree 5 (Gauss): 6 solutions, which are one
/// with its nodes in any order.
///
/// Verschelde and Gatermann, "Symmetric Newton polytopes for solving sparse polynomial systems",
/// Advances in Applied Mathematics 1995.
///
/// `moments` are the integrals of x^0 to x^5 against the weight function.
fn quadrature_3_nodes(moments: [f64; 6]) -> (w: [f64; 3], x: [f64; 3]) {
    for k in 0..6 {
        w[0] * x[0].pow(k) + w[1] * x[1].pow(k) + w[2] * x[2].pow(k) == moments[k];
    }
}
