//! Change of order of a zero-dimensional ideal, and elimination, by linear algebra in the quotient
//! ring.

use std::collections::BTreeMap;

use super::{BasisElement, GroebnerBasis, GroebnerError, Limits, MonomialOrder, QuotientRing};
use crate::algebra::{Echelon, Monomial};

/// The reduced Gröbner basis, in another order, of the polynomials of the ideal in the first
/// `unknowns` unknowns only.
///
/// Monomials are visited in increasing order of the new one (Faugère, Gianni, Lazard & Mora,
/// "Efficient computation of zero-dimensional Gröbner bases by change of ordering", JSC 1993). With
/// nf(m) the normal form of a monomial m in the quotient ring:
///
/// ```text
///   a leading monomial divides m        m is skipped
///   nf(m) depends on earlier nf(m_k)    m - sum of c_k m_k is in the ideal: a new element
///   nf(m) is independent of them        m is a standard monomial; its multiples are visited later
/// ```
///
/// # Errors
/// [`GroebnerError::ExponentOutOfRange`] if a leading monomial needs an exponent beyond 127, and
/// [`GroebnerError::Ended`].
pub fn change_order(
    ring: &QuotientRing,
    unknowns: usize,
    order: &MonomialOrder,
    limits: &Limits,
) -> Result<GroebnerBasis, GroebnerError> {
    let dimension = ring.dimension();
    let field = ring.field();
    let unknowns = unknowns.min(ring.unknowns());
    // Rows [ normal form | combination of standard monomials that gives it ]; at most d are
    // independent.
    let mut echelon = Echelon::new(field, 2 * dimension + 1);
    let mut standard: Vec<Monomial> = Vec::new();
    let mut elements: Vec<BasisElement> = Vec::new();
    let mut one = vec![0; dimension];
    one.iter_mut().take(1).for_each(|value| *value = 1);
    let mut waiting = BTreeMap::from([(order.key(&Monomial::ONE), (Monomial::ONE, one))]);
    while let Some((_, (monomial, form))) = waiting.pop_first() {
        limits.go_on()?;
        if elements.iter().any(|element| element.leading_monomial().divides(&monomial)) {
            continue;
        }
        let mut row = form.clone();
        row.resize(2 * dimension + 1, 0);
        row[dimension + standard.len()] = 1;
        echelon.reduce_dense(&mut row);
        if row[..dimension].iter().all(|&value| value == 0) {
            // The reduced row is the relation: 1 at the monomial itself, the others at standard
            // monomials, which are smaller.
            let combination = standard.iter().copied().zip(row[dimension..].iter().copied());
            let mut terms = vec![(monomial, 1)];
            terms.extend(combination.rev().filter(|&(_, value)| value != 0));
            elements.push(BasisElement::new(terms));
            continue;
        }
        echelon.insert_dense(&row);
        standard.push(monomial);
        for unknown in 0..unknowns {
            limits.go_on()?;
            let product = monomial.checked_mul(&Monomial::unknown(unknown)).ok_or(GroebnerError::ExponentOutOfRange)?;
            waiting.entry(order.key(&product)).or_insert_with(|| (product, ring.times_unknown(&form, unknown)));
        }
    }
    Ok(GroebnerBasis::from_elements(field, order.clone(), elements))
}
