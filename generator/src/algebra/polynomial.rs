//! Sparse polynomials: terms sorted by monomial, largest first, no zero coefficient.

use super::Monomial;

/// A sparse polynomial with coefficients `C`.
///
/// Terms are sorted by decreasing [`Monomial`], in graded reverse lexicographic order, and no
/// monomial occurs twice. Code that makes a polynomial drops zero coefficients.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Polynomial<C> {
    terms: Vec<(Monomial, C)>,
}

impl<C> Polynomial<C> {
    /// The polynomial 0.
    pub const ZERO: Self = Self { terms: Vec::new() };

    /// The polynomial with these terms, in any order. Monomials must be distinct and coefficients
    /// not zero.
    pub fn from_terms(mut terms: Vec<(Monomial, C)>) -> Self {
        terms.sort_by_key(|&(monomial, _)| std::cmp::Reverse(monomial));
        debug_assert!(terms.windows(2).all(|pair| pair[0].0 != pair[1].0));
        Self { terms }
    }

    /// The terms, largest monomial first.
    pub fn terms(&self) -> &[(Monomial, C)] {
        &self.terms
    }

    /// The monomials, largest first.
    pub fn monomials(&self) -> impl ExactSizeIterator<Item = Monomial> + '_ {
        self.terms.iter().map(|&(m, _)| m)
    }

    /// Whether there are no terms.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// The largest total degree of a term; 0 for the zero polynomial.
    pub fn degree(&self) -> i32 {
        self.monomials().map(|m| m.degree()).max().unwrap_or(0)
    }

    /// The coefficient of a monomial.
    pub fn coefficient(&self, monomial: &Monomial) -> Option<&C> {
        let at = self.terms.binary_search_by(|(m, _)| monomial.cmp(m)).ok()?;
        Some(&self.terms[at].1)
    }

    /// The polynomial with every coefficient mapped; terms mapped to `None` are dropped.
    pub fn map<D>(&self, mut f: impl FnMut(&C) -> Option<D>) -> Polynomial<D> {
        Polynomial { terms: self.terms.iter().filter_map(|(m, c)| Some((*m, f(c)?))).collect() }
    }
}
