//! Eliminates unknowns that occur linearly by determinants.
//!
//! Let all equations be linear in the unknowns x, with coefficients that are polynomials in the
//! others, y:
//!
//! ```text
//!           x_1  ..  x_n   1
//!   f_1  [                     ]   [ x_1 ]
//!    ..  [      A(y)     b(y)  ] * [  .. ]  =  0          m > n equations
//!   f_m  [                     ]   [ x_n ]
//!                                  [  1  ]
//! ```
//!
//! The matrix has a null vector at a solution, so that all minors of n + 1 rows vanish: equations
//! in y alone. The unknowns x follow from A(y) x + b(y) = 0 by least squares. (Relative pose with
//! a known vertical direction: three equations, linear in the translation, give a quartic in the
//! angle, see Fraundorfer, Tanskanen, Pollefeys, "A minimal case solution to the calibrated
//! relative pose problem for the case of two known orientation angles", ECCV 2010.)
//!
//! Minors vanish, too, where A(y) alone is singular. Such points belong to no solution. A factor
//! that must not vanish at one is divided out: where x is a translation and y a rotation by
//! Cayley's parameters, that is the denominator of the rotation.

use eliminant::emitted::MOST_LINEAR;

use super::reduced::{LinearBlock, MAX_TERMS, ReducedProblem};
use crate::algebra::Monomial;
use crate::expression::{ExpressionGraph, SignedProduct, SymbolicPolynomial};
use crate::problem::{Problem, Statement};

/// Equations that they occur in, at most.
const MOST_ROWS: usize = 8;

/// Minors that take the place of these, at most.
const MOST_MINORS: usize = 20;

/// Products of so many terms are formed in loops.
const LONG_PRODUCT: usize = 100;

/// Eliminates the unknowns that occur linearly together with this one. Nothing changes where there
/// are not more equations than such unknowns, where none is left, or where equations would become
/// too long or vanish at the origin.
pub(super) fn eliminate_linear(reduced: &mut ReducedProblem, unknown: usize) {
    let unknowns = linear_with(reduced, unknown);
    if unknowns.is_empty() || unknowns.len() == reduced.kept.len() {
        return;
    }
    let mut problem = reduced.problem.clone();
    let Some(block) = split(&mut problem, &unknowns) else { return };
    reduced.kept.retain(|kept| !unknowns.contains(kept));
    reduced.problem = problem;
    reduced.linear = Some(block);
}

/// The unknowns of a block: this one, and each further one with which all equations are still
/// linear, and more than the unknowns.
fn linear_with(reduced: &ReducedProblem, unknown: usize) -> Vec<usize> {
    let degree = |m: &Monomial, unknowns: &[usize]| unknowns.iter().map(|&x| i32::from(m.exponent(x))).sum::<i32>();
    let is_linear = |unknowns: &[usize]| {
        let holds = |p: &&SymbolicPolynomial| p.monomials().any(|m| degree(&m, unknowns) > 0);
        let rows = reduced.problem.polynomials().filter(holds).count();
        let mut monomials = reduced.problem.polynomials().flat_map(|p| p.monomials());
        monomials.all(|m| degree(&m, unknowns) <= 1) && (unknowns.len() + 1..=MOST_ROWS).contains(&rows)
    };
    let others = reduced.kept.iter().copied().filter(|&other| other != unknown);
    let mut block = Vec::new();
    for candidate in std::iter::once(unknown).filter(|x| reduced.kept.contains(x)).chain(others) {
        block.push(candidate);
        if block.len() > MOST_LINEAR || !is_linear(&block) {
            block.pop();
            if block.is_empty() {
                break;
            }
        }
    }
    block.sort_unstable();
    block
}

/// Replaces the equations that hold the unknowns by minors.
fn split(problem: &mut Problem, unknowns: &[usize]) -> Option<LinearBlock> {
    let holds = |p: &SymbolicPolynomial| p.monomials().any(|m| unknowns.iter().any(|&x| m.exponent(x) != 0));
    let (with, mut without): (Vec<Statement>, Vec<Statement>) =
        std::mem::take(&mut problem.equations).into_iter().partition(|equation| holds(&equation.polynomial));
    let rows: Vec<Vec<SymbolicPolynomial>> = with.iter().map(|equation| row(&equation.polynomial, unknowns)).collect();
    if rows.iter().all(|row| row.last().is_none_or(SymbolicPolynomial::is_zero)) {
        return None;
    }
    problem.nonzero.retain(|factor| !holds(&factor.polynomial));
    let factors: Vec<SymbolicPolynomial> = problem.nonzero.iter().map(|factor| factor.polynomial.clone()).collect();
    for (first, minor) in minors(&mut problem.graph, &rows)? {
        let minor = factors.iter().fold(minor, |minor, factor| without_factor(&mut problem.graph, minor, factor));
        if minor.terms().len() > MAX_TERMS {
            return None;
        }
        if !minor.is_zero() {
            without.push(Statement { polynomial: minor, ..with[first].clone() });
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

/// All minors of as many rows as there are columns, with the first of their rows. Those of the
/// first k columns, one for each set of k rows, are expanded along their last column.
fn minors(graph: &mut ExpressionGraph, rows: &[Vec<SymbolicPolynomial>]) -> Option<Vec<(usize, SymbolicPolynomial)>> {
    let columns = rows.first()?.len();
    let sets = |size: usize| (0u32..1 << rows.len()).filter(move |set| set.count_ones() as usize == size);
    if sets(columns).count() > MOST_MINORS {
        return None;
    }
    let one = graph.term(ExpressionGraph::ONE, Monomial::ONE);
    let mut minors: Vec<(u32, SymbolicPolynomial)> = vec![(0, one)];
    for column in 0..columns {
        let mut next = Vec::new();
        for set in sets(column + 1) {
            let members = (0..rows.len()).filter(|&row| set >> row & 1 == 1);
            let products: Vec<SignedProduct<'_>> = members
                .filter_map(|row| {
                    let at = minors.binary_search_by_key(&(set & !(1 << row)), |&(set, _)| set).ok()?;
                    let position = (set & ((1 << row) - 1)).count_ones() as usize;
                    Some(((column + position) % 2 == 1, &rows[row][column], &minors[at].1))
                })
                .filter(|(_, entry, minor)| !entry.is_zero() && !minor.is_zero())
                .collect();
            next.push((set, sum(graph, &products)?));
        }
        minors = next;
    }
    Some(minors.into_iter().map(|(set, minor)| (set.trailing_zeros() as usize, minor)).collect())
}

/// The sum of products, as [`ExpressionGraph::polynomial_product_sum`] where factors are long.
fn sum(graph: &mut ExpressionGraph, products: &[SignedProduct<'_>]) -> Option<SymbolicPolynomial> {
    if products.iter().any(|(_, entry, minor)| entry.terms().len() * minor.terms().len() >= LONG_PRODUCT) {
        return graph.polynomial_product_sum(products);
    }
    products.iter().try_fold(SymbolicPolynomial::ZERO, |sum, (is_negative, entry, minor)| {
        let product = graph.polynomial_mul(entry, minor)?;
        let sum =
            if *is_negative { graph.polynomial_sub(&sum, &product) } else { graph.polynomial_add(&sum, &product) };
        (sum.terms().len() <= MAX_TERMS).then_some(sum)
    })
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
