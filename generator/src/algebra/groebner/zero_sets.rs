//! Which unknowns vanish together at solutions of a zero-dimensional ideal.

use std::collections::BTreeSet;

use super::{GroebnerError, Limits, QuotientRing};
use crate::algebra::Echelon;

/// The sets of unknowns that are 0 at some solution while all other unknowns are not, increasing.
/// The empty set is left out, as are further sets after `most`.
///
/// The quotient ring is a product of rings, one for each solution. For an unknown x, the powers of
/// x generate the part of it that belongs to the solutions where x is not 0, and annihilate the
/// other part. Both parts are split by the next unknown.
///
/// # Errors
/// [`GroebnerError::Ended`].
pub fn zero_sets(ring: &QuotientRing, most: usize, limits: &Limits) -> Result<BTreeSet<Vec<usize>>, GroebnerError> {
    let dimension = ring.dimension();
    let unit = |at: usize| (0..dimension).map(|column| u32::from(column == at)).collect::<Vec<u32>>();
    let mut parts: Vec<(Vec<usize>, Vec<Vec<u32>>)> = vec![(Vec::new(), (0..dimension).map(unit).collect())];
    for unknown in 0..ring.unknowns() {
        let mut next = Vec::new();
        for (zeros, part) in parts {
            let (vanishing, other) = split(ring, part, unknown, limits)?;
            if !other.is_empty() {
                next.push((zeros.clone(), other));
            }
            if !vanishing.is_empty() && next.len() <= most {
                next.push(([zeros, vec![unknown]].concat(), vanishing));
            }
        }
        parts = next;
    }
    Ok(parts.into_iter().map(|(zeros, _)| zeros).filter(|zeros| !zeros.is_empty()).take(most).collect())
}

/// Vectors that span two ideals of the ring.
type Parts = (Vec<Vec<u32>>, Vec<Vec<u32>>);

/// The parts of an ideal of the ring that belong to the solutions where the unknown is 0, and to
/// the others. An ideal is given by vectors that span it.
fn split(ring: &QuotientRing, part: Vec<Vec<u32>>, unknown: usize, limits: &Limits) -> Result<Parts, GroebnerError> {
    let dimension = ring.dimension();
    let mut images = part.clone();
    let mut rank = part.len();
    loop {
        images.iter_mut().for_each(|image| *image = ring.times_unknown(image, unknown));
        let mut span = Echelon::new(ring.field(), dimension);
        for image in &images {
            limits.go_on()?;
            span.insert_dense(image);
        }
        if span.rank() == part.len() {
            return Ok((Vec::new(), part));
        }
        if span.rank() == rank || span.rank() == 0 {
            break;
        }
        rank = span.rank();
    }
    // Rows [ image under a power of the unknown | what it is the image of ].
    let mut echelon = Echelon::new(ring.field(), 2 * dimension);
    let (mut vanishing, mut other) = (Vec::new(), Vec::new());
    for (image, vector) in images.iter().zip(&part) {
        limits.go_on()?;
        let mut row = [image.as_slice(), vector].concat();
        echelon.reduce_dense(&mut row);
        if row[..dimension].iter().all(|&value| value == 0) {
            vanishing.push(row.split_off(dimension));
        } else {
            other.push(row[..dimension].to_vec());
            echelon.insert_dense(&row);
        }
    }
    Ok((vanishing, other))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{Limits, Monomial, MonomialOrder, PRIMES, Polynomial, PrimeField, groebner_basis};

    /// A term: coefficient and the exponents of x, y and z.
    type Term = (i64, [i8; 3]);

    fn sets(equations: &[&[Term]]) -> Vec<Vec<usize>> {
        let field = PrimeField::new(PRIMES[0]);
        let term = |(value, exponents): &Term| (Monomial::from_exponents(exponents), field.from_integer(*value));
        let polynomials: Vec<Polynomial<u32>> =
            equations.iter().map(|terms| Polynomial::from_terms(terms.iter().map(term).collect())).collect();
        let limits = Limits::default();
        let basis = groebner_basis(field, &polynomials, &MonomialOrder::GrevLex, &limits).unwrap();
        zero_sets(&QuotientRing::new(&basis, 3, &limits).unwrap(), 10, &limits).unwrap().into_iter().collect()
    }

    #[test]
    fn unknowns_that_vanish_together_are_found() {
        let (x, y, z) = ([1, 0, 0], [0, 1, 0], [0, 0, 1]);
        let (one, square) = ([0; 3], |at: [i8; 3]| at.map(|e| 2 * e));
        // x^2 = x, y^2 = 2 y, z = x + y: (0, 0, 0), (0, 2, 2), (1, 0, 1), (1, 2, 3).
        let z_is_sum: &[Term] = &[(1, z), (-1, x), (-1, y)];
        let of_y: &[Term] = &[(1, square(y)), (-2, y)];
        assert_eq!(sets(&[&[(1, square(x)), (-1, x)], of_y, z_is_sum]), [vec![0], vec![0, 1, 2], vec![1]]);
        // x^2 = 0 is a double solution: (0, 0, 0), (0, 2, 2).
        assert_eq!(sets(&[&[(1, square(x))], of_y, z_is_sum]), [vec![0], vec![0, 1, 2]]);
        // x = 1: (1, 0, 1), (1, 2, 3).
        assert_eq!(sets(&[&[(1, x), (-1, one)], of_y, z_is_sum]), [vec![1]]);
        // x = 1, y^2 = 2: none.
        assert!(sets(&[&[(1, x), (-1, one)], &[(1, square(y)), (-2, one)], z_is_sum]).is_empty());
    }
}
