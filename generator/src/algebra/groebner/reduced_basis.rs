//! The reduced Gröbner basis in any order, by F4 or from the grevlex basis.

use super::f4;
use super::{GroebnerBasis, GroebnerError, Limits, MonomialOrder, QuotientRing, change_order};
use crate::algebra::{Monomial, Polynomial, PrimeField};

/// The reduced Gröbner basis of the ideal that the polynomials generate.
///
/// In an order that is not graded by positive weights, F4 meets huge intermediate degrees. The
/// grevlex basis is computed first then; if the solutions are finitely many, the order is changed
/// by linear algebra.
///
/// # Errors
/// [`GroebnerError::LimitReached`], or [`GroebnerError::ExponentOutOfRange`] if an exponent is
/// negative or grows beyond 127.
pub fn groebner_basis(
    field: PrimeField,
    polynomials: &[Polynomial<u32>],
    order: &MonomialOrder,
    limits: &Limits,
) -> Result<GroebnerBasis, GroebnerError> {
    if order.grade(&Monomial::ONE).is_some() {
        let elements = f4::reduced_basis(field, polynomials, order, limits)?;
        return Ok(GroebnerBasis::from_elements(field, order.clone(), elements));
    }
    let grevlex = groebner_basis(field, polynomials, &MonomialOrder::GrevLex, limits)?;
    let unknowns = grevlex.count_unknowns(0);
    if let Some(1..) = grevlex.dimension(unknowns) {
        let elements = f4::reduced_basis(field, &grevlex.polynomials(), order, limits)?;
        return Ok(GroebnerBasis::from_elements(field, order.clone(), elements));
    }
    change_order(&QuotientRing::new(&grevlex, unknowns, limits)?, unknowns, order, limits)
}
