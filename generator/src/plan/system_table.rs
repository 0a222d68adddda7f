//! Polynomials in the unknowns as tables over a chain of monomials.

use std::cmp::Ordering;
use std::collections::HashSet;

use super::Term;
use crate::algebra::Monomial;

/// Polynomials over a chain of monomials, each an earlier one times an unknown:
///
/// ```text
///   chain     monomial 0 is 1 (its entry is not read); monomial k is monomial parent times unknown
///   terms     [ polynomial 0 .. | polynomial 1 .. |   ..   | last polynomial .. ]
///   ends                        ^ ends[0]         ^ ends[1]                     ^ last end
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SystemTable {
    /// The (parent, unknown) of each monomial.
    pub chain: Vec<(u16, u16)>,
    /// Where the terms of each polynomial end.
    pub ends: Vec<u32>,
    /// The (coefficient, monomial) of each term.
    pub terms: Vec<(u16, u16)>,
}

/// A matrix of more entries is not stored: coefficients have 16-bit numbers, and others follow.
const MOST_ENTRIES: usize = 1 << 15;

impl SystemTable {
    /// The table of polynomials in this number of unknowns.
    pub fn of(polynomials: &[Vec<Term>], unknowns: usize) -> Self {
        let monomials = closed(polynomials, unknowns);
        let find = |monomial: &[u8]| monomials.binary_search_by(|m| by_degree(m, monomial)).unwrap_or(0) as u16;
        let product = |m: &Vec<u8>| parent(m).map_or((0, 0), |(parent, unknown)| (find(&parent), unknown as u16));
        let ends = polynomials.iter().scan(0, |end, polynomial| {
            *end += polynomial.len() as u32;
            Some(*end)
        });
        Self {
            chain: monomials.iter().map(product).collect(),
            ends: ends.collect(),
            terms: polynomials.iter().flatten().map(|t| (t.coefficient.0, find(&t.exponents))).collect(),
        }
    }

    /// Whether the coefficients are stored as a matrix of polynomials by monomials. An entry of the
    /// matrix costs about a quarter of the time of a term of the table, because the polynomials are
    /// evaluated side by side.
    pub fn is_dense(&self) -> bool {
        let entries = self.ends.len() * self.chain.len();
        4 * self.terms.len() >= entries && entries <= MOST_ENTRIES
    }

    /// The coefficients as a matrix, one row for each monomial, one column for each polynomial,
    /// row by row; `None` where a polynomial lacks a monomial.
    pub fn matrix(&self) -> Vec<Option<u16>> {
        let mut matrix = vec![None; self.ends.len() * self.chain.len()];
        let starts = std::iter::once(&0).chain(&self.ends);
        for (polynomial, (&start, &end)) in starts.zip(&self.ends).enumerate() {
            for &(coefficient, monomial) in &self.terms[start as usize..end as usize] {
                matrix[usize::from(monomial) * self.ends.len() + polynomial] = Some(coefficient);
            }
        }
        matrix
    }

    /// The monomials of the chain.
    pub fn monomials(&self) -> Vec<Monomial> {
        let mut monomials = vec![Monomial::ONE];
        for &(parent, unknown) in self.chain.iter().skip(1) {
            monomials.push(monomials[usize::from(parent)].times(&Monomial::unknown(unknown.into())));
        }
        monomials
    }
}

/// All monomials of the polynomials with the chain of products that leads from 1 to each. They are
/// sorted by degree, then exponents; the first is 1.
fn closed(polynomials: &[Vec<Term>], unknowns: usize) -> Vec<Vec<u8>> {
    let mut known = HashSet::from([vec![0; unknowns]]);
    for term in polynomials.iter().flatten() {
        let mut next = Some(term.exponents.clone());
        while let Some(monomial) = next.filter(|monomial| !known.contains(monomial)) {
            next = parent(&monomial).map(|(parent, _)| parent);
            known.insert(monomial);
        }
    }
    let mut monomials: Vec<Vec<u8>> = known.into_iter().collect();
    monomials.sort_unstable_by(|a, b| by_degree(a, b));
    monomials
}

/// The order of the chain. It compares in place: a key with the exponents would copy them.
fn by_degree(a: &[u8], b: &[u8]) -> Ordering {
    let degree = |monomial: &[u8]| monomial.iter().map(|&e| u32::from(e)).sum::<u32>();
    degree(a).cmp(&degree(b)).then_with(|| a.cmp(b))
}

/// The monomial divided by its last unknown, and that unknown; `None` for 1.
fn parent(monomial: &[u8]) -> Option<(Vec<u8>, usize)> {
    let unknown = monomial.iter().rposition(|&e| e > 0)?;
    let mut parent = monomial.to_vec();
    parent[unknown] -= 1;
    Some((parent, unknown))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::CoefficientId;

    /// Each monomial follows from an earlier one, and the table has the terms that it was made of.
    #[test]
    fn a_table_holds_the_polynomials_it_was_made_of() {
        let term = |coefficient: u16, exponents: [u8; 3]| Term {
            coefficient: CoefficientId(coefficient),
            exponents: exponents.to_vec(),
        };
        let polynomials = [
            vec![term(3, [2, 0, 1]), term(0, [0, 0, 0])],
            vec![],
            vec![term(1, [0, 1, 3]), term(2, [2, 0, 1]), term(3, [1, 0, 0])],
        ];
        let table = SystemTable::of(&polynomials, 3);
        let monomials = table.monomials();
        // 1, x, y, x^2, y z, x^2 z, y z^2, y z^3.
        assert_eq!((monomials.len(), table.chain.len(), monomials[0]), (8, 8, Monomial::ONE));
        assert!(table.chain.iter().enumerate().skip(1).all(|(at, &(parent, _))| usize::from(parent) < at));
        let mut first = 0;
        for (polynomial, &end) in polynomials.iter().zip(&table.ends) {
            let terms = table.terms[std::mem::replace(&mut first, end as usize)..end as usize].iter();
            let found = terms.map(|&(coefficient, at)| {
                let exponents = [0, 1, 2].map(|unknown| monomials[usize::from(at)].exponent(unknown) as u8);
                term(coefficient, exponents)
            });
            assert_eq!(found.collect::<Vec<_>>(), *polynomial);
        }
        assert_eq!((first, table.ends.len()), (table.terms.len(), 3));
    }
}
