//! The tutorial problem: every construct of the language that small problems need, and what the
//! generator does with it.
//!
//! A problem file is Rust syntax, so editors and rustfmt work on it, but it is never compiled: the
//! body is interpreted symbolically. Parameters are the data, known when the solver runs; the names
//! in the return type are the unknowns.

/// The intersection of two general conics: 4 solutions by Bézout's theorem.
///
/// Kukelova, Bujnak, Pajdla, "Automatic Generator of Minimal Problem Solvers", ECCV 2008, use two
/// such quadrics as their running example.
///
/// `p` and `q` hold the coefficients of x^2, x y, y^2, x, y, 1.
fn two_conics(p: [f64; 6], q: [f64; 6]) -> (x, y) {
    // `let` names an intermediate value; this one is an array of six polynomials.
    let monomials = [x * x, x * y, y * y, x, y, 1];
    // An equation is a statement with `==`. Here each side is a scalar; between arrays it would
    // hold for every element.
    dot(p, monomials) == 0;
    dot(q, monomials) == 0;
}
