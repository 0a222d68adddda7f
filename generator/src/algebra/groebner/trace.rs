//! Which multiples of the generators give each element of a Gröbner basis.
//!
//! F4 finds every element as a combination of multiples of earlier ones. Which of them take part is
//! kept ([`Trace`]), so that each element is known to be a combination of certain multiples of the
//! generators. Their coefficients are not kept: a later elimination finds them, and may find that
//! fewer multiples suffice (Traverso, "Gröbner trace algorithms", ISSAC 1988).

use std::collections::{BTreeSet, HashMap};

use super::f4;
use super::{GroebnerBasis, GroebnerError, Limits, MonomialOrder};
use crate::algebra::{Monomial, Polynomial, PrimeField};

/// A multiple of a generator: its position and the multiplier.
pub type GeneratorMultiple = (usize, Monomial);

/// A grevlex Gröbner basis with the multiples of the generators that give each of its elements.
#[derive(Clone, Debug)]
pub struct TracedBasis {
    basis: GroebnerBasis,
    /// For each element of the basis; distinct.
    multiples: Vec<Vec<GeneratorMultiple>>,
}

impl TracedBasis {
    /// The basis of the ideal that the polynomials generate, with its trace.
    ///
    /// # Errors
    /// As [`super::groebner_basis`].
    pub fn new(field: PrimeField, generators: &[Polynomial<u32>], limits: &Limits) -> Result<Self, GroebnerError> {
        let (elements, multiples) = f4::traced_basis(field, generators, limits)?;
        let basis = GroebnerBasis::from_elements(field, MonomialOrder::GrevLex, elements);
        Ok(Self { basis, multiples })
    }

    /// The basis.
    pub fn basis(&self) -> &GroebnerBasis {
        &self.basis
    }

    /// Multiples of the generators in whose span every one of the monomials minus its normal form
    /// is. Returns `None` if a monomial has a negative exponent, or an exponent grows beyond 127.
    ///
    /// Reducible monomials that the reduction of others leaves are reduced in turn.
    pub fn multiples_for(&self, monomials: impl IntoIterator<Item = Monomial>) -> Option<BTreeSet<GeneratorMultiple>> {
        let mut waiting: Vec<Monomial> = monomials.into_iter().collect();
        let mut seen: BTreeSet<Monomial> = waiting.iter().copied().collect();
        let mut multiples = BTreeSet::new();
        while let Some(monomial) = waiting.pop() {
            if !monomial.is_polynomial() {
                return None;
            }
            let mut elements = self.basis.elements().iter().zip(&self.multiples);
            let divisor = elements.find(|(element, _)| element.leading_monomial().divides(&monomial));
            let Some((element, of_element)) = divisor else { continue };
            let multiplier = monomial.over(&element.leading_monomial());
            for (generator, m) in of_element {
                multiples.insert((*generator, m.checked_mul(&multiplier)?));
            }
            for (term, _) in element.terms().iter().skip(1) {
                let next = term.checked_mul(&multiplier)?;
                if seen.insert(next) {
                    waiting.push(next);
                }
            }
        }
        Some(multiples)
    }
}

/// The trace of a basis under construction: for each element the multiples of generators whose
/// combination it is.
#[derive(Debug, Default)]
pub(super) struct Trace {
    /// The number of each multiple that occurs.
    numbers: HashMap<GeneratorMultiple, u32>,
    multiples: Vec<GeneratorMultiple>,
    /// Increasing numbers, for each element.
    of_elements: Vec<Vec<u32>>,
}

impl Trace {
    /// Adds an element that is a combination of generators.
    pub(super) fn add_combination_of_generators(&mut self, generators: impl Iterator<Item = usize>) {
        let mut numbers: Vec<u32> = generators.filter_map(|at| self.number((at, Monomial::ONE))).collect();
        numbers.sort_unstable();
        self.of_elements.push(numbers);
    }

    /// Adds an element that is a combination of multiples (element, multiplier) of earlier ones.
    ///
    /// # Errors
    /// [`GroebnerError::LimitReached`] if there are more multiples than can be numbered, or
    /// [`GroebnerError::ExponentOutOfRange`].
    pub(super) fn add_combination(
        &mut self,
        parts: impl Iterator<Item = (usize, Monomial)>,
    ) -> Result<(), GroebnerError> {
        let mut is_used: Vec<bool> = vec![false; self.multiples.len()];
        for (element, multiplier) in parts {
            for at in 0..self.of_elements[element].len() {
                let (generator, m) = self.multiples[self.of_elements[element][at] as usize];
                let product = m.checked_mul(&multiplier).ok_or(GroebnerError::ExponentOutOfRange)?;
                let limit = u32::MAX as usize;
                let too_many = GroebnerError::LimitReached { what: "multiples of generators", limit };
                let number = self.number((generator, product)).ok_or(too_many)? as usize;
                if number >= is_used.len() {
                    is_used.resize(number + 1, false);
                }
                is_used[number] = true;
            }
        }
        self.of_elements.push((0..is_used.len()).filter(|&at| is_used[at]).map(|at| at as u32).collect());
        Ok(())
    }

    fn number(&mut self, multiple: GeneratorMultiple) -> Option<u32> {
        if let Some(&number) = self.numbers.get(&multiple) {
            return Some(number);
        }
        let number = u32::try_from(self.multiples.len()).ok()?;
        self.numbers.insert(multiple, number);
        self.multiples.push(multiple);
        Some(number)
    }

    /// The multiples of the generators that give the elements from the one at `first` on.
    pub(super) fn from(&self, first: usize) -> Vec<Vec<GeneratorMultiple>> {
        let multiples = |numbers: &Vec<u32>| numbers.iter().map(|&at| self.multiples[at as usize]).collect();
        self.of_elements.iter().skip(first).map(multiples).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{Echelon, PRIMES, Random};
    use crate::problem::instance::Draw;

    /// Whether every row of `wanted` is in the span of the others.
    fn spans(field: PrimeField, rows: &[Polynomial<u32>], wanted: &[Polynomial<u32>]) -> bool {
        let monomials: BTreeSet<Monomial> = rows.iter().chain(wanted).flat_map(Polynomial::monomials).collect();
        let column: HashMap<Monomial, u32> = monomials.iter().zip(0..).map(|(&m, at)| (m, at)).collect();
        let entries =
            |f: &Polynomial<u32>| f.terms().iter().map(|&(m, value)| (column[&m], value)).collect::<Vec<_>>();
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
            let unknowns = 2 + system % 3;
            let mut polynomial = || {
                let monomial = |random: &mut Random| {
                    let exponents: Vec<i8> = (0..unknowns).map(|_| random.below(3) as i8).collect();
                    Monomial::from_exponents(&exponents)
                };
                let mut terms: Vec<(Monomial, u32)> =
                    (0..4).map(|_| (monomial(&mut random), field.draw(&mut random))).collect();
                terms.push((Monomial::ONE, field.draw(&mut random)));
                Polynomial::collect(field, terms.into_iter())
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
            let multiples = traced.multiples_for(wanted.iter().copied()).unwrap();
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
            // A test that cannot fail would be of no use: the generators alone do not span them.
            assert!(basis.elements().len() <= unknowns || !spans(field, &generators, &relations));
        }
    }
}
