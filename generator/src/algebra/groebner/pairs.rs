//! Critical pairs and the criteria of Gebauer and Möller.
//!
//! Gebauer & Möller, "On an installation of Buchberger's algorithm", JSC 1988, in the form of
//! Becker & Weispfenning, "Gröbner Bases", algorithm GRÖBNERNEW2.

use super::GroebnerError;
use crate::algebra::Monomial;

/// An element of the growing basis, as far as the criteria look at it.
#[derive(Clone, Debug)]
pub(super) struct Lead {
    /// The leading monomial.
    pub(super) monomial: Monomial,
    /// The sugar: the degree that the element would have if the input had been homogenised.
    pub(super) sugar: i32,
    /// The degree of the leading monomial in the grading that `sugar` is measured in.
    pub(super) degree: i32,
    /// Whether another leading monomial divides this one: the element forms no new pairs and
    /// reduces nothing.
    pub(super) redundant: bool,
}

impl Lead {
    /// The sugar of this element's multiple with a leading monomial of the given degree.
    fn pair_degree(&self, lcm_degree: i32) -> i32 {
        self.sugar + lcm_degree - self.degree
    }
}

/// Two elements whose S-polynomial is still to be reduced.
#[derive(Clone, Debug)]
pub(super) struct Pair {
    /// Indices of the elements.
    pub(super) elements: [usize; 2],
    /// The least common multiple of the leading monomials.
    pub(super) lcm: Monomial,
    /// The sugar of the S-polynomial; pairs of least degree are reduced first.
    pub(super) degree: i32,
}

/// The pairs that are still to be reduced.
#[derive(Debug, Default)]
pub(super) struct PairQueue {
    pairs: Vec<Pair>,
}

/// A pair of the element just added with an older one.
struct Candidate {
    older: usize,
    lcm: Monomial,
    coprime: bool,
    kept: bool,
}

impl PairQueue {
    /// Removes and returns all pairs of the least degree; the list is empty if no pair is left.
    pub(super) fn take_least_degree(&mut self) -> Vec<Pair> {
        let Some(least) = self.pairs.iter().map(|pair| pair.degree).min() else {
            return Vec::new();
        };
        let (taken, left) = std::mem::take(&mut self.pairs).into_iter().partition(|pair| pair.degree == least);
        self.pairs = left;
        taken
    }

    /// Forms the pairs of the newest of `leads` with the others, and drops new and old pairs that a
    /// criterion shows to be unnecessary. Marks the leads that have become redundant. `degree` is
    /// the grading of monomials.
    pub(super) fn update(
        &mut self,
        leads: &mut [Lead],
        degree: impl Fn(&Monomial) -> i32,
        max_pairs: usize,
    ) -> Result<(), GroebnerError> {
        let Some((new, older)) = leads.split_last_mut() else {
            return Ok(());
        };
        // The chain criterion on an old pair (i, j): the new leading monomial divides its lcm, and
        // both pairs with the new element have a smaller lcm. They make (i, j) superfluous.
        self.pairs.retain(|pair| {
            !new.monomial.divides(&pair.lcm)
                || pair.elements.iter().any(|&i| older[i].monomial.lcm(&new.monomial) == pair.lcm)
        });
        let newest = older.len();
        for candidate in necessary(&new.monomial, older) {
            let partner = &older[candidate.older];
            let lcm_degree = degree(&candidate.lcm);
            self.pairs.push(Pair {
                elements: [candidate.older, newest],
                lcm: candidate.lcm,
                degree: partner.pair_degree(lcm_degree).max(new.pair_degree(lcm_degree)),
            });
        }
        for lead in older.iter_mut() {
            new.redundant |= !lead.redundant && lead.monomial.divides(&new.monomial);
            lead.redundant |= !new.redundant && new.monomial.divides(&lead.monomial);
        }
        if self.pairs.len() > max_pairs {
            return Err(GroebnerError::LimitReached { what: "critical pairs", limit: max_pairs });
        }
        Ok(())
    }
}

/// The pairs of a new element that neither the chain criterion among themselves nor the product
/// criterion dismisses.
fn necessary(new: &Monomial, older: &[Lead]) -> impl Iterator<Item = Candidate> {
    let mut candidates: Vec<Candidate> = (0..older.len())
        .filter(|&i| !older[i].redundant)
        .map(|i| {
            let lcm = new.lcm(&older[i].monomial);
            Candidate { older: i, lcm, coprime: lcm == new.times(&older[i].monomial), kept: true }
        })
        .collect();
    for i in 0..candidates.len() {
        let Candidate { lcm, coprime, .. } = candidates[i];
        // A pair with coprime leading monomials reduces to 0 (the product criterion). It is dropped
        // at the end only, because it dismisses others whose lcm its own divides. Of pairs with
        // equal lcm the last stays.
        let dismissed =
            !coprime && candidates.iter().enumerate().any(|(j, other)| j != i && other.kept && other.lcm.divides(&lcm));
        candidates[i].kept = !dismissed;
    }
    candidates.into_iter().filter(|candidate| candidate.kept && !candidate.coprime)
}
