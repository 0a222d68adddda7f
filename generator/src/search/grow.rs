//! Sets of shifts to try, smallest first.
//!
//! There are five ways to grow, which lead to different templates:
//! - by degree: all multiples up to a weighted degree (total degree, or weights 1 and 2);
//! - by two degrees: the degree in a group of unknowns is bounded, and the degree in the others
//!   grows;
//! - by neighbours: every accepted multiplier times every unknown;
//! - by the best single shift: the shift whose monomials, with all shifts that become free in them,
//!   leave the smallest excess of columns over rows (Martyushev, Bhayani, Pajdla, arXiv
//!   2307.00320), from the start or after some levels of neighbours;
//! - by the best single shift among Laurent monomials.
//!
//! A set solves once its row space expresses some aB \ B in B. Rows must outnumber the excess
//! columns for that, which is why the number of columns per row is what the last two ways watch.

use std::collections::BTreeSet;
use std::sync::atomic::AtomicBool;

use super::best_shift::{Accepted, Neighbours};
use super::monitor::is_set;
use crate::algebra::{MAX_UNKNOWNS, Monomial, MonomialSet, Polynomial};
use crate::template::Shift;

/// A way to grow sets of shifts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Growth {
    /// All shifts up to a weighted degree. There is a weight for every unknown of the problem;
    /// those of eliminated unknowns are ignored.
    Degree(Vec<i32>),
    /// Two degrees: the total degree in a group of unknowns exceeds that of the equations by at
    /// most `extra_degree`, and the total degree in the other unknowns grows.
    Bigraded {
        /// Indices of the unknowns of the group.
        group: Vec<usize>,
        /// By how much the degree in the group may exceed that of the equations.
        extra_degree: i32,
    },
    /// All multiples of the accepted shifts by an unknown.
    Neighbours,
    /// One shift at a time, with all shifts that it frees, after this many levels of neighbours.
    BestShift(i32),
    /// As [`Growth::BestShift`], among Laurent monomials: multipliers are also divided by unknowns.
    /// Every equation is first multiplied by the unknowns that it lacks, which is up to a common
    /// monomial the same as division by those that it has.
    Laurent(i32),
    /// The shifts from which F4 computes a Gröbner basis: `traced_shifts`. Nothing is grown.
    Trace,
}

impl std::fmt::Display for Growth {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Degree(weights) => write!(f, "degree with weights {weights:?}"),
            Self::Bigraded { group, extra_degree } => {
                write!(f, "degree, {extra_degree} more in the unknowns {group:?}")
            }
            Self::Neighbours => write!(f, "neighbours"),
            Self::Trace => write!(f, "trace of the Gröbner basis"),
            Self::BestShift(0) => write!(f, "best shift"),
            Self::BestShift(levels) => write!(f, "best shift after {levels} levels of neighbours"),
            Self::Laurent(0) => write!(f, "best Laurent shift"),
            Self::Laurent(levels) => write!(f, "best Laurent shift after {levels} levels of neighbours"),
        }
    }
}

/// Sets of shifts, each a superset of the one before, until `limit` columns would be exceeded.
#[derive(Clone, Debug)]
pub struct Shifts<'a> {
    accepted: Accepted<'a>,
    /// Indices of the unknowns that occur.
    unknowns: &'a [usize],
    growth: Growth,
    /// Upper bound on the number of columns.
    limit: usize,
    level: i32,
    /// The neighbours of the accepted shifts, once shifts are added one at a time.
    neighbours: Option<Neighbours>,
    interruption: Option<&'a AtomicBool>,
}

impl<'a> Shifts<'a> {
    /// The iterator before its first set.
    pub fn new(equations: &'a [Polynomial<u32>], unknowns: &'a [usize], growth: Growth, limit: usize) -> Self {
        let level = match &growth {
            Growth::Degree(weights) => highest(equations, weights) - 1,
            Growth::Bigraded { group, .. } => highest(equations, &outside(unknowns, group)) - 1,
            Growth::Neighbours | Growth::BestShift(_) | Growth::Laurent(_) | Growth::Trace => -1,
        };
        let is_laurent = matches!(growth, Growth::Laurent(_));
        let lacks = |f: &Polynomial<u32>, unknown: usize| f.monomials().all(|m| m.exponent(unknown) == 0);
        let first = |f: &Polynomial<u32>| {
            let lacking = unknowns.iter().filter(|&&unknown| is_laurent && lacks(f, unknown));
            lacking.fold(Monomial::ONE, |product, &unknown| product.times(&Monomial::unknown(unknown)))
        };
        let shifts = equations.iter().enumerate().map(|(equation, f)| Shift { equation, multiplier: first(f) });
        let support = shifts.flat_map(|shift| shift.monomials(equations)).collect();
        let accepted = Accepted { equations, shifts: BTreeSet::new(), support };
        Self { accepted, unknowns, growth, limit, level, neighbours: None, interruption: None }
    }

    /// The same sets, none of which is begun or completed any more once the flag is set.
    #[must_use]
    pub fn until(self, interruption: Option<&'a AtomicBool>) -> Self {
        Self { interruption, ..self }
    }

    fn grow_by_degree(&mut self, weights: &[i32]) {
        for (equation, f) in self.accepted.equations.iter().enumerate() {
            let room = self.level - weighted_degree(f, weights);
            for multiplier in monomials_up_to(self.unknowns, weights, room) {
                self.accepted.accept(Shift { equation, multiplier });
            }
        }
    }

    fn grow_by_two_degrees(&mut self, group: &[usize], extra_degree: i32) {
        let (inside, outside) = (inside(group), outside(self.unknowns, group));
        let rest: Vec<usize> = self.unknowns.iter().copied().filter(|unknown| !group.contains(unknown)).collect();
        let most = highest(self.accepted.equations, &inside) + extra_degree;
        for (equation, f) in self.accepted.equations.iter().enumerate() {
            let few = monomials_up_to(group, &inside, most - weighted_degree(f, &inside));
            let many = monomials_up_to(&rest, &outside, self.level - weighted_degree(f, &outside));
            for multiplier in few.iter().flat_map(|a| many.iter().map(|b| a.times(b))) {
                self.accepted.accept(Shift { equation, multiplier });
            }
        }
    }

    /// The quotients of the multipliers of neighbours.
    fn steps(&self) -> Vec<Monomial> {
        let unknowns = self.unknowns.iter().map(|&unknown| Monomial::unknown(unknown));
        match self.growth {
            Growth::Laurent(_) => unknowns.flat_map(|unknown| [unknown, Monomial::ONE.over(&unknown)]).collect(),
            _ => unknowns.collect(),
        }
    }

    fn grow_by_neighbours(&mut self) {
        let steps = self.steps();
        let times = |shift: &Shift, step: &Monomial| Shift { multiplier: shift.multiplier.times(step), ..*shift };
        let around = self.accepted.shifts.iter().flat_map(|shift| steps.iter().map(|step| times(shift, step)));
        for shift in around.collect::<BTreeSet<Shift>>() {
            self.accepted.accept(shift);
        }
    }

    fn grow_by_best_shift(&mut self) {
        let steps = self.steps();
        let neighbours = self.neighbours.get_or_insert_with(|| Neighbours::new(&self.accepted, steps));
        neighbours.accept_best(&mut self.accepted, self.interruption);
    }
}

impl Iterator for Shifts<'_> {
    type Item = Vec<Shift>;

    fn next(&mut self) -> Option<Vec<Shift>> {
        let before = self.accepted.shifts.len();
        self.level += 1;
        match self.growth.clone() {
            Growth::Degree(weights) => self.grow_by_degree(&weights),
            Growth::Bigraded { group, extra_degree } => self.grow_by_two_degrees(&group, extra_degree),
            // The equations themselves, with all other shifts that fit into their monomials.
            Growth::Trace => return None,
            _ if self.level == 0 => {
                let within = shifts_within(self.accepted.equations, &self.accepted.support);
                self.accepted.shifts.extend(within);
            }
            Growth::Neighbours => self.grow_by_neighbours(),
            Growth::BestShift(after) | Growth::Laurent(after) if self.level <= after => self.grow_by_neighbours(),
            Growth::BestShift(_) | Growth::Laurent(_) => self.grow_by_best_shift(),
        }
        // A level of a degree may hold no new shift although the next one does.
        let grown =
            self.accepted.shifts.len() > before || matches!(self.growth, Growth::Degree(_) | Growth::Bigraded { .. });
        let Accepted { shifts, support, .. } = &self.accepted;
        // Exponents are i8. No template of use comes near this bound.
        let in_range =
            support.iter().all(|m| m.exponents().iter().all(|&e| (-60..60).contains(&e))) && self.level < 1000;
        (grown && in_range && !is_set(self.interruption) && support.len() <= self.limit)
            .then(|| shifts.iter().copied().collect())
    }
}

/// All shifts whose monomials lie in `support`.
///
/// The first term of such a shift is in the support, so each pair of an equation and a monomial of
/// the support is one shift to look at.
pub fn shifts_within(equations: &[Polynomial<u32>], support: &MonomialSet) -> BTreeSet<Shift> {
    let mut shifts = BTreeSet::new();
    for (equation, f) in equations.iter().enumerate() {
        let Some(first) = f.monomials().next() else { continue };
        let of = |m: &Monomial| Shift { equation, multiplier: m.over(&first) };
        shifts.extend(support.iter().map(of).filter(|shift| shift.monomials(equations).all(|m| support.contains(&m))));
    }
    shifts
}

/// Weight 1 for these unknowns, 0 for all others.
fn inside(unknowns: &[usize]) -> Vec<i32> {
    (0..MAX_UNKNOWNS).map(|unknown| i32::from(unknowns.contains(&unknown))).collect()
}

/// Weight 1 for `unknowns` outside of the group, 0 for all others.
fn outside(unknowns: &[usize], group: &[usize]) -> Vec<i32> {
    (0..MAX_UNKNOWNS).map(|unknown| i32::from(unknowns.contains(&unknown) && !group.contains(&unknown))).collect()
}

/// The largest weighted degree of the equations.
fn highest(equations: &[Polynomial<u32>], weights: &[i32]) -> i32 {
    equations.iter().map(|f| weighted_degree(f, weights)).max().unwrap_or(0)
}

/// The largest groups of unknowns in which, taken together, all equations are linear: no term holds
/// two of them, or one of them squared.
///
/// Every subset of such a group is one, so groups are found by adding one unknown at a time.
pub fn linear_groups(equations: &[Polynomial<u32>], unknowns: &[usize]) -> Vec<Vec<usize>> {
    let degree = |m: &Monomial, group: &[usize]| group.iter().map(|&u| i32::from(m.exponent(u))).sum::<i32>();
    let is_linear = |group: &[usize]| equations.iter().flat_map(Polynomial::monomials).all(|m| degree(&m, group) <= 1);
    let with = |group: &[usize], unknown: usize| [group, &[unknown]].concat();
    let mut groups: Vec<Vec<usize>> = vec![vec![]];
    for &unknown in unknowns {
        let larger: Vec<Vec<usize>> =
            groups.iter().map(|group| with(group, unknown)).filter(|group| is_linear(group)).collect();
        groups.extend(larger);
    }
    let is_largest = |group: &&Vec<usize>| {
        unknowns.iter().all(|unknown| group.contains(unknown) || !is_linear(&with(group, *unknown)))
    };
    groups.iter().filter(|group| !group.is_empty()).filter(is_largest).cloned().collect()
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
    fn bilinear_equations_grow_in_one_group_of_unknowns() {
        // x u + y v + 1 in x, y, u, v.
        let term = |exponents: [i8; 4]| (Monomial::from_exponents(&exponents), 1);
        let equations = [Polynomial::from_terms(vec![term([1, 0, 1, 0]), term([0, 1, 0, 1]), term([0, 0, 0, 0])])];
        let unknowns = [0, 1, 2, 3];
        let groups = linear_groups(&equations, &unknowns);
        assert_eq!(groups, [vec![0, 1], vec![1, 2], vec![0, 3], vec![2, 3]]);
        let growth = Growth::Bigraded { group: groups[0].clone(), extra_degree: 0 };
        let mut sets = Shifts::new(&equations, &unknowns, growth, 100);
        assert_eq!(sets.next().map(|shifts| shifts.len()), Some(1));
        // 1, u, v; then 6 of degree two.
        assert_eq!(sets.next().map(|shifts| shifts.len()), Some(3));
        assert_eq!(sets.next().map(|shifts| shifts.len()), Some(6));
        let growth = Growth::Bigraded { group: groups[0].clone(), extra_degree: 1 };
        assert_eq!(Shifts::new(&equations, &unknowns, growth, 100).nth(1).map(|shifts| shifts.len()), Some(9));
    }

    #[test]
    fn laurent_shifts_grow_in_both_directions() {
        // x + 1, which lacks y, and x y + y^2 + 1.
        let polynomial = |terms: &[[i8; 2]]| {
            Polynomial::from_terms(terms.iter().map(|exponents| (Monomial::from_exponents(exponents), 1)).collect())
        };
        let equations = [polynomial(&[[1, 0], [0, 0]]), polynomial(&[[1, 1], [0, 2], [0, 0]])];
        let shift =
            |equation, multiplier: [i8; 2]| Shift { equation, multiplier: Monomial::from_exponents(&multiplier) };
        let mut sets = Shifts::new(&equations, &[0, 1], Growth::Laurent(1), 100);
        // y times the first has x y and y, which is new; nothing else fits.
        assert_eq!(sets.next(), Some(vec![shift(0, [0, 1]), shift(1, [0, 0])]));
        let next = sets.next().unwrap();
        let around = [[0, 0], [1, 0], [-1, 0], [0, 1], [0, -1]];
        assert_eq!(next.len(), 10);
        for [x, y] in around {
            assert!(next.contains(&shift(0, [x, y + 1])) && next.contains(&shift(1, [x, y])), "{x} {y}");
        }
        assert!(sets.next().unwrap().len() > 10);
    }

    #[test]
    fn counts_monomials_by_weighted_degree() {
        assert_eq!(monomials_up_to(&[0, 1], &[1, 1], 3).len(), 10);
        // 1, x, x^2, x^3, y, x y with y of weight 2.
        assert_eq!(monomials_up_to(&[0, 1], &[1, 2], 3).len(), 6);
        assert!(monomials_up_to(&[0, 1], &[1, 1], -1).is_empty());
    }
}
