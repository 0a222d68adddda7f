//! The shift that adds most rows for its columns (Martyushev, Bhayani, Pajdla, arXiv 2307.00320).
//!
//! A neighbour of the accepted shifts *brings* the monomials that no accepted shift has. With them
//! other shifts become *free*: shifts all of whose monomials are brought or accepted. They are rows
//! that cost no column, so all of them are accepted with the neighbour. The best neighbour is the
//! one with the smallest difference of columns brought and rows added.
//!
//! ```text
//!                accepted monomials | brought by c
//! accepted      [ *  *  *  *  *  *  |             ]
//! neighbour c   [ *        *        |  *     *    ]    2 columns - 3 rows = -1
//! freed by c    [    *     *  *     |  *          ]
//!               [       *        *  |  *     *    ]
//! ```
//!
//! To count what all neighbours free takes most of the time, and changes for few of them in a step.
//! What each neighbour brings and frees is therefore kept, and found anew only if a monomial that
//! it depends on was accepted.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::AtomicBool;

use super::monitor::is_set;
use crate::algebra::{Monomial, MonomialMap, MonomialSet, Polynomial};
use crate::template::Shift;

/// The accepted shifts and their monomials.
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

    /// The monomials that a shift brings, in the order of its terms; `None` if there are more than
    /// `most`.
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

    /// All shifts that have a monomial.
    fn shifts_with(&self, monomial: Monomial) -> impl Iterator<Item = Shift> + '_ {
        self.equations.iter().enumerate().flat_map(move |(equation, f)| {
            f.monomials().map(move |term| Shift { equation, multiplier: monomial.over(&term) })
        })
    }

    /// The shifts that become free with new monomials: those that bring some of these and nothing
    /// else, each once. None of them was accepted before, because an accepted shift brings nothing.
    fn freed_by<'s>(&'s self, new: &'s [Monomial]) -> impl Iterator<Item = Shift> + 's {
        new.iter().flat_map(move |&monomial| self.shifts_with(monomial).map(move |shift| (monomial, shift))).filter_map(
            move |(monomial, shift)| {
                let mut is_first = true;
                for m in shift.monomials(self.equations) {
                    // The shift is met once for each new monomial that it has, and counted for its
                    // first one.
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
    /// The monomials that the neighbour brings.
    brought: Vec<Monomial>,
    /// Number of shifts that it frees, itself included; `None` if that must be found anew.
    freed: Option<usize>,
}

/// The neighbours of accepted shifts, with what each of them brings and frees.
#[derive(Clone, Debug, Default)]
pub(super) struct Neighbours {
    steps: Vec<Monomial>,
    all: BTreeMap<Shift, Neighbour>,
    /// The neighbours that bring each monomial.
    bringing: MonomialMap<Vec<Shift>>,
}

impl Neighbours {
    /// The neighbours of the accepted shifts: their multiplier is that of an accepted shift times
    /// one of `steps`.
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

    /// Accepts the best neighbour with all shifts that it frees; none where the flag is set.
    pub(super) fn accept_best(&mut self, accepted: &mut Accepted<'_>, interruption: Option<&AtomicBool>) {
        for neighbour in self.all.values_mut().filter(|neighbour| neighbour.freed.is_none()) {
            if is_set(interruption) {
                return;
            }
            // A neighbour that brings nothing is a row by itself, which `freed_by` does not count.
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

    /// Updates what is kept after some shifts were accepted that brought some monomials.
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
        // A shift that brings less than before may now be freed by a neighbour that brings at least
        // that much. A shift that brings more than any neighbour does cannot.
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

    /// The definition, with nothing kept.
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
            // The set is not closed: some neighbours bring nothing.
            let first = (0..3).map(|equation| Shift { equation, multiplier: Monomial::ONE });
            first.clone().for_each(|shift| kept.accept(shift));
            first.for_each(|shift| kept.accept(Shift { multiplier: unknowns[0], ..shift }));
            let mut anew = kept.clone();
            let mut neighbours = Neighbours::new(&kept, steps.clone());
            for step in 0..40 {
                neighbours.accept_best(&mut kept, None);
                accept_best(&mut anew, &steps);
                assert_eq!(kept.shifts, anew.shifts, "step {step} of {equations:?}");
                assert_eq!(kept.support, anew.support);
            }
        }
    }
}
