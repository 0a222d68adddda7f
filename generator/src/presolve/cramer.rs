//! Puts the solution of linear equations, as determinants, into equations that are not linear.
//!
//! Let n equations be linear in as many unknowns x, with coefficients that are polynomials in the
//! others, y:
//!
//! ```text
//!       x_1  ..  x_n   1
//!   [                     ]   [ x_1 ]             [ v_1(y) ]
//!   [      A(y)     b(y)  ] * [  .. ]  =  0,  so  [   ..   ]  is a multiple of (x_1, .., x_n, 1)
//!   [                     ]   [ x_n ]             [ v_n(y) ]
//!                             [  1  ]             [ v_0(y) ]
//! ```
//!
//! where v holds the minors of the matrix without one column each, with alternating signs: Cramer's
//! rule, x_i = v_i / v_0. An equation of degree d in x, times the d-th power of v_0, is one in y
//! alone: each monomial `x^e` becomes `v^e v_0^(d - |e|)`. (Fundamental matrix and one radial
//! distortion: two equations, linear in the third column, and its determinant give a polynomial of
//! degree 16 in the distortion. Kukelova, Pajdla, CVPR 2007, get there by a Gröbner basis.)

use std::collections::BTreeMap;

use super::minors::{minors, sum};
use super::reduced::MAX_TERMS;
use crate::algebra::Monomial;
use crate::expression::{ExpressionGraph, SignedProduct, SymbolicPolynomial};

/// Unknowns as ratios of determinants.
pub(super) struct ByDeterminants<'a> {
    unknowns: &'a [usize],
    /// The numerators of the unknowns, then the common denominator.
    minors: Vec<SymbolicPolynomial>,
    /// Products of these by exponents.
    products: BTreeMap<Vec<u8>, SymbolicPolynomial>,
}

impl<'a> ByDeterminants<'a> {
    /// From n rows [A | b] for n unknowns; `None` if a determinant grows too long, or if the
    /// denominator is zero.
    pub(super) fn new(
        graph: &mut ExpressionGraph,
        unknowns: &'a [usize],
        rows: &[Vec<SymbolicPolynomial>],
    ) -> Option<Self> {
        let n = unknowns.len();
        // The minors of n rows of the transposed matrix: all but the last come first.
        let columns: Vec<Vec<SymbolicPolynomial>> =
            (0..=n).map(|column| rows.iter().map(|row| row[column].clone()).collect()).collect();
        let mut minors: Vec<SymbolicPolynomial> =
            minors(graph, &columns)?.into_iter().rev().map(|(_, minor)| minor).collect();
        minors.iter_mut().skip(1).step_by(2).for_each(|minor| *minor = graph.polynomial_neg(minor));
        let is_short = minors.iter().all(|minor| minor.terms().len() <= MAX_TERMS);
        (is_short && !minors.last()?.is_zero()).then(|| Self { unknowns, minors, products: BTreeMap::new() })
    }

    /// An equation in the other unknowns alone; `None` if it grows too long.
    pub(super) fn substituted(
        &mut self,
        graph: &mut ExpressionGraph,
        equation: &SymbolicPolynomial,
    ) -> Option<SymbolicPolynomial> {
        let mut parts: BTreeMap<Vec<u8>, Vec<_>> = BTreeMap::new();
        for &(m, c) in equation.terms() {
            let exponents = self.unknowns.iter().map(|&x| u8::try_from(m.exponent(x)));
            let powers = exponents.collect::<Result<Vec<u8>, _>>().ok()?;
            let of_unknowns = self.unknowns.iter().zip(&powers);
            let monomial = of_unknowns.fold(Monomial::ONE, |product, (&x, &power)| {
                (0..power).fold(product, |product, _| product.times(&Monomial::unknown(x)))
            });
            parts.entry(powers).or_default().push((m.over(&monomial), c));
        }
        let degree_of = |powers: &[u8]| powers.iter().map(|&power| u32::from(power)).sum::<u32>();
        let degree = parts.keys().map(|powers| degree_of(powers)).max()?;
        let mut products = Vec::new();
        for (mut powers, terms) in parts {
            powers.push(u8::try_from(degree - degree_of(&powers)).ok()?);
            products.push((SymbolicPolynomial::from_terms(terms), self.product(graph, &powers)?));
        }
        let signed: Vec<SignedProduct<'_>> = products.iter().map(|(part, product)| (false, part, product)).collect();
        sum(graph, &signed)
    }

    /// The product of powers of the determinants; `None` if it grows too long.
    fn product(&mut self, graph: &mut ExpressionGraph, powers: &[u8]) -> Option<SymbolicPolynomial> {
        if let Some(known) = self.products.get(powers) {
            return Some(known.clone());
        }
        let product = match powers.iter().position(|&power| power > 0) {
            None => graph.term(ExpressionGraph::ONE, Monomial::ONE),
            Some(at) => {
                let mut lower = powers.to_vec();
                lower[at] -= 1;
                let rest = self.product(graph, &lower)?;
                let product = sum(graph, &[(false, &self.minors[at], &rest)])?;
                (product.terms().len() <= MAX_TERMS).then_some(product)?
            }
        };
        self.products.insert(powers.to_vec(), product.clone());
        Some(product)
    }
}
