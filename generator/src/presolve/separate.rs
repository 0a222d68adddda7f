//! Puts a linear form of the unknowns in the place of one of them.
//!
//! Where solutions share the values of every unknown, such as the equilibria of species of which
//! some are absent, no unknown is an action monomial whose eigenvalues tell the solutions apart. A
//! linear form with general coefficients does:
//!
//! ```text
//!   x_i  ->  x_i + sum over the other unknowns j of c_j x_j
//! ```
//!
//! In the equations that result, x_i stands for t = x_i - sum of c_j x_j. Their solutions have
//! different values of t. After the solve x_i is recovered by the same substitution.

use super::reduced::{Recovery, ReducedProblem};
use super::substitute::substitute;
use crate::algebra::Monomial;
use crate::expression::SymbolicPolynomial;
use crate::expression::rational::Rational;

/// Substitutes the form in the place of the last unknown of the lowest degree: powers of the form
/// are then low monomials, and the basis falls into few chains. Nothing changes if an equation
/// would grow too long.
pub(super) fn separate(reduced: &mut ReducedProblem) {
    let degree = |unknown: &usize| {
        let exponents = reduced.problem.polynomials().flat_map(|p| p.monomials()).map(|m| m.exponent(*unknown));
        exponents.max().unwrap_or(0)
    };
    let Some(&replaced) = reduced.kept.iter().rev().min_by_key(|&unknown| degree(unknown)) else { return };
    let mut problem = reduced.problem.clone();
    let graph = &mut problem.graph;
    let mut terms = vec![(Monomial::unknown(replaced), graph.constant(Rational::ONE))];
    let others = reduced.kept.iter().filter(|&&unknown| unknown != replaced);
    for (at, &unknown) in (0..).zip(others) {
        let Some(coefficient) = coefficient(at) else { return };
        terms.push((Monomial::unknown(unknown), graph.constant(coefficient)));
    }
    let value = SymbolicPolynomial::from_terms(terms);
    for statement in problem.equations.iter_mut().chain(&mut problem.nonzero) {
        let Some(substituted) = substitute(graph, &statement.polynomial, replaced, &value) else { return };
        statement.polynomial = substituted;
    }
    reduced.problem = problem;
    reduced.separated = Some(replaced);
    reduced.recoveries.push(Recovery { unknown: replaced, value });
}

/// The coefficients of the form: about 1, of both signs, and in no simple ratio to each other.
fn coefficient(at: i64) -> Option<Rational> {
    let sign = if at % 2 == 0 { 1 } else { -1 };
    Rational::new(sign * (2 * at + 4), at + 5)
}

#[cfg(test)]
mod tests {
    use crate::presolve::{Presolve, presolve};
    use crate::problem::Problem;

    #[test]
    fn the_form_takes_the_place_of_the_unknown_of_lowest_degree() {
        let text =
            "fn sample(a: [f64; 2]) -> (x, y, z) { z == x * x + 1; x.pow(3) == a[0] * y; y * (x - y) == a[1] * x; }";
        let problem = Problem::parse("sample.rs", text).unwrap();
        let [constant, separated] = [Presolve::Constant, Presolve::Separated].map(|how| presolve(&problem, how));
        assert_eq!((&separated.kept, separated.separated), (&constant.kept, Some(1)));
        // First y from the form, then z from x.
        let order: Vec<usize> = separated.recoveries.iter().map(|recovery| recovery.unknown).collect();
        assert_eq!(order, [1, 2]);
        let terms: Vec<usize> = separated.problem.polynomials().map(|p| p.terms().len()).collect();
        // x^3, x, y; x^2, x y, y^2, x.
        assert_eq!(terms, [3, 4]);
        assert_eq!(constant.separated, None);
    }
}
