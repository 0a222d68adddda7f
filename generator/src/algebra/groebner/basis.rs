//! Reduced Gröbner bases over Z_p as values, and what can be read from them.

use std::collections::BTreeMap;

use super::{GroebnerError, MonomialOrder};
use crate::algebra::{MAX_UNKNOWNS, Monomial, Polynomial, PrimeField};

/// A polynomial of a Gröbner basis: terms by decreasing monomial in the order of the basis, leading
/// coefficient 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BasisElement {
    terms: Vec<(Monomial, u32)>,
}

impl BasisElement {
    pub(super) fn new(terms: Vec<(Monomial, u32)>) -> Self {
        debug_assert!(terms.first().is_some_and(|&(_, value)| value == 1));
        Self { terms }
    }

    pub(super) fn one() -> Self {
        Self::new(vec![(Monomial::ONE, 1)])
    }

    /// The terms, largest first.
    pub fn terms(&self) -> &[(Monomial, u32)] {
        &self.terms
    }

    /// The largest monomial.
    pub fn leading_monomial(&self) -> Monomial {
        self.terms.first().map_or(Monomial::ONE, |&(monomial, _)| monomial)
    }

    /// The same polynomial, its terms in the canonical order.
    pub fn to_polynomial(&self) -> Polynomial<u32> {
        Polynomial::from_terms(self.terms.clone())
    }
}

/// The reduced Gröbner basis of an ideal: leading coefficients 1, and no monomial divisible by
/// another element's leading monomial. It depends on the ideal and the order only.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GroebnerBasis {
    field: PrimeField,
    order: MonomialOrder,
    elements: Vec<BasisElement>,
}

impl GroebnerBasis {
    /// The basis with these elements of a reduced basis, by increasing leading monomial.
    pub(super) fn from_elements(field: PrimeField, order: MonomialOrder, elements: Vec<BasisElement>) -> Self {
        debug_assert!(elements.is_sorted_by_key(|element| order.key(&element.leading_monomial())));
        Self { field, order, elements }
    }

    /// The field of the coefficients.
    pub fn field(&self) -> PrimeField {
        self.field
    }

    /// The monomial order.
    pub fn order(&self) -> &MonomialOrder {
        &self.order
    }

    /// The elements, by increasing leading monomial.
    pub fn elements(&self) -> &[BasisElement] {
        &self.elements
    }

    /// The elements as polynomials with their terms in the canonical order.
    pub fn polynomials(&self) -> Vec<Polynomial<u32>> {
        self.elements.iter().map(BasisElement::to_polynomial).collect()
    }

    /// The leading monomials, increasing.
    pub fn leading_monomials(&self) -> Vec<Monomial> {
        self.elements.iter().map(BasisElement::leading_monomial).collect()
    }

    /// Whether the ideal is the whole ring: there are no solutions.
    pub fn is_unit(&self) -> bool {
        self.elements.iter().any(|element| element.leading_monomial() == Monomial::ONE)
    }

    /// Whether a leading monomial divides the monomial, so that its normal form is not the monomial
    /// itself.
    pub fn is_reducible(&self, monomial: &Monomial) -> bool {
        self.elements.iter().any(|element| element.leading_monomial().divides(monomial))
    }

    /// The dimension of the solution set in the given number of unknowns; `None` if there are no
    /// solutions.
    ///
    /// It is the size of the largest set of unknowns such that no leading monomial is a monomial in
    /// these only (Cox, Little & O'Shea, "Ideals, Varieties, and Algorithms", section 9.3).
    pub fn dimension(&self, unknowns: usize) -> Option<usize> {
        let unknowns = self.count_unknowns(unknowns);
        let support = |element: &BasisElement| {
            let leading = element.leading_monomial();
            (0..unknowns).filter(|&i| leading.exponent(i) != 0).fold(0u32, |mask, i| mask | 1 << i)
        };
        let supports: Vec<u32> = self.elements.iter().map(support).collect();
        let independent = |set: &u32| supports.iter().all(|support| support & !set != 0);
        (0u32..1 << unknowns).filter(independent).map(|set| set.count_ones() as usize).max()
    }

    /// The number of unknowns of the ring: at least those announced and those that occur.
    pub(super) fn count_unknowns(&self, announced: usize) -> usize {
        let monomials = || self.elements.iter().flat_map(BasisElement::terms).map(|(monomial, _)| monomial);
        let occurs = |i: &usize| monomials().any(|monomial| monomial.exponent(*i) != 0);
        let occurring = (0..MAX_UNKNOWNS).rev().find(occurs).map_or(0, |last| last + 1);
        announced.clamp(occurring, MAX_UNKNOWNS)
    }

    /// The monomials that no leading monomial divides, increasing: a basis of the quotient ring as
    /// a vector space. `None` if there are more than `limit`, as for every ideal that is not
    /// zero-dimensional.
    pub fn quotient_basis(&self, unknowns: usize, limit: usize) -> Option<Vec<Monomial>> {
        if self.is_unit() {
            return Some(Vec::new());
        }
        let unknowns = self.count_unknowns(unknowns);
        // Each monomial is reached once, from its quotient by the last unknown in it.
        let mut basis = vec![(Monomial::ONE, 0)];
        let mut next = 0;
        while let Some(&(monomial, last)) = basis.get(next) {
            next += 1;
            for unknown in last..unknowns {
                let product = monomial.checked_mul(&Monomial::unknown(unknown))?;
                if !self.is_reducible(&product) {
                    basis.push((product, unknown));
                }
            }
            if basis.len() > limit {
                return None;
            }
        }
        let mut basis: Vec<Monomial> = basis.into_iter().map(|(monomial, _)| monomial).collect();
        basis.sort_unstable_by_key(|monomial| self.order.key(monomial));
        Some(basis)
    }

    /// The remainder of the division by the basis: the only polynomial without reducible monomials
    /// that is congruent to the given one.
    ///
    /// # Errors
    /// [`GroebnerError::ExponentOutOfRange`] as in [`super::groebner_basis`].
    pub fn normal_form(&self, polynomial: &Polynomial<u32>) -> Result<Polynomial<u32>, GroebnerError> {
        if !polynomial.monomials().all(|monomial| monomial.is_polynomial()) {
            return Err(GroebnerError::ExponentOutOfRange);
        }
        let field = self.field;
        let mut pending: BTreeMap<_, _> = polynomial
            .terms()
            .iter()
            .map(|&(monomial, value)| (self.order.key(&monomial), (monomial, value)))
            .collect();
        let mut remainder = Vec::new();
        // Every step replaces the largest term by smaller ones.
        while let Some((_, (monomial, value))) = pending.pop_last() {
            if value == 0 {
                continue;
            }
            let divisor = self.elements.iter().find(|element| element.leading_monomial().divides(&monomial));
            let Some(divisor) = divisor else {
                remainder.push((monomial, value));
                continue;
            };
            let multiplier = monomial.over(&divisor.leading_monomial());
            for (term, coefficient) in divisor.terms().iter().skip(1) {
                let product = multiplier.checked_mul(term).ok_or(GroebnerError::ExponentOutOfRange)?;
                let (_, target) = pending.entry(self.order.key(&product)).or_insert((product, 0));
                *target = field.sub(*target, field.mul(value, *coefficient));
            }
        }
        Ok(Polynomial::from_terms(remainder))
    }
}
