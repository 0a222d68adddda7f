//! How many of the solutions of a zero-dimensional ideal are different.

use super::{GroebnerError, Limits, QuotientRing};
use crate::algebra::{Echelon, Univariate};

/// The number of different solutions, in an extension of the field.
///
/// At different solutions the linear form with the given coefficients, one per unknown, takes
/// different values for all but few choices of them. The different roots of its minimal polynomial
/// in the quotient ring are then as many as the solutions.
///
/// # Errors
/// [`GroebnerError::Ended`].
pub fn count_points(ring: &QuotientRing, form: &[u32], limits: &Limits) -> Result<usize, GroebnerError> {
    Ok(minimal_polynomial(ring, form, limits)?.squarefree_part(ring.field()).degree())
}

/// The minimal polynomial of a linear form: its first power that depends linearly on lower ones,
/// less the combination.
fn minimal_polynomial(ring: &QuotientRing, form: &[u32], limits: &Limits) -> Result<Univariate, GroebnerError> {
    let (field, dimension) = (ring.field(), ring.dimension());
    // Rows [ normal form of a combination of powers | the combination ].
    let mut echelon = Echelon::new(field, 2 * dimension + 1);
    let mut power = vec![0; dimension];
    power.iter_mut().take(1).for_each(|value| *value = 1);
    for exponent in 0..=dimension {
        limits.go_on()?;
        let mut row = power.clone();
        row.resize(2 * dimension + 1, 0);
        row[dimension + exponent] = 1;
        echelon.reduce_dense(&mut row);
        if row[..dimension].iter().all(|&value| value == 0) {
            return Ok(Univariate::new(row.split_off(dimension)));
        }
        echelon.insert_dense(&row);
        let mut next = vec![0; dimension];
        for (unknown, &coefficient) in form.iter().enumerate().take(ring.unknowns()) {
            field.add_multiple(&mut next, coefficient, &ring.times_unknown(&power, unknown));
        }
        power = next;
    }
    // Not reached: d + 1 vectors of d entries are dependent.
    Ok(Univariate::constant(1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{Limits, Monomial, MonomialOrder, PRIMES, Polynomial, PrimeField, groebner_basis};

    /// A term: coefficient and the exponents of x and y.
    type Term = (i64, i8, i8);

    /// (with multiplicity, different)
    fn count(equations: &[&[Term]]) -> (usize, usize) {
        let field = PrimeField::new(PRIMES[0]);
        let term = |&(value, x, y): &Term| (Monomial::from_exponents(&[x, y]), field.from_integer(value));
        let polynomials: Vec<Polynomial<u32>> =
            equations.iter().map(|terms| Polynomial::from_terms(terms.iter().map(term).collect())).collect();
        let limits = Limits::default();
        let basis = groebner_basis(field, &polynomials, &MonomialOrder::GrevLex, &limits).unwrap();
        let ring = QuotientRing::new(&basis, 2, &limits).unwrap();
        (ring.dimension(), count_points(&ring, &[12_345, 678_901], &limits).unwrap())
    }

    #[test]
    fn multiple_solutions_count_once() {
        let square_is_5 = [(1, 0, 2), (-5, 0, 0)];
        assert_eq!(count(&[&[(1, 2, 0), (-3, 1, 0), (2, 0, 0)], &square_is_5]), (4, 4));
        assert_eq!(count(&[&[(1, 2, 0)], &square_is_5]), (4, 2));
        // The powers of no linear form span this ring.
        assert_eq!(count(&[&[(1, 2, 0)], &[(1, 1, 1)], &[(1, 0, 2)]]), (3, 1));
        // A triple solution and a simple one.
        assert_eq!(count(&[&[(1, 2, 0), (1, 0, 1), (-3, 0, 0)], &[(8, 1, 0), (1, 0, 2), (-12, 0, 0)]]), (4, 2));
        // None.
        assert_eq!(count(&[&[(1, 1, 0)], &[(1, 1, 0), (1, 0, 0)]]), (0, 0));
    }
}
