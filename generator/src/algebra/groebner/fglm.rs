//! Change of order of a zero-dimensional ideal, and elimination, by linear algebra in the quotient ring.

use std::collections::BTreeMap;

use super::{BasisElement, GroebnerBasis, GroebnerError, MonomialOrder, QuotientRing};
use crate::algebra::{Echelon, Monomial};

/// The reduced Gröbner basis, in another order, of the polynomials of the ideal in the first `unknowns` unknowns only.
///
/// Monomials are visited in increasing order; one whose normal form depends linearly on those of smaller ones gives an element, the others are
/// the standard monomials of the new order (Faugère, Gianni, Lazard & Mora, JSC 1993).
///
/// # Errors
/// [`GroebnerError::ExponentOutOfRange`] where a leading monomial needs an exponent beyond 127.
pub fn change_order(
    ring: &QuotientRing,
    unknowns: usize,
    order: &MonomialOrder,
) -> Result<GroebnerBasis, GroebnerError> {
    let dimension = ring.dimension();
    let field = ring.field();
    let unknowns = unknowns.min(ring.unknowns());
    // Rows [ normal form | which standard monomials it was combined from ]; at most d are independent.
    let mut echelon = Echelon::new(field, 2 * dimension + 1);
    let mut standard: Vec<Monomial> = Vec::new();
    let mut elements: Vec<BasisElement> = Vec::new();
    let mut one = vec![0; dimension];
    one.iter_mut().take(1).for_each(|value| *value = 1);
    let mut waiting = BTreeMap::from([(order.key(&Monomial::ONE), (Monomial::ONE, one))]);
    while let Some((_, (monomial, form))) = waiting.pop_first() {
        if elements.iter().any(|element| element.leading_monomial().divides(&monomial)) {
            continue;
        }
        let mut row = form.clone();
        row.resize(2 * dimension + 1, 0);
        row[dimension + standard.len()] = 1;
        echelon.reduce_dense(&mut row);
        if row[..dimension].iter().all(|&value| value == 0) {
            // The relation has coefficient 1 at the monomial itself, and involves earlier standard monomials.
            let combination = standard.iter().copied().zip(row[dimension..].iter().copied());
            let mut terms = vec![(monomial, 1)];
            terms.extend(combination.rev().filter(|&(_, value)| value != 0));
            elements.push(BasisElement::new(terms));
            continue;
        }
        echelon.insert_dense(&row);
        standard.push(monomial);
        for unknown in 0..unknowns {
            let product = monomial.checked_mul(&Monomial::unknown(unknown)).ok_or(GroebnerError::ExponentOutOfRange)?;
            waiting.entry(order.key(&product)).or_insert_with(|| (product, ring.times_unknown(&form, unknown)));
        }
    }
    Ok(GroebnerBasis::from_elements(field, order.clone(), elements))
}
