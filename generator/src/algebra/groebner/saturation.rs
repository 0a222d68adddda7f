//! Saturation: the solutions at which given polynomials do not vanish.

use super::{
    BasisElement, GroebnerBasis, GroebnerError, Limits, MonomialOrder, QuotientRing, change_order, groebner_basis,
};
use crate::algebra::{MAX_UNKNOWNS, Monomial, Polynomial, PrimeField};

/// The reduced Gröbner basis of I : (g_1 ... g_k)^infinity, where the polynomials generate I and
/// `nonzero` are the g_i. Its solutions are the closure of those at which no g_i vanishes.
///
/// Rabinowitsch's trick: every g_i gets an extra unknown t_i and the equation t_i g_i = 1, which no
/// zero of g_i satisfies. Then the t_i are eliminated: by linear algebra in the quotient ring if
/// finitely many solutions are left, and by an elimination order otherwise.
///
/// # Errors
/// Those of [`groebner_basis`], and [`GroebnerError::TooManyUnknowns`] if the t_i do not fit.
pub fn saturate(
    field: PrimeField,
    (polynomials, nonzero): (&[Polynomial<u32>], &[Polynomial<u32>]),
    unknowns: usize,
    order: &MonomialOrder,
    limits: &Limits,
) -> Result<GroebnerBasis, GroebnerError> {
    if nonzero.is_empty() {
        return groebner_basis(field, polynomials, order, limits);
    }
    let all_unknowns = unknowns + nonzero.len();
    if all_unknowns > MAX_UNKNOWNS {
        return Err(GroebnerError::TooManyUnknowns { needed: all_unknowns });
    }
    let mut extended = polynomials.to_vec();
    for (i, polynomial) in nonzero.iter().enumerate() {
        let product = polynomial.times_term(field, &Monomial::unknown(unknowns + i), 1)?;
        extended.push(product.plus(field, &Polynomial::from_terms(vec![(Monomial::ONE, field.neg(1))])));
    }
    let basis = groebner_basis(field, &extended, &MonomialOrder::GrevLex, limits)?;
    if let Some(1..) = basis.dimension(all_unknowns) {
        return eliminate(&basis, unknowns..all_unknowns, order, limits);
    }
    change_order(&QuotientRing::new(&basis, all_unknowns, limits)?, unknowns, order, limits)
}

/// The basis of the polynomials of an ideal that are free of the given unknowns.
fn eliminate(
    basis: &GroebnerBasis,
    eliminated: std::ops::Range<usize>,
    order: &MonomialOrder,
    limits: &Limits,
) -> Result<GroebnerBasis, GroebnerError> {
    let field = basis.field();
    let eliminating = MonomialOrder::eliminating(eliminated.clone());
    let all = groebner_basis(field, &basis.polynomials(), &eliminating, limits)?;
    let free = |element: &&BasisElement| eliminated.clone().all(|i| element.leading_monomial().exponent(i) == 0);
    let kept: Vec<BasisElement> = all.elements().iter().filter(free).cloned().collect();
    if *order == MonomialOrder::GrevLex {
        // On monomials without the eliminated unknowns the elimination order is grevlex.
        return Ok(GroebnerBasis::from_elements(field, MonomialOrder::GrevLex, kept));
    }
    let polynomials: Vec<Polynomial<u32>> = kept.iter().map(BasisElement::to_polynomial).collect();
    groebner_basis(field, &polynomials, order, limits)
}
