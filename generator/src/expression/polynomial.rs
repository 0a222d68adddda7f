//! Polynomials with coefficients in the graph.

use super::graph::{ExpressionGraph, ExpressionId};
use super::product_sum::{Product, ProductSum};
use super::rational::Rational;
use crate::algebra::{Monomial, MonomialMap, MonomialSet, Polynomial};

/// A polynomial whose coefficients are nodes of a graph.
pub type SymbolicPolynomial = Polynomial<ExpressionId>;

/// A product of two polynomials, and whether it is subtracted.
pub type SignedProduct<'p> = (bool, &'p SymbolicPolynomial, &'p SymbolicPolynomial);

/// Polynomial arithmetic with coefficients in the graph.
impl ExpressionGraph {
    /// c m as a polynomial; zero if c is zero for all data.
    pub fn term(&self, coefficient: ExpressionId, monomial: Monomial) -> SymbolicPolynomial {
        if self.is_zero(coefficient) {
            return Polynomial::ZERO;
        }
        Polynomial::from_terms(vec![(monomial, coefficient)])
    }

    /// p + q
    pub fn polynomial_add(&mut self, p: &SymbolicPolynomial, q: &SymbolicPolynomial) -> SymbolicPolynomial {
        self.sum_terms(p.terms().iter().chain(q.terms()).copied().collect())
    }

    /// p - q
    pub fn polynomial_sub(&mut self, p: &SymbolicPolynomial, q: &SymbolicPolynomial) -> SymbolicPolynomial {
        let negative = self.polynomial_neg(q);
        self.polynomial_add(p, &negative)
    }

    /// -p
    pub fn polynomial_neg(&mut self, p: &SymbolicPolynomial) -> SymbolicPolynomial {
        p.map(|&c| Some(self.neg(c)))
    }

    /// c p
    pub fn polynomial_scale(&mut self, p: &SymbolicPolynomial, c: ExpressionId) -> SymbolicPolynomial {
        if self.is_zero(c) {
            return Polynomial::ZERO;
        }
        p.map(|&a| Some(self.mul(a, c)).filter(|&product| !self.is_zero(product)))
    }

    /// p q, or `None` if an exponent overflows.
    pub fn polynomial_mul(&mut self, p: &SymbolicPolynomial, q: &SymbolicPolynomial) -> Option<SymbolicPolynomial> {
        let mut terms = Vec::with_capacity(p.terms().len() * q.terms().len());
        for &(m, a) in p.terms() {
            for &(n, b) in q.terms() {
                terms.push((m.checked_mul(&n)?, self.mul(a, b)));
            }
        }
        Some(self.sum_terms(terms))
    }

    /// p q ± p' q' ± .. as one [`ProductSum`], for factors of many terms. `None` if an exponent
    /// overflows.
    pub fn polynomial_product_sum(&mut self, products: &[SignedProduct<'_>]) -> Option<SymbolicPolynomial> {
        let mut monomials_of = Vec::with_capacity(products.len());
        for (_, p, q) in products {
            let pairs = p.terms().iter().flat_map(|(m, _)| q.terms().iter().map(move |(n, _)| m.checked_mul(n)));
            monomials_of.push(pairs.collect::<Option<Vec<Monomial>>>()?);
        }
        let different: MonomialSet = monomials_of.iter().flatten().copied().collect();
        let mut monomials: Vec<Monomial> = different.into_iter().collect();
        monomials.sort_by_cached_key(|monomial| std::cmp::Reverse(monomial.rank()));
        let place_of: MonomialMap<u32> = (0..).zip(&monomials).map(|(place, &monomial)| (monomial, place)).collect();
        let coefficients = |p: &SymbolicPolynomial| p.terms().iter().map(|&(_, c)| c).collect();
        let product = |(&(negative, p, q), pairs): (&SignedProduct<'_>, &Vec<Monomial>)| {
            let places = pairs.iter().map(|monomial| place_of[monomial]).collect();
            Product { negative, left: coefficients(p), right: coefficients(q), places }
        };
        let products = products.iter().zip(&monomials_of).map(product).collect();
        let sum = ProductSum { products, length: monomials.len() };
        let sums = self.push_sum(sum);
        let terms = monomials.into_iter().zip(sums).filter(|&(_, c)| !self.is_zero(c));
        Some(Polynomial::from_terms(terms.collect()))
    }

    /// dp / dx for the unknown with index `unknown`.
    pub fn polynomial_derivative(&mut self, p: &SymbolicPolynomial, unknown: usize) -> SymbolicPolynomial {
        let x = Monomial::unknown(unknown);
        let mut terms = Vec::new();
        for &(m, c) in p.terms() {
            if m.exponent(unknown) != 0 {
                let factor = self.constant(Rational::integer(i64::from(m.exponent(unknown))));
                terms.push((m.over(&x), self.mul(factor, c)));
            }
        }
        self.sum_terms(terms)
    }

    /// Collects equal monomials and drops coefficients that are zero for all data.
    fn sum_terms(&mut self, mut terms: Vec<(Monomial, ExpressionId)>) -> SymbolicPolynomial {
        // A stable sort: equal monomials stay in order, so that sums are built in the same way
        // every time.
        terms.sort_by_cached_key(|(monomial, _)| std::cmp::Reverse(monomial.rank()));
        let mut sums: Vec<(Monomial, ExpressionId)> = Vec::with_capacity(terms.len());
        for (monomial, coefficient) in terms {
            match sums.last_mut() {
                Some((last, sum)) if *last == monomial => *sum = self.add(*sum, coefficient),
                _ => sums.push((monomial, coefficient)),
            }
        }
        sums.retain(|&(_, c)| !self.is_zero(c));
        Polynomial::from_terms(sums)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{PRIMES, PrimeField, Random};

    const INPUTS: usize = 12;

    fn graph() -> ExpressionGraph {
        let mut random = Random::new(7);
        let point = |random: &mut Random| (0..INPUTS).map(|_| random.below(1 << 30) as u32).collect();
        ExpressionGraph::new(&[point(&mut random), point(&mut random)])
    }

    /// Some coefficients are constants, some are 0.
    fn random_polynomial(graph: &mut ExpressionGraph, random: &mut Random) -> SymbolicPolynomial {
        let [x, y] = [0, 1].map(Monomial::unknown);
        let mut p = Polynomial::ZERO;
        for monomial in [Monomial::ONE, x, y, x.times(&x), x.times(&y)] {
            let coefficient = match random.below(3) {
                0 => graph.constant(Rational::integer(random.below(5) as i64 - 2)),
                _ => graph.input(random.below(INPUTS as u64) as usize),
            };
            let term = graph.term(coefficient, monomial);
            p = graph.polynomial_add(&p, &term);
        }
        p
    }

    fn expanded(graph: &mut ExpressionGraph, products: &[SignedProduct<'_>]) -> SymbolicPolynomial {
        products.iter().fold(Polynomial::ZERO, |sum, &(negative, p, q)| {
            let product = graph.polynomial_mul(p, q).unwrap();
            if negative { graph.polynomial_sub(&sum, &product) } else { graph.polynomial_add(&sum, &product) }
        })
    }

    #[test]
    fn sums_of_products_are_what_they_expand_to() {
        let field = PrimeField::new(PRIMES[0]);
        let mut random = Random::new(1);
        for _ in 0..50 {
            let mut graph = graph();
            let [p, q, r, s] = [0; 4].map(|_| random_polynomial(&mut graph, &mut random));
            let products = [(true, &p, &q), (false, &r, &s), (random.below(2) == 0, &p, &s)];
            let mut other = graph.clone();
            let (sum, expanded) = (graph.polynomial_product_sum(&products).unwrap(), expanded(&mut other, &products));
            let inputs: Vec<u32> = (0..INPUTS).map(|_| random.below(1 << 30) as u32).collect();
            let value = |graph: &ExpressionGraph, p: &SymbolicPolynomial| {
                let values = graph.evaluate(field, &inputs).unwrap();
                p.terms().iter().map(|&(m, c)| (m, graph.as_constant(c), values[c.index()])).collect::<Vec<_>>()
            };
            assert_eq!(value(&graph, &sum), value(&other, &expanded));
            // What is there already is taken.
            assert_eq!(other.polynomial_product_sum(&products).unwrap(), expanded);
        }
    }
}
