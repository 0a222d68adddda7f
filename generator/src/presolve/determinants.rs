//! Eliminates unknowns that occur linearly by determinants.
//!
//! Let m equations be linear in n unknowns x, with coefficients that are polynomials in the others,
//! y:
//!
//! ```text
//!           x_1  ..  x_n   1
//!   f_1  [                     ]   [ x_1 ]
//!    ..  [      A(y)     b(y)  ] * [  .. ]  =  0          m >= n equations
//!   f_m  [                     ]   [ x_n ]
//!                                  [  1  ]
//! ```
//!
//! The matrix has a null vector at a solution, so that all minors of n + 1 rows vanish: equations
//! in y alone. In equations that are not linear in x, the unknowns are put as ratios of minors of
//! the first n rows ([`super::cramer`]). The unknowns x follow from A(y) x + b(y) = 0 by least
//! squares. (Relative pose with a known vertical direction: three equations, linear in the
//! translation, give a quartic in the angle, see Fraundorfer, Tanskanen, Pollefeys, "A minimal case
//! solution to the calibrated relative pose problem for the case of two known orientation angles",
//! ECCV 2010.)
//!
//! Minors vanish, too, where A(y) alone is singular. Such points belong to no solution. A factor
//! that must not vanish at one is divided out: where x is a translation and y a rotation by
//! Cayley's parameters, that is the denominator of the rotation.

use super::cramer::ByDeterminants;
use super::minors::minors;
use super::reduced::{LinearBlock, MAX_TERMS, ReducedProblem};
use crate::algebra::Monomial;
use crate::expression::{ExpressionGraph, SymbolicPolynomial};
use crate::problem::{Problem, Statement};

/// Unknowns that are eliminated together, at most: as many as the runtime solves for.
pub(crate) const MOST_LINEAR: usize = 4;

/// Equations that they occur in, at most.
const MOST_ROWS: usize = 8;

/// Eliminates the unknowns that occur linearly together with this one. Nothing changes where fewer
/// equations are linear in such unknowns than there are, where no unknown is left, or where
/// equations would become too long or vanish at the origin.
pub(super) fn eliminate_linear(reduced: &mut ReducedProblem, unknown: usize) {
    let unknowns = [Others::AreLinear, Others::AreAny].map(|others| linear_with(reduced, unknown, others));
    let Some(unknowns) = unknowns.into_iter().find(|unknowns| !unknowns.is_empty()) else { return };
    if unknowns.len() == reduced.kept.len() {
        return;
    }
    let mut problem = reduced.problem.clone();
    let Some(block) = split(&mut problem, &unknowns) else { return };
    reduced.kept.retain(|kept| !unknowns.contains(kept));
    reduced.problem = problem;
    reduced.linear = Some(block);
}

/// What is asked of equations beside those from which unknowns are eliminated.
#[derive(Clone, Copy)]
enum Others {
    /// All equations are linear in the unknowns, and more than these.
    AreLinear,
    /// As many as there are unknowns are linear in them.
    AreAny,
}

/// The unknowns of a block: this one, and each further one with which there are still linear
/// equations enough. Those after it are tried first: a vector stays together.
fn linear_with(reduced: &ReducedProblem, unknown: usize, others: Others) -> Vec<usize> {
    let is_enough = |unknowns: &[usize]| {
        let degrees: Vec<i32> = reduced.problem.polynomials().map(|p| degree(p, unknowns)).collect();
        let rows = degrees.iter().filter(|&&degree| degree == 1).count();
        let least = match others {
            Others::AreLinear if degrees.iter().any(|&degree| degree > 1) => return false,
            Others::AreLinear => unknowns.len() + 1,
            Others::AreAny => unknowns.len(),
        };
        (least..=MOST_ROWS).contains(&rows)
    };
    let (before, after): (Vec<usize>, Vec<usize>) = reduced.kept.iter().partition(|&&kept| kept < unknown);
    let mut block = Vec::new();
    for candidate in after.into_iter().chain(before) {
        block.push(candidate);
        if block.len() > MOST_LINEAR || !is_enough(&block) {
            block.pop();
        }
        if block.first() != Some(&unknown) {
            return Vec::new();
        }
    }
    block.sort_unstable();
    block
}

/// The degree of a polynomial in these unknowns.
fn degree(p: &SymbolicPolynomial, unknowns: &[usize]) -> i32 {
    p.monomials().map(|m| unknowns.iter().map(|&x| i32::from(m.exponent(x))).sum()).max().unwrap_or(0)
}

/// Replaces the equations that are linear in the unknowns by minors, and the unknowns in others by
/// determinants.
fn split(problem: &mut Problem, unknowns: &[usize]) -> Option<LinearBlock> {
    let (mut linear, mut others, mut without) = (Vec::new(), Vec::new(), Vec::new());
    for equation in std::mem::take(&mut problem.equations) {
        match degree(&equation.polynomial, unknowns) {
            0 => without.push(equation),
            1 => linear.push(equation),
            _ => others.push(equation),
        }
    }
    let rows: Vec<Vec<SymbolicPolynomial>> =
        linear.iter().map(|equation| row(&equation.polynomial, unknowns)).collect();
    if rows.iter().all(|row| row.last().is_none_or(SymbolicPolynomial::is_zero)) {
        return None;
    }
    problem.nonzero.retain(|factor| degree(&factor.polynomial, unknowns) == 0);
    let graph = &mut problem.graph;
    let mut in_others: Vec<(Statement, SymbolicPolynomial)> = Vec::new();
    for (first, minor) in minors(graph, &rows)? {
        in_others.push((linear[first].clone(), minor));
    }
    if !others.is_empty() {
        let mut values = ByDeterminants::new(graph, unknowns, &rows[..unknowns.len()])?;
        for equation in others {
            let polynomial = values.substituted(graph, &equation.polynomial)?;
            in_others.push((equation, polynomial));
        }
    }
    for (statement, polynomial) in in_others {
        let factors = problem.nonzero.iter().map(|factor| &factor.polynomial);
        let polynomial = factors.fold(polynomial, |p, factor| without_factor(&mut problem.graph, p, factor));
        if polynomial.terms().len() > MAX_TERMS {
            return None;
        }
        if !polynomial.is_zero() {
            without.push(Statement { polynomial, ..statement });
        }
    }
    problem.equations = without;
    (!problem.equations.is_empty() && !problem.has_origin()).then(|| LinearBlock { unknowns: unknowns.to_vec(), rows })
}

/// The coefficients of the unknowns, and what holds none of them.
fn row(equation: &SymbolicPolynomial, unknowns: &[usize]) -> Vec<SymbolicPolynomial> {
    let part = |unknown: Option<usize>| {
        let is_part = |m: &Monomial| match unknown {
            Some(x) => m.exponent(x) == 1,
            None => unknowns.iter().all(|&x| m.exponent(x) == 0),
        };
        let x = unknown.map_or(Monomial::ONE, Monomial::unknown);
        let terms = equation.terms().iter().filter(|(m, _)| is_part(m));
        SymbolicPolynomial::from_terms(terms.map(|&(m, c)| (m.over(&x), c)).collect())
    };
    unknowns.iter().copied().map(Some).chain([None]).map(part).collect()
}

/// A polynomial divided as often as it can be by a factor, if the leading coefficient of that is a
/// constant.
fn without_factor(
    graph: &mut ExpressionGraph,
    p: SymbolicPolynomial,
    factor: &SymbolicPolynomial,
) -> SymbolicPolynomial {
    let mut p = p;
    while factor.degree() > 0
        && let Some(quotient) = quotient(graph, &p, factor)
    {
        p = quotient;
    }
    p
}

/// p / factor, or `None` if there is a remainder.
fn quotient(
    graph: &mut ExpressionGraph,
    p: &SymbolicPolynomial,
    factor: &SymbolicPolynomial,
) -> Option<SymbolicPolynomial> {
    let &(lead, coefficient) = factor.terms().first()?;
    graph.as_constant(coefficient)?;
    let (mut rest, mut quotient) = (p.clone(), SymbolicPolynomial::ZERO);
    while let Some(&(m, c)) = rest.terms().first() {
        if !lead.divides(&m) {
            return None;
        }
        let coefficient = graph.div(c, coefficient)?;
        let term = graph.term(coefficient, m.over(&lead));
        let product = graph.polynomial_mul(&term, factor)?;
        rest = graph.polynomial_sub(&rest, &product);
        quotient = graph.polynomial_add(&quotient, &term);
    }
    (!quotient.is_zero()).then_some(quotient)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::PrimeField;
    use crate::expression::FINGERPRINT_FIELDS;
    use crate::presolve::{Presolve, presolve};

    const F: PrimeField = FINGERPRINT_FIELDS[0];

    /// Two views of four rays of rigs with a known vertical direction.
    const RIGS: &str = "fn rigs(a: [[f64; 6]; 4], b: [[f64; 6]; 4]) -> (s, t: [f64; 3]) {
        let r = [[1 - s * s, 0, 2 * s], [0, 1 + s * s, 0], [-2 * s, 0, 1 - s * s]];
        for k in 0..4 {
            let q = r * [a[k][0], a[k][1], a[k][2]];
            let [u, v] = [[b[k][0], b[k][1], b[k][2]], [b[k][3], b[k][4], b[k][5]]];
            dot(u, cross(t, q)) + dot(u, r * [a[k][3], a[k][4], a[k][5]]) + dot(v, q) == 0;
        }
        1 + s * s != 0;
    }";

    fn reduced(text: &str, unknown: u8) -> ReducedProblem {
        let problem = Problem::parse("sample.rs", text).unwrap_or_else(|messages| panic!("{}", messages.render()));
        presolve(&problem, Presolve::Determinants(unknown))
    }

    /// The value at the fingerprint point of the data.
    fn value(graph: &ExpressionGraph, p: &SymbolicPolynomial, point: &[u32]) -> u32 {
        p.terms().iter().fold(0, |sum, &(m, c)| {
            let powers = point.iter().enumerate().map(|(at, &x)| F.pow(x, m.exponent(at) as u32));
            F.add(sum, F.mul(graph.fingerprint(c)[0], powers.fold(1, |product, power| F.mul(product, power))))
        })
    }

    /// Leibniz' formula along the first row.
    fn determinant(matrix: &[Vec<u32>]) -> u32 {
        let Some((first, rest)) = matrix.split_first() else { return 1 };
        first.iter().enumerate().fold(0, |sum, (column, &entry)| {
            let without = |row: &Vec<u32>| [&row[..column], &row[column + 1..]].concat();
            let minor = F.mul(entry, determinant(&rest.iter().map(without).collect::<Vec<_>>()));
            if column % 2 == 0 { F.add(sum, minor) } else { F.sub(sum, minor) }
        })
    }

    #[test]
    fn the_minor_is_the_determinant_without_the_factor() {
        let reduced = reduced(RIGS, 1);
        let block = reduced.linear.as_ref().expect("a block");
        assert_eq!((&reduced.kept[..], &block.unknowns[..]), (&[0][..], &[1, 2, 3][..]));
        let [equation] = &reduced.problem.equations[..] else { panic!("{}", reduced.problem.equations.len()) };
        assert_eq!(equation.polynomial.degree(), 6);
        for s in 2..8 {
            let at = |p: &SymbolicPolynomial| value(&reduced.problem.graph, p, &[s, 0, 0, 0]);
            let rows: Vec<Vec<u32>> = block.rows.iter().map(|row| row.iter().map(at).collect()).collect();
            let product = F.mul(at(&equation.polynomial), F.add(1, F.mul(s, s)));
            assert!([product, F.neg(product)].contains(&determinant(&rows)), "{s}");
        }
    }

    /// With five equations for two unknowns there are ten minors, and the other equation stays.
    #[test]
    fn all_minors_take_the_place_of_the_equations() {
        let text = "fn sample(a: [[f64; 4]; 5], b: [f64; 2]) -> (x, y, u, v) {
            for k in 0..5 {
                (a[k][0] + a[k][1] * x) * u + a[k][2] * y * v == a[k][3];
            }
            x * y == b[0] * x + b[1];
        }";
        let reduced = reduced(text, 2);
        assert_eq!(reduced.kept, [0, 1]);
        let block = reduced.linear.as_ref().expect("a block");
        let at = |p: &SymbolicPolynomial| value(&reduced.problem.graph, p, &[3, 5, 0, 0]);
        let of_rows = (0..5).flat_map(|i| (0..i).flat_map(move |j| (0..j).map(move |k| [k, j, i])));
        let matrix = |rows: [usize; 3]| rows.map(|row| block.rows[row].iter().map(at).collect::<Vec<u32>>());
        // Signs do not matter.
        let up_to_sign = |mut values: Vec<u32>| {
            values.iter_mut().for_each(|value| *value = (*value).min(F.neg(*value)));
            values.sort_unstable();
            values
        };
        let expected: Vec<u32> = of_rows.map(|rows| determinant(&matrix(rows))).collect();
        let minors = reduced.problem.equations[1..].iter().map(|equation| at(&equation.polynomial));
        assert_eq!(up_to_sign(minors.collect()), up_to_sign(expected));
    }

    /// Else emitted solvers would leave the unknowns as they are.
    #[cfg(feature = "search")]
    #[test]
    fn the_runtime_solves_for_as_many_unknowns() {
        assert_eq!(MOST_LINEAR, eliminant::emitted::MOST_LINEAR);
    }

    /// As many equations as unknowns, and one that is not linear in them: x = b / a there.
    #[test]
    fn ratios_of_minors_take_the_place_of_unknowns_elsewhere() {
        let text = "fn sample(a: [[f64; 6]; 2], b: [f64; 4]) -> (x, u, v) {
            for k in 0..2 {
                (a[k][0] + a[k][1] * x) * u + (a[k][2] + x * x) * v == a[k][3] + a[k][4] * x;
            }
            b[0] * u * u * v + b[1] * x * u * v + b[2] * v == b[3];
        }";
        let reduced = reduced(text, 1);
        let block = reduced.linear.as_ref().expect("a block");
        assert_eq!((&reduced.kept[..], &block.unknowns[..]), (&[0][..], &[1, 2][..]));
        let [equation] = &reduced.problem.equations[..] else { panic!("{}", reduced.problem.equations.len()) };
        let original = Problem::parse("sample.rs", text).unwrap_or_else(|messages| panic!("{}", messages.render()));
        for x in 2..8 {
            let at = |p: &SymbolicPolynomial| value(&reduced.problem.graph, p, &[x, 0, 0]);
            let rows: Vec<Vec<u32>> = block.rows.iter().map(|row| row.iter().map(at).collect()).collect();
            let without = |column: usize| {
                let row = |row: &Vec<u32>| [&row[..column], &row[column + 1..]].concat();
                determinant(&rows.iter().map(row).collect::<Vec<_>>())
            };
            let inverse = F.inverse(without(2)).expect("the rows are independent");
            let [u, v] = [without(0), F.neg(without(1))].map(|minor| F.mul(minor, inverse));
            for (equation, is_zero) in original.equations.iter().zip([true, true, false]) {
                let residual = value(&original.graph, &equation.polynomial, &[x, u, v]);
                assert_eq!(residual == 0, is_zero, "{x}");
                if !is_zero {
                    // The equation is of degree 3 in u and v.
                    assert_eq!(at(&reduced.problem.equations[0].polynomial), F.mul(residual, F.pow(without(2), 3)));
                }
            }
        }
        assert_eq!(equation.polynomial.degree(), 9);
    }

    /// An equation without the unknown stays, and the unknown follows from the other.
    #[test]
    fn as_many_equations_as_unknowns_determine_them() {
        let text = "fn sample(a: [f64; 6]) -> (x, u) { a[0] * x * u + a[1] * u == a[2]; x * x == a[3]; }";
        let reduced = reduced(text, 1);
        assert_eq!((&reduced.kept[..], reduced.problem.equations.len()), (&[0][..], 1));
        assert_eq!(reduced.linear.map(|block| (block.unknowns, block.rows.len())), Some((vec![1], 1)));
    }

    #[test]
    fn what_cannot_be_eliminated_stays() {
        let squares = "fn sample(a: [f64; 2]) -> (x, u) { u * u * x == a[0] + x; u * u + x * u == a[1]; }";
        let homogeneous = "fn sample(a: [f64; 4]) -> (x, u) { x * u == a[0] * u; x * x * u == a[1] * u; }";
        let origin = "fn sample(a: [f64; 4]) -> (x, y, u) {
            x * u == a[0] * x + a[1] * y;
            y * u == a[2] * x;
            x * y == a[3] * y;
        }";
        // The square of a determinant of 495 terms has 12,870.
        let names = ["b", "c", "d", "e", "f", "g", "h", "i", "j"];
        let others = names[1..].iter().map(|x| format!("{x} * {x} == 2;")).collect::<String>();
        let sum = names.join(" + ");
        let long = format!(
            "fn long() -> ({}, u) {{ ({sum}).pow(4) * u == b + 1; u * u == c + 2; {others} }}",
            names.join(", ")
        );
        for (text, unknown) in [(squares, 1), (homogeneous, 1), (origin, 2), (&long, 9)] {
            let reduced = reduced(text, unknown);
            assert!(reduced.linear.is_none() && reduced.kept.contains(&usize::from(unknown)), "{text}");
        }
    }
}
