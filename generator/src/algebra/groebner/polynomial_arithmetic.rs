//! Sums and products of polynomials over Z_p.

use std::collections::BTreeMap;

use super::GroebnerError;
use crate::algebra::{Monomial, Polynomial, PrimeField};

impl Polynomial<u32> {
    /// The sum of terms in any order: equal monomials are added up and zero coefficients dropped.
    pub fn collect(field: PrimeField, terms: impl IntoIterator<Item = (Monomial, u32)>) -> Self {
        let mut sums = BTreeMap::new();
        for (monomial, value) in terms {
            let sum = sums.entry(monomial).or_insert(0);
            *sum = field.add(*sum, value);
        }
        Self::from_terms(sums.into_iter().filter(|&(_, value)| value != 0).collect())
    }

    /// The sum.
    pub fn plus(&self, field: PrimeField, other: &Self) -> Self {
        Self::collect(field, self.terms().iter().chain(other.terms()).copied())
    }

    /// The multiple by a term.
    ///
    /// # Errors
    /// [`GroebnerError::ExponentOutOfRange`] if an exponent leaves the range of [`Monomial`].
    pub fn times_term(&self, field: PrimeField, monomial: &Monomial, factor: u32) -> Result<Self, GroebnerError> {
        let mut terms = Vec::with_capacity(self.terms().len());
        for (term, value) in self.terms() {
            let product = term.checked_mul(monomial).ok_or(GroebnerError::ExponentOutOfRange)?;
            terms.push((product, field.mul(*value, factor)));
        }
        Ok(Self::collect(field, terms))
    }

    /// The product.
    ///
    /// # Errors
    /// As [`Polynomial::times_term`].
    pub fn times(&self, field: PrimeField, other: &Self) -> Result<Self, GroebnerError> {
        let mut terms = Vec::with_capacity(self.terms().len() * other.terms().len());
        for &(monomial, value) in self.terms() {
            terms.extend_from_slice(other.times_term(field, &monomial, value)?.terms());
        }
        Ok(Self::collect(field, terms))
    }
}
