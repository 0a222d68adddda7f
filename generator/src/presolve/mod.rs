//! Combines equations, solves them for monomials, and eliminates unknowns that an equation gives
//! explicitly.
//!
//! An equation `c x + rest = 0`, where x occurs in no other term and c depends on the data only,
//! gives `x = -rest / c`. The unknown is substituted in all other equations, and recovered after
//! the solve. Substitution can also hurt, because degrees and coefficients grow: a search judges
//! all of [`crate::presolve::Presolve`] side by side.
//!
//! Unknowns that occur linearly, with coefficients that depend on others, are eliminated by
//! determinants. Where solutions share the values of unknowns, a linear form of them takes the
//! place of one.

mod combine;
mod cramer;
mod determinants;
pub mod exchange;
mod gauss_jordan;
mod minors;
pub(crate) mod pair;
mod reduced;
mod separate;
mod square;
mod substitute;
pub mod symmetry;

use combine::combine;
use determinants::eliminate_linear;
use gauss_jordan::{solve_for_leads, solve_linear_equations};
use pair::pair;
use separate::separate;
use square::divide_by_squares;
use substitute::substitute;
use symmetry::Symmetry;

pub(crate) use determinants::MOST_LINEAR;
pub use reduced::{LinearBlock, Presolve, Recovery, ReducedProblem};

use crate::algebra::Monomial;
use crate::expression::{ExpressionGraph, ExpressionId, SymbolicPolynomial};
use crate::problem::Problem;

/// Presolves a problem: combines equations, eliminates unknowns as long as an equation gives one,
/// solves for monomials, and divides by squares. Each step is done only if `presolve` asks for it.
///
/// Unknowns with constant coefficients are eliminated first, then those with short right-hand
/// sides.
pub fn presolve(problem: &Problem, presolve: Presolve) -> ReducedProblem {
    let mut reduced = ReducedProblem {
        problem: problem.clone(),
        kept: (0..problem.unknowns.len()).collect(),
        linear: None,
        recoveries: Vec::new(),
        is_solved_for_leads: false,
        separated: None,
        pairs: Vec::new(),
        symmetry: Symmetry::of_problem(problem),
    };
    if presolve == Presolve::Paired {
        pair(&mut reduced);
    }
    if presolve.combines() {
        combine(&mut reduced.problem);
    }
    if presolve.solves_at_run_time() {
        solve_linear_equations(&mut reduced.problem);
    }
    eliminate_all(&mut reduced, presolve);
    if let Some(hidden) = presolve.solves_for_leads()
        && hidden.is_none_or(|unknown| reduced.kept.contains(&unknown))
        && solve_for_leads(&mut reduced.problem, hidden)
    {
        reduced.is_solved_for_leads = true;
        eliminate_all(&mut reduced, presolve);
    }
    match presolve {
        Presolve::Separated => {
            separate(&mut reduced);
            // A linear form has no sign.
            reduced.symmetry = Symmetry::NONE;
        }
        Presolve::Determinants(unknown) => eliminate_linear(&mut reduced, usize::from(unknown)),
        _ => {}
    }
    // Recovery runs backwards: the unknown that was eliminated last depends on kept unknowns only.
    reduced.recoveries.reverse();
    if presolve.divides() || reduced.linear.is_some() {
        divide_by_squares(&mut reduced);
    }
    reduced
}

/// Eliminates unknowns as long as an equation gives one.
fn eliminate_all(reduced: &mut ReducedProblem, presolve: Presolve) {
    while reduced.kept.len() > 1 {
        let mut candidates = candidates(reduced, presolve);
        candidates.sort_by_key(|candidate| candidate.preference);
        if !candidates.iter().any(|candidate| eliminate(reduced, candidate)) {
            break;
        }
    }
}

/// An unknown that an equation gives explicitly.
struct Candidate {
    equation: usize,
    unknown: usize,
    coefficient: ExpressionId,
    /// Smaller is better: (data-dependent, terms, equation, unknown).
    preference: (bool, usize, usize, usize),
}

/// The unknowns that can be eliminated: each occurs in one term of the equation only, by itself.
fn candidates(reduced: &ReducedProblem, presolve: Presolve) -> Vec<Candidate> {
    let mut found = Vec::new();
    if presolve == Presolve::None {
        return found;
    }
    let graph = &reduced.problem.graph;
    for (equation, polynomial) in reduced.problem.polynomials().enumerate() {
        for &unknown in &reduced.kept {
            let x = Monomial::unknown(unknown);
            let mut with_x = polynomial.terms().iter().filter(|(m, _)| m.exponent(unknown) != 0);
            let (Some(&(monomial, coefficient)), None) = (with_x.next(), with_x.next()) else { continue };
            let depends_on_data = graph.as_constant(coefficient).is_none();
            if monomial == x && !(depends_on_data && presolve.is_constant()) {
                let preference = (depends_on_data, polynomial.terms().len(), equation, unknown);
                found.push(Candidate { equation, unknown, coefficient, preference });
            }
        }
    }
    found
}

/// Substitutes one unknown everywhere. Returns false, and changes nothing, if an equation would
/// grow too long or an exponent overflow.
fn eliminate(reduced: &mut ReducedProblem, candidate: &Candidate) -> bool {
    let mut problem = reduced.problem.clone();
    let equation = problem.equations.remove(candidate.equation);
    let graph = &mut problem.graph;
    let Some(inverse) = graph.div(ExpressionGraph::ONE, candidate.coefficient) else { return false };
    let factor = graph.neg(inverse);
    let x = Monomial::unknown(candidate.unknown);
    let rest =
        SymbolicPolynomial::from_terms(equation.polynomial.terms().iter().filter(|&&(m, _)| m != x).copied().collect());
    let value = graph.polynomial_scale(&rest, factor);
    for statement in problem.equations.iter_mut().chain(&mut problem.nonzero) {
        let Some(substituted) = substitute(graph, &statement.polynomial, candidate.unknown, &value) else {
            return false;
        };
        statement.polynomial = substituted;
    }
    problem.equations.retain(|statement| !statement.polynomial.is_zero());
    reduced.problem = problem;
    reduced.kept.retain(|&unknown| unknown != candidate.unknown);
    reduced.recoveries.push(Recovery { unknown: candidate.unknown, value });
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    fn eliminated(equations: &str, how: Presolve) -> (Vec<usize>, Vec<usize>) {
        let text = format!("fn sample(a: [f64; 9]) -> (x, y, z) {{ {equations} }}");
        let reduced = presolve(&Problem::parse("sample.rs", &text).unwrap(), how);
        let order = reduced.recoveries.iter().map(|recovery| recovery.unknown).collect();
        assert_eq!(reduced.problem.equations.len(), reduced.kept.len(), "{equations}");
        (order, reduced.kept)
    }

    /// The list of recoveries runs backwards: what is eliminated first is recovered last.
    #[test]
    fn constant_coefficients_and_short_sides_go_first() {
        let all_linear = "a[0] * x + y * y == z; x * x + y + y * z * z == 1; z * z + x * y == a[1];";
        assert_eq!(eliminated(all_linear, Presolve::Linear), (vec![2], vec![0, 1]));
        assert_eq!(eliminated(all_linear, Presolve::Constant), (vec![2], vec![0, 1]));
        assert_eq!(eliminated(all_linear, Presolve::None), (vec![], vec![0, 1, 2]));
        // y is given with a constant, x with data; y by the shorter equation.
        let both = "a[0] * x + z * z + z == 1; y + x * x + x * z + z * z == 2; y == x * z + 1;";
        let text = format!("fn sample(a: [f64; 9]) -> (x, y, z) {{ {both} }}");
        let reduced = presolve(&Problem::parse("sample.rs", &text).unwrap(), Presolve::Linear);
        let found: Vec<_> = reduced.recoveries.iter().map(|r| (r.unknown, r.value.terms().len())).collect();
        assert_eq!(found, [(0, 3), (1, 2)]);
        assert_eq!(eliminated(both, Presolve::Constant), (vec![1], vec![0, 2]));
    }

    /// Also where an equation gives it.
    #[test]
    fn the_last_unknown_is_kept() {
        let linear = "x == a[0] + y; y == a[1] * z; z + a[2] * x == 1;";
        for how in [Presolve::Linear, Presolve::Constant] {
            let (order, kept) = eliminated(linear, how);
            assert_eq!((order.len(), kept.len()), (2, 1), "{how:?}");
        }
    }

    /// The sixth power of a sum of nine squares has 3003 terms.
    #[test]
    fn what_grows_too_long_is_not_substituted() {
        let names = ["b", "c", "d", "e", "f", "g", "h", "i", "j"];
        let squares = names.map(|x| format!("{x} * {x}")).join(" + ");
        let others = names.windows(3).map(|xyz| format!("{} == 2;", xyz.join(" * "))).collect::<String>();
        let presolved = |text: &str, how| {
            let text = format!("fn long() -> (x, b, c, d, e, f, g, h, i, j) {{ {text} {others} j * b * c == 3; }}");
            let problem = Problem::parse("long.rs", &text).unwrap();
            let reduced = presolve(&problem, how);
            (reduced.kept.len(), reduced.problem.fingerprint() == problem.fingerprint())
        };
        let linear = |power| presolved(&format!("x == {squares}; x.pow({power}) == b * c;"), Presolve::Constant);
        assert_eq!((linear(2), linear(6)), ((9, false), (10, true)));
        let square = |power| presolved(&format!("x * x == {squares}; x.pow({power}) == b * c;"), Presolve::Square);
        assert_eq!((square(4), square(12)), ((10, false), (10, true)));
    }
}
