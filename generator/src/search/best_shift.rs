//! The shift that adds most rows for its columns (Martyushev, Bhayani, Pajdla, arXiv 2307.00320).
//!
//! A shift brings monomials that no accepted shift holds. Others become free, which hold no monomials but those and accepted ones. Of the neighbours of the
//! accepted shifts the best one leaves the smallest excess of columns over rows, with what it frees. What a neighbour brings and frees is kept from step to step,
//! and found anew only where a monomial that it depends on was accepted.
//!
//! ```text
//!                accepted monomials | brought by c
//! accepted      [ *  *  *  *  *  *  |             ]
//! neighbour c   [ *        *        |  *     *    ]
//! freed by it   [    *     *  *     |  *          ]
//!               [       *        *  |  *     *    ]
//! ```

use std::collections::{BTreeMap, BTreeSet};

use crate::algebra::{Monomial, MonomialMap, MonomialSet, Polynomial};
use crate::template::Shift;

/// Shifts and their monomials.
#[derive(Clone, Debug)]
pub(super) struct Accepted<'a> {
    pub(super) equations: &'a [Polynomial<u32>],
    pub(super) shifts: BTreeSet<Shift>,
    pub(super) support: MonomialSet,
}

impl Accepted<'_> {
    /// Adds a shift with its monomials.
    pub(super) fn accept(&mut self, shift: Shift) {
        self.support.extend(shift.monomials(self.equations));
        self.shifts.insert(shift);
    }

    /// The monomials of a shift that are not there, in the order of its terms; `None` for more than `most`.
    fn brought_by(&self, shift: &Shift, most: usize) -> Option<Vec<Monomial>> {
        let mut brought = Vec::new();
        for monomial in shift.monomials(self.equations) {
            if !self.support.contains(&monomial) {
                if brought.len() == most {
                    return None;
                }
                brought.push(monomial);
            }
        }
        Some(brought)
    }

    /// All shifts with a given monomial.
    fn shifts_with(&self, monomial: Monomial) -> impl Iterator<Item = Shift> + '_ {
        self.equations.iter().enumerate().flat_map(move |(equation, f)| {
            f.monomials().map(move |term| Shift { equation, multiplier: monomial.over(&term) })
        })
    }

    /// The shifts that become free with new monomials: those that bring some of these and nothing else, each once. None of them was accepted before.
    fn freed_by<'s>(&'s self, new: &'s [Monomial]) -> impl Iterator<Item = Shift> + 's {
        new.iter().flat_map(move |&monomial| self.shifts_with(monomial).map(move |shift| (monomial, shift))).filter_map(
            move |(monomial, shift)| {
                let mut is_first = true;
                for m in shift.monomials(self.equations) {
                    // It is met once for each new monomial, and taken for the first.
                    if is_first && m == monomial {
                        is_first = false;
                    } else if !self.support.contains(&m) && (is_first || !new.contains(&m)) {
                        return None;
                    }
                }
                Some(shift)
            },
        )
    }
}

/// A neighbour of the accepted shifts.
#[derive(Clone, Debug)]
struct Neighbour {
    /// The monomials that it brings.
    brought: Vec<Monomial>,
    /// How many shifts it frees, with itself; `None` where that must be found anew.
    freed: Option<usize>,
}

/// The neighbours of accepted shifts, with what each of them brings and frees.
#[derive(Clone, Debug, Default)]
pub(super) struct Neighbours {
    steps: Vec<Monomial>,
    all: BTreeMap<Shift, Neighbour>,
    /// Those that bring a monomial.
    bringing: MonomialMap<Vec<Shift>>,
}

impl Neighbours {
    /// Multipliers differ by one of `steps` from that of an accepted shift.
    pub(super) fn new(accepted: &Accepted<'_>, steps: Vec<Monomial>) -> Self {
        let mut neighbours = Self { steps, ..Self::default() };
        accepted.shifts.iter().for_each(|shift| neighbours.add_around(shift, accepted));
        neighbours
    }

    fn add_around(&mut self, shift: &Shift, accepted: &Accepted<'_>) {
        for step in &self.steps {
            let next = Shift { multiplier: shift.multiplier.times(step), ..*shift };
            if accepted.shifts.contains(&next) || self.all.contains_key(&next) {
                continue;
            }
            let brought = accepted.brought_by(&next, usize::MAX).unwrap_or_default();
            brought.iter().for_each(|monomial| self.bringing.entry(*monomial).or_default().push(next));
            self.all.insert(next, Neighbour { brought, freed: None });
        }
    }

    /// Accepts the best neighbour with all that it frees.
    pub(super) fn accept_best(&mut self, accepted: &mut Accepted<'_>) {
        for neighbour in self.all.values_mut().filter(|neighbour| neighbour.freed.is_none()) {
            // With itself, which is not among them where it brings nothing.
            neighbour.freed = Some(accepted.freed_by(&neighbour.brought).count().max(1));
        }
        let score = |(shift, neighbour): &(&Shift, &Neighbour)| {
            let freed = neighbour.freed.unwrap_or_default();
            (neighbour.brought.len() as i64 - freed as i64, freed, shift.multiplier, shift.equation)
        };
        let Some((&best, neighbour)) = self.all.iter().min_by_key(score) else { return };
        let brought = neighbour.brought.clone();
        let mut shifts: Vec<Shift> = accepted.freed_by(&brought).collect();
        if shifts.is_empty() {
            shifts.push(best);
        }
        shifts.iter().for_each(|shift| accepted.accept(*shift));
        self.update(&shifts, &brought, accepted);
    }

    /// After some shifts were accepted that brought some monomials.
    fn update(&mut self, shifts: &[Shift], brought: &[Monomial], accepted: &Accepted<'_>) {
        self.all.retain(|shift, _| !accepted.shifts.contains(shift));
        for monomial in brought {
            for shift in self.bringing.remove(monomial).unwrap_or_default() {
                if let Some(neighbour) = self.all.get_mut(&shift) {
                    neighbour.brought.retain(|m| m != monomial);
                    neighbour.freed = None;
                }
            }
        }
        let most = self.all.values().map(|neighbour| neighbour.brought.len()).max().unwrap_or(0);
        // What brings less now may be freed by a neighbour that brings that and more.
        for shift in brought.iter().flat_map(|&monomial| accepted.shifts_with(monomial)) {
            let Some(rest) = accepted.brought_by(&shift, most) else { continue };
            let with_first = rest.first().and_then(|first| self.bringing.get(first));
            for neighbour in with_first.into_iter().flatten() {
                if let Some(neighbour) = self.all.get_mut(neighbour)
                    && rest.iter().all(|monomial| neighbour.brought.contains(monomial))
                {
                    neighbour.freed = None;
                }
            }
        }
        shifts.iter().for_each(|shift| self.add_around(shift, accepted));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::Random;

    /// As it is defined, with nothing kept.
    fn accept_best(accepted: &mut Accepted<'_>, steps: &[Monomial]) {
        let around = |shift: &Shift| {
            let shift = *shift;
            steps.iter().map(move |step| Shift { multiplier: shift.multiplier.times(step), ..shift })
        };
        let neighbours: BTreeSet<Shift> =
            accepted.shifts.iter().flat_map(around).filter(|shift| !accepted.shifts.contains(shift)).collect();
        let with_closure = |candidate: Shift| {
            let mut support = accepted.support.clone();
            support.extend(candidate.monomials(accepted.equations));
            let is_free = |shift: &Shift| shift.monomials(accepted.equations).all(|m| support.contains(&m));
            let new = accepted.brought_by(&candidate, usize::MAX).unwrap();
            let mut freed: BTreeSet<Shift> =
                new.iter().flat_map(|&m| accepted.shifts_with(m)).filter(is_free).collect();
            freed.insert(candidate);
            let excess = new.len() as i64 - freed.len() as i64;
            ((excess, freed.len(), candidate.multiplier, candidate.equation), freed)
        };
        let best = neighbours.into_iter().map(with_closure).min_by_key(|(score, _)| *score).unwrap();
        best.1.into_iter().for_each(|shift| accepted.accept(shift));
    }

    #[test]
    fn what_is_kept_is_what_would_be_found_anew() {
        let mut random = Random::new(11);
        let unknowns = [0, 1, 2].map(Monomial::unknown);
        let both_ways: Vec<Monomial> = unknowns.iter().flat_map(|x| [*x, Monomial::ONE.over(x)]).collect();
        for (system, steps) in (0..12).flat_map(|system| [(system, unknowns.to_vec()), (system, both_ways.clone())]) {
            let mut polynomial = || {
                let monomial = |random: &mut Random| Monomial::from_exponents(&[0; 3].map(|_| random.below(3) as i8));
                let monomials: BTreeSet<Monomial> = (0..3 + system % 4).map(|_| monomial(&mut random)).collect();
                Polynomial::from_terms(monomials.into_iter().rev().map(|m| (m, 1)).collect())
            };
            let equations = [polynomial(), polynomial(), polynomial()];
            let mut kept = Accepted { equations: &equations, shifts: BTreeSet::new(), support: MonomialSet::default() };
            // Not closed: some shifts around bring nothing.
            let first = (0..3).map(|equation| Shift { equation, multiplier: Monomial::ONE });
            first.clone().for_each(|shift| kept.accept(shift));
            first.for_each(|shift| kept.accept(Shift { multiplier: unknowns[0], ..shift }));
            let mut anew = kept.clone();
            let mut neighbours = Neighbours::new(&kept, steps.clone());
            for step in 0..40 {
                neighbours.accept_best(&mut kept);
                accept_best(&mut anew, &steps);
                assert_eq!(kept.shifts, anew.shifts, "step {step} of {equations:?}");
                assert_eq!(kept.support, anew.support);
            }
        }
    }
}
