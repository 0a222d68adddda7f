//! A Gröbner basis with its trace.

use std::collections::BTreeSet;

use super::f4;
use super::trace::{GeneratorMultiple, Trace};
use super::{GroebnerBasis, GroebnerError, Limits, MonomialOrder};
use crate::algebra::{Monomial, MonomialSet, Polynomial, PrimeField};

/// A grevlex Gröbner basis with the multiples of the generators that give each of its elements.
#[derive(Clone, Debug)]
pub struct TracedBasis {
    basis: GroebnerBasis,
    trace: Trace,
}

impl TracedBasis {
    /// The basis of the ideal that the polynomials generate, with its trace.
    ///
    /// # Errors
    /// As [`super::groebner_basis`].
    pub fn new(field: PrimeField, generators: &[Polynomial<u32>], limits: &Limits) -> Result<Self, GroebnerError> {
        let (elements, trace) = f4::traced_basis(field, generators, limits)?;
        let basis = GroebnerBasis::from_elements(field, MonomialOrder::GrevLex, elements);
        Ok(Self { basis, trace })
    }

    /// The basis.
    pub fn basis(&self) -> &GroebnerBasis {
        &self.basis
    }

    /// Multiples of the generators in whose span every one of the monomials minus its normal form
    /// is.
    ///
    /// Reducible monomials that the reduction of others leaves are reduced in turn.
    ///
    /// # Errors
    /// [`GroebnerError::ExponentOutOfRange`] if a monomial has a negative exponent, or an exponent
    /// grows beyond 127; [`GroebnerError::LimitReached`] if more than [`Limits::max_multiples`] of
    /// elements of the trace take part; [`GroebnerError::Ended`].
    pub fn multiples_for(
        &self,
        monomials: impl IntoIterator<Item = Monomial>,
        limits: &Limits,
    ) -> Result<BTreeSet<GeneratorMultiple>, GroebnerError> {
        let mut waiting: Vec<Monomial> = monomials.into_iter().collect();
        let mut seen: MonomialSet = waiting.iter().copied().collect();
        let mut wanted = Vec::new();
        // Elements of the basis are the last ones of the trace.
        let first = self.trace.len() - self.basis.elements().len();
        while let Some(monomial) = waiting.pop() {
            limits.go_on()?;
            if !monomial.is_polynomial() {
                return Err(GroebnerError::ExponentOutOfRange);
            }
            let mut elements = self.basis.elements().iter().enumerate();
            let divisor = elements.find(|(_, element)| element.leading_monomial().divides(&monomial));
            let Some((at, element)) = divisor else { continue };
            let multiplier = monomial.over(&element.leading_monomial());
            wanted.push((first + at, multiplier));
            for (term, _) in element.terms().iter().skip(1) {
                let next = term.checked_mul(&multiplier).ok_or(GroebnerError::ExponentOutOfRange)?;
                if seen.insert(next) {
                    waiting.push(next);
                }
            }
        }
        self.trace.expanded(wanted, limits)
    }
}

#[cfg(test)]
mod tests {
    use std::collections::HashMap;

    use super::*;
    use crate::algebra::{Echelon, PRIMES, Random};
    use crate::problem::draw::Draw;

    /// Whether every row of `wanted` is in the span of the others.
    fn spans(field: PrimeField, rows: &[Polynomial<u32>], wanted: &[Polynomial<u32>]) -> bool {
        let monomials: BTreeSet<Monomial> = rows.iter().chain(wanted).flat_map(Polynomial::monomials).collect();
        let column: HashMap<Monomial, u32> = monomials.iter().zip(0..).map(|(&m, at)| (m, at)).collect();
        let entries = |f: &Polynomial<u32>| f.terms().iter().map(|&(m, value)| (column[&m], value)).collect::<Vec<_>>();
        let mut echelon = Echelon::new(field, monomials.len());
        rows.iter().for_each(|row| {
            echelon.insert_sparse(&entries(row));
        });
        wanted.iter().all(|row| echelon.insert_sparse(&entries(row)).is_none())
    }

    #[test]
    fn the_multiples_span_what_they_are_for() {
        let field = PrimeField::new(PRIMES[0]);
        let mut random = Random::new(5);
        for system in 0..12 {
            let unknowns = 2 + system % 2;
            let mut polynomial = || {
                let monomial = |random: &mut Random| {
                    let exponents: Vec<i8> = (0..unknowns).map(|_| random.below(3) as i8).collect();
                    Monomial::from_exponents(&exponents)
                };
                let mut terms: Vec<(Monomial, u32)> =
                    (0..4).map(|_| (monomial(&mut random), field.draw(&mut random))).collect();
                terms.push((Monomial::ONE, field.draw(&mut random)));
                Polynomial::collect(field, terms)
            };
            let generators: Vec<Polynomial<u32>> = (0..unknowns).map(|_| polynomial()).collect();
            let traced = TracedBasis::new(field, &generators, &Limits::default()).unwrap();
            let basis = traced.basis();
            assert_eq!(
                *basis,
                super::super::groebner_basis(field, &generators, &MonomialOrder::GrevLex, &Limits::default()).unwrap()
            );
            let wanted: Vec<Monomial> =
                basis.leading_monomials().iter().map(|m| m.times(&Monomial::unknown(system % unknowns))).collect();
            let multiples = traced.multiples_for(wanted.iter().copied(), &Limits::default()).unwrap();
            let times = |&(at, m): &GeneratorMultiple| generators[at].times_term(field, &m, 1).unwrap();
            let rows: Vec<Polynomial<u32>> = multiples.iter().map(times).collect();
            let relation = |m: &Monomial| {
                let monomial = Polynomial::from_terms(vec![(*m, 1)]);
                let normal_form = basis.normal_form(&monomial).unwrap();
                Polynomial::collect(
                    field,
                    monomial.terms().iter().copied().chain(normal_form.terms().iter().map(|&(m, c)| (m, field.neg(c)))),
                )
            };
            let relations: Vec<Polynomial<u32>> = wanted.iter().map(relation).collect();
            assert!(spans(field, &rows, &relations), "system {system}");
            let one = Limits { max_multiples: 1, ..Limits::default() };
            assert!(traced.multiples_for(wanted.iter().copied(), &one).is_err() || multiples.len() <= unknowns);
            // A test that cannot fail would be of no use: the generators alone do not span them.
            assert!(basis.elements().len() <= unknowns || !spans(field, &generators, &relations));
        }
    }
}
