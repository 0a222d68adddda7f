//! Divides by equations that give the square of an unknown: of a unit vector or quaternion, or of a
//! sine and a cosine.
//!
//! Let `c x^2 + rest = 0` be such an equation: c is a constant, and x does not occur in the rest.
//! Modulo it every polynomial is E + x O with E and O free of x, because x^2 can be replaced by r =
//! -rest / c. An equation f and its multiple x f have the remainders
//!
//! ```text
//!   f    ->  E + x O
//!   x f  ->  r O + x E
//! ```
//!
//! Both are in the ideal. As x^2 f leaves r times the first, their multiples by the other unknowns
//! give all multiples of f modulo the equation. The equation itself needs no rows of the template
//! any more. An offline Schur complement of its multiples achieves the same (Martyushev, Bhayani,
//! Pajdla, arXiv 2307.00320).
//!
//! Several such equations, as for the sines and cosines of several angles, divide one after
//! another.

use super::reduced::{MAX_TERMS, ReducedProblem};
use super::substitute::coefficient;
use crate::algebra::Monomial;
use crate::expression::{ExpressionGraph, SymbolicPolynomial};
use crate::problem::Problem;

/// With more equations than this there is no further division: each doubles their number at most.
const MOST_EQUATIONS: usize = 60;

/// Replaces the other equations by their remainders and those of their multiples, for one divisor
/// after another. Nothing changes if no equation gives a square, or if an equation would grow too
/// long.
pub(super) fn divide_by_squares(reduced: &mut ReducedProblem) {
    let mut divided_by = Vec::new();
    while reduced.problem.equations.len() <= MOST_EQUATIONS
        && let Some((equation, unknown)) = square(reduced, &divided_by)
        && let Some(problem) = divided(reduced, equation, unknown)
    {
        reduced.problem = problem;
        divided_by.push(unknown);
    }
}

/// The divisor: the shortest equation that holds an unknown only as its square, and no unknown of
/// an earlier divisor.
fn square(reduced: &ReducedProblem, divided_by: &[usize]) -> Option<(usize, usize)> {
    let graph = &reduced.problem.graph;
    let mut found = Vec::new();
    for (equation, polynomial) in reduced.problem.polynomials().enumerate() {
        let holds = |unknown: usize| polynomial.monomials().any(|m| m.exponent(unknown) != 0);
        if divided_by.iter().any(|&unknown| holds(unknown)) {
            continue;
        }
        for &unknown in &reduced.kept {
            let x = Monomial::unknown(unknown);
            let mut with_x = polynomial.terms().iter().filter(|(m, _)| m.exponent(unknown) != 0);
            if let (Some(&(monomial, c)), None) = (with_x.next(), with_x.next())
                && monomial == x.times(&x)
                && graph.as_constant(c).is_some()
            {
                found.push((polynomial.terms().len(), equation, unknown));
            }
        }
    }
    // After division by the only equation none would be left.
    let (_, equation, unknown) = found.into_iter().min()?;
    (reduced.problem.equations.len() > 1).then_some((equation, unknown))
}

/// The problem divided by an equation that gives the square of an unknown; `None` if an equation
/// grows too long.
fn divided(reduced: &ReducedProblem, equation: usize, unknown: usize) -> Option<Problem> {
    let mut problem = reduced.problem.clone();
    let divisor = problem.equations.remove(equation).polynomial;
    let graph = &mut problem.graph;
    let (with_x, rest): (Vec<_>, Vec<_>) = divisor.terms().iter().copied().partition(|(m, _)| m.exponent(unknown) != 0);
    let inverse = graph.div(ExpressionGraph::ONE, with_x.first()?.1)?;
    let factor = graph.neg(inverse);
    let square = graph.polynomial_scale(&SymbolicPolynomial::from_terms(rest), factor);
    let x = graph.term(ExpressionGraph::ONE, Monomial::unknown(unknown));
    let mut equations = Vec::new();
    for statement in std::mem::take(&mut problem.equations) {
        let even = half(&mut problem.graph, &statement.polynomial, unknown, 0, &square)?;
        let odd = half(&mut problem.graph, &statement.polynomial, unknown, 1, &square)?;
        let graph = &mut problem.graph;
        let odd_times_x = graph.polynomial_mul(&odd, &x)?;
        let remainder = graph.polynomial_add(&even, &odd_times_x);
        let (constant, linear) = (graph.polynomial_mul(&odd, &square)?, graph.polynomial_mul(&even, &x)?);
        let of_multiple = graph.polynomial_add(&constant, &linear);
        // A remainder without x needs no second one: x times it is its own remainder.
        let both = if odd.is_zero() { vec![remainder] } else { vec![remainder, of_multiple] };
        for polynomial in both.into_iter().filter(|polynomial| !polynomial.is_zero()) {
            if polynomial.terms().len() > MAX_TERMS {
                return None;
            }
            let mut statement = statement.clone();
            statement.polynomial = polynomial;
            equations.push(statement);
        }
    }
    problem.equations = equations;
    Some(problem)
}

/// E for `parity` 0, or O for 1: the terms of even or odd degree in x, divided by x^parity, with
/// `square` for x^2.
fn half(
    graph: &mut ExpressionGraph,
    p: &SymbolicPolynomial,
    unknown: usize,
    parity: i8,
    square: &SymbolicPolynomial,
) -> Option<SymbolicPolynomial> {
    let highest = p.monomials().map(|m| m.exponent(unknown)).max().unwrap_or(0);
    // Horner's scheme in x^2.
    let mut result = SymbolicPolynomial::ZERO;
    for power in (0..=highest).rev().filter(|power| power % 2 == parity) {
        result = graph.polynomial_mul(&result, square)?;
        result = graph.polynomial_add(&result, &coefficient(p, unknown, power));
    }
    Some(result)
}

#[cfg(test)]
mod tests {
    use crate::algebra::{PRIMES, Polynomial, PrimeField};
    use crate::presolve::{Presolve, presolve};
    use crate::problem::Problem;
    use crate::problem::instance::Instance;

    const FIELD: PrimeField = PrimeField::new(PRIMES[0]);

    fn value(polynomial: &Polynomial<u32>, point: &[u32]) -> u32 {
        polynomial.terms().iter().fold(0, |sum, (m, c)| {
            let powers = point.iter().enumerate().map(|(at, &x)| FIELD.pow(x, m.exponent(at) as u32));
            FIELD.add(sum, FIELD.mul(*c, powers.fold(1, |product, power| FIELD.mul(product, power))))
        })
    }

    /// A point of the unit circle.
    fn on_circle(t: u32) -> [u32; 2] {
        let square = FIELD.mul(t, t);
        let inverse = FIELD.inverse(FIELD.add(1, square)).unwrap();
        [FIELD.mul(FIELD.add(t, t), inverse), FIELD.mul(FIELD.sub(1, square), inverse)]
    }

    #[test]
    fn remainders_take_the_values_of_the_equations_and_their_multiples_where_the_divisor_vanishes() {
        let text = "/// A cubic on a circle.\nfn cubic(a: [f64; 6]) -> (x, y) {\n    dot(a, [x * x * x, x * x * y, x * y, x, y, 1]) == 0;\n    \
                    x * x + y * y == 1;\n}\n";
        let problem = Problem::parse("cubic.rs", text).unwrap();
        let reduced = presolve(&problem, Presolve::Square);
        assert_eq!(reduced.kept, [0, 1]);
        let draw = |problem: &Problem| Instance::draw(problem, FIELD, 1).unwrap();
        let (before, after) = (draw(&problem), draw(&reduced.problem));
        assert_eq!(after.equations.len(), 2);
        assert!(after.equations.iter().flat_map(Polynomial::monomials).all(|m| m.exponent(0) <= 1));
        for t in 2..10 {
            let point = on_circle(t);
            assert_eq!(value(&before.equations[1], &point), 0);
            let f = value(&before.equations[0], &point);
            assert_eq!([0, 1].map(|at| value(&after.equations[at], &point)), [f, FIELD.mul(point[0], f)]);
        }
    }

    #[test]
    fn several_divisors_divide_one_after_another() {
        let text = "/// Two angles.\nfn angles(a: [[f64; 5]; 2]) -> (c, s, d, t) {\n    for i in 0..2 {\n        \
                    dot(a[i], [c * c * d, s * t, c, d, 1]) == 0;\n    }\n    c * c + s * s == 1;\n    d * d + t * t == 1;\n}\n";
        let problem = Problem::parse("angles.rs", text).unwrap();
        let reduced = presolve(&problem, Presolve::Square);
        assert_eq!(reduced.kept, [0, 1, 2, 3]);
        let draw = |problem: &Problem| Instance::draw(problem, FIELD, 1).unwrap();
        let (before, after) = (draw(&problem), draw(&reduced.problem));
        assert_eq!(after.equations.len(), 8);
        assert!(
            after.equations.iter().flat_map(Polynomial::monomials).all(|m| m.exponent(0) <= 1 && m.exponent(2) <= 1)
        );
        for t in 2..10 {
            let point = [on_circle(t), on_circle(t + 17)].concat();
            let multiples = |f: u32| {
                let [c, d] = [point[0], point[2]];
                [f, FIELD.mul(d, f), FIELD.mul(c, f), FIELD.mul(d, FIELD.mul(c, f))]
            };
            let expected = [0, 1].map(|at| multiples(value(&before.equations[at], &point)));
            let values: Vec<u32> = after.equations.iter().map(|equation| value(equation, &point)).collect();
            assert_eq!(values, expected.as_flattened());
        }
    }

    /// Modulo c^2 = 1 - s^2 the equation t^2 = a - c s holds c: division by it would bring c back.
    #[test]
    fn a_divisor_holds_no_unknown_of_an_earlier_one() {
        let text = "/// Two squares.\nfn squares(a: [f64; 4]) -> (c, s, t) {\n    c * c + s * s == 1;\n    \
                    t * t + c * s + a[1] * s + a[2] * c == a[0];\n    a[3] * c * t * t * t + s * t == 1;\n}\n";
        let problem = Problem::parse("squares.rs", text).unwrap();
        let equations = presolve(&problem, Presolve::Square).problem.equations;
        let highest = |unknown: usize| -> Vec<i8> {
            let of = |p: &crate::expression::SymbolicPolynomial| p.monomials().map(|m| m.exponent(unknown)).max();
            equations.iter().filter_map(|equation| of(&equation.polynomial)).collect()
        };
        assert_eq!((highest(0), highest(2)), (vec![1; 4], vec![2, 2, 3, 3]));
    }

    #[test]
    fn the_only_equation_stays() {
        let text = "/// A root.\nfn root(r: f64) -> (x) {\n    x * x == r;\n}\n";
        let problem = Problem::parse("root.rs", text).unwrap();
        assert_eq!(presolve(&problem, Presolve::Square).problem.fingerprint(), problem.fingerprint());
    }
}
