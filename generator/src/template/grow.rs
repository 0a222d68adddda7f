//! Sets of shifts to try, smallest first.
//!
//! Three ways to grow, which lead to different templates:
//! - by degree: all multiples up to a weighted degree (total degree, or weights fitted to the Newton polytopes);
//! - by neighbours: every accepted multiplier times every unknown;
//! - by the best single shift: add the shift whose support, with every shift that becomes free in it, leaves the smallest
//!   excess of columns over rows.

use std::collections::{BTreeSet, HashSet};

use super::Shift;
use crate::algebra::{MAX_UNKNOWNS, Monomial, Polynomial};

/// A way to grow sets of shifts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Growth {
    /// All shifts up to a weighted degree. Weights belong to the unknowns of the problem; those of eliminated unknowns are ignored.
    Degree(Vec<i32>),
    /// All multiples of the accepted shifts by an unknown.
    Neighbours,
    /// One shift at a time with its closure.
    BestShift,
}

impl std::fmt::Display for Growth {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Degree(weights) => write!(f, "degree with weights {weights:?}"),
            Self::Neighbours => write!(f, "neighbours"),
            Self::BestShift => write!(f, "best shift"),
        }
    }
}

/// What a shift with its closure is judged by, smaller is better: columns minus rows, rows, multiplier, equation.
type Score = (i64, usize, Monomial, usize);

/// Sets of shifts, each a superset of the one before, until `limit` columns would be exceeded.
#[derive(Clone, Debug)]
pub struct Shifts<'a> {
    equations: &'a [Polynomial<u32>],
    /// Indices of the unknowns that occur.
    unknowns: &'a [usize],
    growth: Growth,
    /// Upper bound on the number of columns.
    limit: usize,
    level: i32,
    accepted: BTreeSet<Shift>,
    support: HashSet<Monomial>,
}

impl<'a> Shifts<'a> {
    /// Before the first set.
    pub fn new(equations: &'a [Polynomial<u32>], unknowns: &'a [usize], growth: Growth, limit: usize) -> Self {
        let level = match &growth {
            Growth::Degree(weights) => equations.iter().map(|f| weighted_degree(f, weights)).max().unwrap_or(0) - 1,
            _ => -1,
        };
        let support = equations.iter().flat_map(Polynomial::monomials).collect();
        Self { equations, unknowns, growth, limit, level, accepted: BTreeSet::new(), support }
    }

    fn grow_by_degree(&mut self, weights: &[i32]) {
        for (equation, f) in self.equations.iter().enumerate() {
            let room = self.level - weighted_degree(f, weights);
            for multiplier in monomials_up_to(self.unknowns, weights, room) {
                self.accept(Shift { equation, multiplier });
            }
        }
    }

    fn accept(&mut self, shift: Shift) {
        let f = &self.equations[shift.equation];
        self.support.extend(f.monomials().map(|m| m.times(&shift.multiplier)));
        self.accepted.insert(shift);
    }

    fn neighbours(&self) -> BTreeSet<Shift> {
        let mut found = BTreeSet::new();
        for shift in &self.accepted {
            for &unknown in self.unknowns {
                let multiplier = shift.multiplier.times(&Monomial::unknown(unknown));
                let neighbour = Shift { multiplier, ..*shift };
                if !self.accepted.contains(&neighbour) {
                    found.insert(neighbour);
                }
            }
        }
        found
    }

    /// All shifts whose monomials lie in `support`, by breadth-first growth from the accepted ones.
    fn closure(&self, support: &HashSet<Monomial>, seed: Option<Shift>) -> BTreeSet<Shift> {
        let mut closed = self.accepted.clone();
        closed.extend(seed);
        let mut queue: Vec<Shift> = closed.iter().copied().collect();
        while let Some(shift) = queue.pop() {
            for &unknown in self.unknowns {
                let x = Monomial::unknown(unknown);
                for multiplier in [shift.multiplier.times(&x), shift.multiplier.over(&x)] {
                    let next = Shift { multiplier, ..shift };
                    let fits = || {
                        let f = &self.equations[next.equation];
                        multiplier.is_polynomial() && f.monomials().all(|m| support.contains(&m.times(&multiplier)))
                    };
                    if !closed.contains(&next) && fits() {
                        closed.insert(next);
                        queue.push(next);
                    }
                }
            }
        }
        closed
    }

    fn grow_by_best_shift(&mut self) {
        let mut best: Option<(Score, BTreeSet<Shift>)> = None;
        for candidate in self.neighbours() {
            let mut support = self.support.clone();
            let f = &self.equations[candidate.equation];
            support.extend(f.monomials().map(|m| m.times(&candidate.multiplier)));
            let closed = self.closure(&support, Some(candidate));
            let excess = support.len() as i64 - closed.len() as i64;
            let score = (excess, closed.len(), candidate.multiplier, candidate.equation);
            if best.as_ref().is_none_or(|(least, _)| score < *least) {
                best = Some((score, closed));
            }
        }
        for shift in best.map(|(_, closed)| closed).unwrap_or_default() {
            self.accept(shift);
        }
    }
}

impl Iterator for Shifts<'_> {
    type Item = Vec<Shift>;

    fn next(&mut self) -> Option<Vec<Shift>> {
        let before = self.accepted.len();
        self.level += 1;
        match self.growth.clone() {
            Growth::Degree(weights) => self.grow_by_degree(&weights),
            _ if self.level == 0 => {
                for equation in 0..self.equations.len() {
                    self.accept(Shift { equation, multiplier: Monomial::ONE });
                }
                for shift in self.closure(&self.support, None) {
                    self.accept(shift);
                }
            }
            Growth::Neighbours => {
                for shift in self.neighbours() {
                    self.accept(shift);
                }
            }
            Growth::BestShift => self.grow_by_best_shift(),
        }
        let grown = self.accepted.len() > before || matches!(self.growth, Growth::Degree(_));
        // Exponents are i8; far below that no template is of use any more.
        let in_range = self.support.iter().all(|m| m.exponents().iter().all(|&e| e < 60)) && self.level < 60;
        (grown && in_range && self.support.len() <= self.limit).then(|| self.accepted.iter().copied().collect())
    }
}

/// The largest weighted degree of a term.
pub fn weighted_degree<C>(f: &Polynomial<C>, weights: &[i32]) -> i32 {
    f.monomials().map(|m| m.weighted_degree(weights)).max().unwrap_or(0)
}

/// All monomials in `unknowns` of weighted degree at most `bound` (weights are positive).
pub fn monomials_up_to(unknowns: &[usize], weights: &[i32], bound: i32) -> Vec<Monomial> {
    fn extend(
        unknowns: &[usize],
        weights: &[i32],
        room: i32,
        exponents: &mut [i8; MAX_UNKNOWNS],
        out: &mut Vec<Monomial>,
    ) {
        let Some((&unknown, rest)) = unknowns.split_first() else {
            out.push(Monomial::from_exponents(exponents));
            return;
        };
        let weight = weights[unknown].max(1);
        for power in 0..=(room / weight).min(100) {
            exponents[unknown] = power as i8;
            extend(rest, weights, room - power * weight, exponents, out);
        }
        exponents[unknown] = 0;
    }
    let mut out = Vec::new();
    if bound >= 0 {
        extend(unknowns, weights, bound, &mut [0; MAX_UNKNOWNS], &mut out);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_monomials_by_weighted_degree() {
        assert_eq!(monomials_up_to(&[0, 1], &[1, 1], 3).len(), 10);
        // 1, x, x^2, x^3, y, x y with y of weight 2.
        assert_eq!(monomials_up_to(&[0, 1], &[1, 2], 3).len(), 6);
        assert!(monomials_up_to(&[0, 1], &[1, 1], -1).is_empty());
    }
}
