//! Subtracts constant multiples of equations from others, so that their highest terms cancel.
//!
//! The equations of two spheres, `dot(x - a, x - a) == r * r`, share all terms of degree two: their
//! difference is linear.
//!
//! ```text
//!   f = c m + ..       f and g have the highest monomial m in common, with constants c and d;
//!   g = d m + ..       f is the shortest such equation:   g  ->  g - (d / c) f,   without m
//! ```
//!
//! Without this a template needs rows of both equations to form the difference, and an unknown that
//! the difference gives is not eliminated.

use crate::algebra::Monomial;
use crate::expression::SymbolicPolynomial;
use crate::problem::Problem;

/// Gaussian elimination on the terms of degree two and more, highest first, as far as they have
/// constant coefficients. Of the equations with the same highest term, the shortest is subtracted
/// from all others: this keeps the others short.
pub(super) fn combine(problem: &mut Problem) {
    let mut monomials: Vec<Monomial> = problem.polynomials().flat_map(|p| p.monomials()).collect();
    monomials.sort_by_key(|m| std::cmp::Reverse(rank(m)));
    monomials.dedup();
    for monomial in monomials.into_iter().take_while(|m| m.degree() > 1) {
        let graph = &mut problem.graph;
        // Only a constant pivot is safe: one that depends on data may be 0.
        let is_led = |p: &SymbolicPolynomial| {
            p.monomials().max_by_key(rank) == Some(monomial)
                && p.coefficient(&monomial).is_some_and(|&c| graph.as_constant(c).is_some())
        };
        let equations = problem.equations.iter().enumerate();
        let mut led: Vec<usize> = equations.filter(|(_, e)| is_led(&e.polynomial)).map(|(at, _)| at).collect();
        led.sort_by_key(|&at| problem.equations[at].polynomial.terms().len());
        let Some((&first, others)) = led.split_first() else { continue };
        let shortest = problem.equations[first].polynomial.clone();
        for &other in others {
            let polynomial = &mut problem.equations[other].polynomial;
            let (Some(&c), Some(&of_first)) = (polynomial.coefficient(&monomial), shortest.coefficient(&monomial))
            else {
                continue;
            };
            let Some(factor) = graph.div(c, of_first) else { continue };
            let multiple = graph.polynomial_scale(&shortest, factor);
            *polynomial = graph.polynomial_sub(polynomial, &multiple);
        }
    }
    problem.equations.retain(|statement| !statement.polynomial.is_zero());
}

/// The order of terms: by degree, then canonical.
fn rank(m: &Monomial) -> (i32, Monomial) {
    (m.degree(), *m)
}

#[cfg(test)]
mod tests {
    use crate::presolve::{Presolve, presolve};
    use crate::problem::Problem;

    #[test]
    fn differences_of_spheres_are_linear() {
        let text = "fn spheres(c: [[f64; 3]; 4], r: [f64; 4]) -> (x, y, z, w) {
            for i in 0..4 { let v = [x, y, z] - c[i]; (i + 1) * dot(v, v) == (i + 1) * (w - r[i]).pow(2); }
        }";
        let problem = Problem::parse("spheres.rs", text).unwrap();
        let degrees = |how| -> Vec<i32> {
            let reduced = presolve(&problem, how);
            let of = |p: &crate::expression::SymbolicPolynomial| p.monomials().map(|m| m.degree()).max().unwrap_or(0);
            reduced.problem.polynomials().map(of).collect()
        };
        assert_eq!(degrees(Presolve::Constant), [2, 2, 2, 2]);
        assert_eq!(degrees(Presolve::Combined), [2, 1, 1, 1]);
        // Three unknowns are linear in the fourth.
        assert_eq!(degrees(Presolve::CombinedLinear), [2]);
    }

    #[test]
    fn what_has_other_highest_terms_stays_and_what_follows_goes() {
        let of = |equations: &str| {
            let problem =
                Problem::parse("sample.rs", &format!("fn sample(a: [f64; 9]) -> (x, y) {{ {equations} }}")).unwrap();
            let combined = presolve(&problem, Presolve::Combined).problem;
            (problem.equations.len(), combined.equations.len(), combined.fingerprint() == problem.fingerprint())
        };
        assert_eq!(of("x * x + a[0] * y == 1; x * y + a[1] * x == 2;"), (2, 2, true));
        // A coefficient that depends on data may be zero.
        assert_eq!(of("a[0] * x * x + y * y == 1; a[1] * x * x + x * y == 2;"), (2, 2, true));
        assert_eq!(of("x * x + a[0] * y == 1; 2 * x * x + 2 * a[0] * y == 2; y * y == a[2];"), (3, 2, false));
    }

    #[test]
    fn the_shortest_equation_stays_and_linear_ones_do() {
        let both = |equations: &str| {
            let text = format!("fn sample(a: [f64; 9]) -> (x, y) {{ {equations} }}");
            let problem = Problem::parse("sample.rs", &text).unwrap();
            let mut combined = problem.clone();
            super::combine(&mut combined);
            [problem, combined].map(|p| p.polynomials().cloned().collect::<Vec<_>>())
        };
        let [before, after] = both("x * x + a[0] * x * y + a[1] * y == 1; x * x + a[2] * y == 0;");
        assert_eq!(after[1], before[1]);
        assert!(after[0].monomials().all(|m| m.exponent(0) < 2) && !after[0].is_zero());
        let [before, after] = both("x * x * y == a[0] * y; x * y * y == 1; x + a[2] * y == 1; 2 * x - y == 3;");
        assert_eq!(after, before);
    }
}
