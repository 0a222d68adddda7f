//! Half the sum and half the difference in the place of two unknowns that can be exchanged.
//!
//! The exchange is a change of sign then, which templates know how to use ([`super::symmetry`]):
//!
//! ```text
//!   x = s + d      s = (x + y) / 2      x <-> y     s -> s,  d -> -d
//!   y = s - d      d = (x - y) / 2      x <-> -y    s -> -s, d -> d
//! ```
//!
//! The exchange maps an equation to a combination of all equations, and so does each of its two
//! parts, of the terms that change their sign and of those that keep it. The parts take the place
//! of the equations: x y = a and x^2 + y^2 + x + y = b become s^2 - d^2 = a and 2 s^2 + 2 d^2 + 2 s
//! = b. They span the same polynomials, and those that depend on others are left out.

use std::collections::BTreeMap;

use super::exchange::{Exchange, Pair, exchanges, instances, pairs_of, row};
use super::reduced::{MAX_TERMS, Recovery, ReducedProblem};
use super::symmetry::Symmetry;
use crate::algebra::{Echelon, Monomial, PrimeField};
use crate::expression::rational::Rational;
use crate::expression::{ExpressionGraph, ExpressionId, SymbolicPolynomial};
use crate::problem::instance::Instance;
use crate::problem::{Problem, Statement};

/// Puts half the sum and half the difference in the place of the unknowns that can be exchanged.
/// Nothing changes if there are none, if that gives no more changes of sign than there are, or if
/// an equation would grow too long.
pub(super) fn pair(reduced: &mut ReducedProblem) {
    let exchanges = exchanges(&reduced.problem);
    let pairs = pairs_of(&exchanges);
    let flips: Vec<Vec<bool>> = exchanges.iter().map(|exchange| flips_of(exchange, &pairs)).collect();
    let Some(problem) = in_sums_and_differences(&reduced.problem, &pairs, &flips) else { return };
    let symmetry = Symmetry::of_problem(&problem);
    if symmetry.order() <= reduced.symmetry.order() {
        return;
    }
    reduced.problem = problem;
    reduced.symmetry = symmetry;
    let graph = &mut reduced.problem.graph;
    for &[x, y] in &pairs {
        let mut sum_with = |factor: i64| {
            let factor = graph.constant(Rational::integer(factor));
            let terms = vec![(Monomial::unknown(x), ExpressionGraph::ONE), (Monomial::unknown(y), factor)];
            SymbolicPolynomial::from_terms(terms)
        };
        // The list runs backwards: first x = s + d, where s and d have the places of x and y, then
        // y = s - d = x - 2 d.
        let (of_x, of_y) = (sum_with(1), sum_with(-2));
        reduced.recoveries.push(Recovery { unknown: y, value: of_y });
        reduced.recoveries.push(Recovery { unknown: x, value: of_x });
    }
    reduced.pairs = pairs;
}

/// What a change of sign does to the unknowns, if half the sum and half the difference have the
/// places of the pairs.
pub(crate) fn images(unknowns: usize, flip: &[usize], pairs: &[Pair]) -> Exchange {
    let changes = |unknown: usize| flip.contains(&unknown);
    let mut images: Exchange = (0..unknowns).map(|at| (at as u8, changes(at))).collect();
    for &[x, y] in pairs {
        let (of_sum, of_difference) = (changes(x), changes(y));
        // -s - d is minus the unknown itself, s - d the other one, and -s + d minus the other one.
        let [of_x, of_y] = if of_sum == of_difference { [x, y] } else { [y, x] };
        (images[x], images[y]) = ((of_x as u8, of_sum), (of_y as u8, of_sum));
    }
    images
}

/// The signs that an exchange changes in sums and differences.
fn flips_of(exchange: &Exchange, pairs: &[Pair]) -> Vec<bool> {
    let mut flips: Vec<bool> = exchange.iter().map(|&(_, is_negated)| is_negated).collect();
    for &[x, y] in pairs {
        let (of, is_negated) = exchange[x];
        flips[y] = is_negated == (usize::from(of) == x);
    }
    flips
}

/// The problem in half the sums and half the differences of the pairs, split into parts that each
/// of the changes of sign keeps or negates. `None` if there are none, or if it grows too long.
fn in_sums_and_differences(problem: &Problem, pairs: &[Pair], flips: &[Vec<bool>]) -> Option<Problem> {
    if pairs.is_empty() {
        return None;
    }
    let mut paired = problem.clone();
    for statement in paired.equations.iter_mut().chain(&mut paired.nonzero) {
        statement.polynomial = substituted(&mut paired.graph, &statement.polynomial, pairs)?;
    }
    let mut values = Vec::new();
    for Instance { field, inputs, .. } in instances(problem)? {
        values.push((field, paired.graph.evaluate(field, &inputs)?));
    }
    // Expressions that are written in two ways may cancel all the same.
    let is_zero = |c: &ExpressionId| values.iter().all(|(_, values)| values[c.index()] == 0);
    let parts = |statement: &Statement| parts(statement, flips, &is_zero);
    let equations: Vec<Statement> = paired.equations.iter().flat_map(parts).collect();
    paired.equations = independent(equations, &values)?;
    let factors: Vec<Vec<Statement>> = paired.nonzero.iter().map(parts).collect();
    paired.nonzero = products(&mut paired.graph, factors)?;
    // A coefficient may vanish for data that satisfy their conditions.
    let (field, _) = values.first()?;
    Instance::draw(&paired, *field, 1).map(|_| paired)
}

/// A polynomial with x = s + d and y = s - d for all pairs, where s and d take the places of x and
/// y. Terms whose coefficients are the same are added up before they become expressions, so that
/// they cancel.
fn substituted(graph: &mut ExpressionGraph, p: &SymbolicPolynomial, pairs: &[Pair]) -> Option<SymbolicPolynomial> {
    let mut sums: BTreeMap<Monomial, BTreeMap<ExpressionId, Rational>> = BTreeMap::new();
    for &(monomial, coefficient) in p.terms() {
        let constant = graph.as_constant(coefficient);
        let (id, factor) = constant.map_or((coefficient, Rational::ONE), |constant| (ExpressionGraph::ONE, constant));
        for (monomial, count) in expanded(monomial, pairs)? {
            let sum = sums.entry(monomial).or_default().entry(id).or_insert(Rational::ZERO);
            *sum = sum.checked_add(factor.checked_mul(Rational::integer(count))?)?;
        }
        if sums.len() > MAX_TERMS {
            return None;
        }
    }
    let mut terms = Vec::new();
    for (monomial, sum) in sums {
        let mut total: Option<ExpressionId> = None;
        for (id, factor) in sum.into_iter().filter(|(_, factor)| *factor != Rational::ZERO) {
            let factor = graph.constant(factor);
            let product = graph.mul(factor, id);
            total = Some(total.map_or(product, |total| graph.add(total, product)));
        }
        terms.extend(total.filter(|&total| !graph.is_zero(total)).map(|total| (monomial, total)));
    }
    Some(SymbolicPolynomial::from_terms(terms))
}

/// The terms of a monomial, as integers times monomials; `None` if there are too many.
fn expanded(monomial: Monomial, pairs: &[Pair]) -> Option<Vec<(Monomial, i64)>> {
    let mut terms = vec![(monomial, 1)];
    for &[x, y] in pairs {
        let (a, b) = (monomial.exponent(x), monomial.exponent(y));
        if a < 0 || b < 0 {
            return None;
        }
        // (s + d)^a (s - d)^b: coefficients by increasing power of d.
        let mut power = vec![1i64];
        for sign in (0..a).map(|_| 1).chain((0..b).map(|_| -1)) {
            power.push(0);
            for k in (1..power.len()).rev() {
                power[k] = power[k].checked_add(sign * power[k - 1])?;
            }
        }
        let with = |&(m, factor): &(Monomial, i64)| {
            let mut exponents = *m.exponents();
            let term = |(k, &count): (usize, &i64)| {
                (exponents[x], exponents[y]) = (a + b - k as i8, k as i8);
                (Monomial::from_exponents(&exponents), factor * count)
            };
            power.iter().enumerate().map(term).filter(|(_, factor)| *factor != 0).collect::<Vec<_>>()
        };
        terms = terms.iter().flat_map(with).collect();
        if terms.len() > MAX_TERMS {
            return None;
        }
    }
    Some(terms)
}

/// The parts of a statement by the signs that change, without terms that are zero.
fn parts(statement: &Statement, flips: &[Vec<bool>], is_zero: &impl Fn(&ExpressionId) -> bool) -> Vec<Statement> {
    let mut parts: BTreeMap<Vec<bool>, Vec<(Monomial, ExpressionId)>> = BTreeMap::new();
    for &(m, c) in statement.polynomial.terms().iter().filter(|(_, c)| !is_zero(c)) {
        let is_negated = |flip: &Vec<bool>| {
            flip.iter().enumerate().filter(|&(at, &changes)| changes && m.exponent(at) % 2 != 0).count() % 2 == 1
        };
        parts.entry(flips.iter().map(is_negated).collect()).or_default().push((m, c));
    }
    let part = |terms| Statement { polynomial: SymbolicPolynomial::from_terms(terms), ..statement.clone() };
    parts.into_values().map(part).collect()
}

/// The equations that do not depend on those before them; `None` if these differ from instance to
/// instance. Short ones come first among the equations of a statement, and stay.
fn independent(equations: Vec<Statement>, values: &[(PrimeField, Vec<u32>)]) -> Option<Vec<Statement>> {
    let mut support: Vec<Monomial> = equations.iter().flat_map(|equation| equation.polynomial.monomials()).collect();
    support.sort_unstable();
    support.dedup();
    let mut kept: Option<Vec<bool>> = None;
    for (field, values) in values {
        let mut rows = Echelon::new(*field, support.len());
        let mut is_kept = |equation: &Statement| {
            let terms = equation.polynomial.terms().iter().map(|&(m, c)| (m, values[c.index()]));
            row(&support, terms.filter(|(_, c)| *c != 0)).is_some_and(|row| rows.insert_sparse(&row).is_some())
        };
        let here: Vec<bool> = equations.iter().map(&mut is_kept).collect();
        if kept.as_ref().is_some_and(|kept| *kept != here) {
            return None;
        }
        kept = Some(here);
    }
    let kept = kept?;
    Some(equations.into_iter().zip(kept).filter_map(|(equation, is_kept)| is_kept.then_some(equation)).collect())
}

/// Factors that must not vanish, each of one class: one that has several parts, f + g, is taken
/// times its images, of which there must be one, f - g.
fn products(graph: &mut ExpressionGraph, factors: Vec<Vec<Statement>>) -> Option<Vec<Statement>> {
    let mut products: Vec<Statement> = Vec::new();
    for parts in factors {
        let (first, polynomial) = match &parts[..] {
            [one] => (one, one.polynomial.clone()),
            [first, second] => {
                let [f, g] = [&first.polynomial, &second.polynomial];
                let (sum, difference) = (graph.polynomial_add(f, g), graph.polynomial_sub(f, g));
                (first, graph.polynomial_mul(&sum, &difference)?)
            }
            _ => return None,
        };
        products.push(Statement { polynomial, ..first.clone() });
    }
    Some(products)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{PRIMES, Polynomial};
    use crate::presolve::exchange::exchanged;
    use crate::presolve::{Presolve, presolve};

    fn problem(equations: &str) -> Problem {
        let text = format!("fn sample(a: [f64; 9]) -> (x, y, z, w) {{ {equations} }}");
        Problem::parse("sample.rs", &text).unwrap()
    }

    /// One exchange in the place of two changes of sign would be a loss.
    #[test]
    fn changes_of_sign_are_not_given_up() {
        let squares = "x * x + y * y == a[0]; x * x * y * y == a[1]; z == a[2]; w == a[3];";
        let reduced = presolve(&problem(squares), Presolve::Paired);
        assert_eq!((reduced.pairs.len(), reduced.symmetry.order()), (0, 4));
        assert_eq!(exchanged(&problem(squares)), [[0, 1]]);
    }

    #[test]
    fn a_change_of_sign_is_an_exchange_of_unknowns() {
        let pairs = [[0, 2]];
        assert_eq!(images(3, &[2], &pairs), [(2, false), (1, false), (0, false)]);
        assert_eq!(images(3, &[0, 1], &pairs), [(2, true), (1, true), (0, true)]);
        assert_eq!(images(3, &[0, 2], &pairs), [(0, true), (1, false), (2, true)]);
        for flip in [vec![], vec![0], vec![1], vec![2], vec![0, 1, 2], vec![1, 2]] {
            let flips: Vec<bool> = (0..3).map(|at| flip.contains(&at)).collect();
            assert_eq!(flips_of(&images(3, &flip, &pairs), &pairs), flips);
        }
    }

    /// At x = s + d and y = s - d, the equations as stated are combinations of the parts.
    #[test]
    fn the_parts_span_the_equations() {
        let text = "x * x * y + y * z + x * w == a[0] * z * w; x * y * y + x * w + y * z == a[0] * z * w;
                    x * z + y * w + a[1] * x * x * y * y == 1; z * w + a[2] * z + a[2] * w == a[3];";
        let problem = problem(text);
        let reduced = presolve(&problem, Presolve::Paired);
        assert_eq!((&reduced.pairs[..], reduced.problem.equations.len()), (&[[0, 1], [2, 3]][..], 4));
        let instance = Instance::draw(&reduced.problem, PrimeField::new(PRIMES[0]), 5).unwrap();
        let field = instance.field;
        let mut rows: Vec<Polynomial<u32>> = instance.equations;
        let mut graph = problem.graph.clone();
        for stated in problem.polynomials() {
            let here = substituted(&mut graph, stated, &reduced.pairs).unwrap();
            let values = graph.evaluate(field, &instance.inputs).unwrap();
            rows.push(here.map(|c| Some(values[c.index()]).filter(|&value| value != 0)));
        }
        let mut support: Vec<Monomial> = rows.iter().flat_map(Polynomial::monomials).collect();
        support.sort_unstable();
        support.dedup();
        let mut echelon = Echelon::new(field, support.len());
        let is_new =
            |p: &Polynomial<u32>| echelon.insert_sparse(&row(&support, p.terms().iter().copied()).unwrap()).is_some();
        assert_eq!(rows.iter().map(is_new).collect::<Vec<_>>(), [true, true, true, true, false, false, false, false]);
    }

    #[test]
    fn powers_of_sums_and_differences() {
        let m = |exponents: &[i8]| Monomial::from_exponents(exponents);
        // (s + d)^2 (s - d) = s^3 + s^2 d - s d^2 - d^3
        let expected = [(m(&[3]), 1), (m(&[2, 1]), 1), (m(&[1, 2]), -1), (m(&[0, 3]), -1)];
        assert_eq!(expanded(m(&[2, 1]), &[[0, 1]]).unwrap(), expected);
        assert_eq!(expanded(m(&[1, 1, 1]), &[[0, 1]]).unwrap(), [(m(&[2, 0, 1]), 1), (m(&[0, 2, 1]), -1)]);
        assert_eq!(expanded(m(&[-1, 1]), &[[0, 1]]), None);
    }
}
