//! Which multiples of the generators give each element of a Gröbner basis.
//!
//! F4 finds every element as a combination of multiples of earlier ones. Which of them take part is
//! kept ([`Trace`]), so that each element is known to be a combination of certain multiples of the
//! generators. Their coefficients are not kept: a later elimination finds them, and may find that
//! fewer multiples suffice (Traverso, "Gröbner trace algorithms", ISSAC 1988).

use std::collections::BTreeSet;

use super::{GroebnerError, Limits};
use crate::algebra::{Monomial, MonomialSet};

/// A multiple of a generator: its position and the multiplier.
pub type GeneratorMultiple = (usize, Monomial);

/// How the elements of a basis were found, those that became redundant among them.
#[derive(Clone, Debug, Default)]
pub(super) struct Trace {
    elements: Vec<Combination>,
}

/// What an element is a combination of.
#[derive(Clone, Debug)]
enum Combination {
    /// These generators.
    Generators(Vec<usize>),
    /// Multiples (element, multiplier) of earlier elements.
    Multiples(Vec<(usize, Monomial)>),
}

impl Trace {
    /// Adds an element that is a combination of generators.
    pub(super) fn add_combination_of_generators(&mut self, generators: Vec<usize>) {
        self.elements.push(Combination::Generators(generators));
    }

    /// Adds an element that is a combination of multiples (element, multiplier) of earlier ones.
    pub(super) fn add_combination(&mut self, parts: Vec<(usize, Monomial)>) {
        self.elements.push(Combination::Multiples(parts));
    }

    /// The number of elements.
    pub(super) fn len(&self) -> usize {
        self.elements.len()
    }

    /// The multiples of generators that multiples of elements are combinations of. Each multiple of
    /// an element is looked at once, however many others it is a part of.
    pub(super) fn expanded(
        &self,
        mut waiting: Vec<(usize, Monomial)>,
        limits: &Limits,
    ) -> Result<BTreeSet<GeneratorMultiple>, GroebnerError> {
        let mut seen = vec![MonomialSet::default(); self.elements.len()];
        waiting.retain(|&(element, multiplier)| seen[element].insert(multiplier));
        let mut count = waiting.len();
        let mut multiples = BTreeSet::new();
        while let Some((element, multiplier)) = waiting.pop() {
            limits.go_on()?;
            match &self.elements[element] {
                Combination::Generators(generators) => multiples.extend(generators.iter().map(|&at| (at, multiplier))),
                Combination::Multiples(parts) => {
                    for (part, m) in parts {
                        let product = m.checked_mul(&multiplier).ok_or(GroebnerError::ExponentOutOfRange)?;
                        if seen[*part].insert(product) {
                            waiting.push((*part, product));
                            count += 1;
                        }
                    }
                }
            }
            let limit = limits.max_multiples;
            if count > limit {
                return Err(GroebnerError::LimitReached { what: "multiples of elements", limit });
            }
        }
        Ok(multiples)
    }
}
