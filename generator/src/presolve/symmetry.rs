//! Sign changes of unknowns that map solutions to solutions.
//!
//! If all terms of each equation have the same parity in some unknowns, these may change their
//! signs together: x y + z^2 = 1 holds for (-x, -y, z) if it holds for (x, y, z). Monomials fall
//! into classes of equal parity. No multiple of an equation mixes classes, and an action monomial
//! that keeps its sign maps each class to itself. A template then needs one class only, and |B| may
//! be the number of solutions up to sign (Larsson and Åström, "Uncovering symmetries in polynomial
//! systems", ECCV 2016, section 3, for p = 2).
//!
//! Sign changes are vectors over Z_2 with a bit for each unknown, and a sign change multiplies a
//! monomial by (-1)^(sum of flip bit times exponent): the group of those that keep all equations is
//! the kernel of a matrix of parities.
//!
//! ```text
//!           x y z w
//! flips   [ 1 1 0 1 ]   reduced echelon form: a pivot (here x and z) is changed by one flip only,
//!         [ 0 0 1 1 ]   so the signs of the pivots can be chosen freely, and decide all others
//! ```

use crate::algebra::{MAX_UNKNOWNS, Monomial};
use crate::problem::Problem;

/// Unknowns that change their sign, by bits.
type Flip = u16;

/// A group of sign changes: the space over Z_2 that its generators span.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Symmetry {
    /// Generators in reduced echelon form.
    flips: Vec<Flip>,
}

/// How an unknown is read from monomials of one class: from two whose ratio is one of `steps`.
///
/// The step of a pivot x is x^2. A step of any other unknown is the unknown times pivots or their
/// reciprocals, such that no sign change affects it. Without symmetry the step is the unknown
/// itself.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reading {
    /// The unknown.
    pub unknown: usize,
    /// The monomials.
    pub steps: Vec<Monomial>,
}

impl Symmetry {
    /// No sign change.
    pub const NONE: Self = Self { flips: Vec::new() };

    /// The sign changes that map every equation, and every factor that must not vanish, to itself
    /// up to sign.
    pub fn of_problem(problem: &Problem) -> Self {
        let unknowns = problem.unknowns.len();
        let mut symmetry = Self { flips: (0..unknowns).map(|unknown| 1 << unknown).collect() };
        for polynomial in problem.polynomials().chain(problem.nonzero.iter().map(|factor| &factor.polynomial)) {
            symmetry.keep_one_class(polynomial.monomials());
        }
        symmetry.flips = symmetry.echelon(0..unknowns).into_iter().map(|(_, flip)| flip).collect();
        symmetry
    }

    /// The sign changes that keep the sign of the action monomial, and change the signs of all
    /// basis monomials or of none.
    #[must_use]
    pub fn of_template(&self, action: &Monomial, basis: &[Monomial]) -> Self {
        let mut symmetry = self.clone();
        symmetry.keep_one_class([Monomial::ONE, *action].into_iter());
        symmetry.keep_one_class(basis.iter().copied());
        symmetry
    }

    /// The sign changes without those that change no unknown of `kept`: such do not lead to another
    /// solution there.
    #[must_use]
    pub fn on(&self, kept: &[usize]) -> Self {
        Self { flips: self.echelon(kept.iter().copied()).into_iter().map(|(_, flip)| flip).collect() }
    }

    /// Restricts the group to the sign changes that change the signs of all these monomials or of
    /// none.
    ///
    /// A generator with odd product with a difference of parities changes one of two monomials
    /// only. It is removed, and added to the other such generators: the sum of two odd products is
    /// even.
    fn keep_one_class(&mut self, mut monomials: impl Iterator<Item = Monomial>) {
        let Some(first) = monomials.next().map(|m| parity(&m)) else { return };
        for difference in monomials.map(|m| parity(&m) ^ first) {
            let Some(at) = self.flips.iter().position(|&flip| is_odd(flip & difference)) else { continue };
            let odd = self.flips.remove(at);
            self.flips.iter_mut().filter(|flip| is_odd(**flip & difference)).for_each(|flip| *flip ^= odd);
        }
    }

    /// The generators in reduced echelon form, each with its pivot. Unknowns become pivots in the
    /// given order. Sign changes of none of these unknowns are left out.
    fn echelon(&self, order: impl Iterator<Item = usize>) -> Vec<(usize, Flip)> {
        let mut left = self.flips.clone();
        let mut done: Vec<(usize, Flip)> = Vec::new();
        for unknown in order {
            let has = |flip: &Flip| flip >> unknown & 1 == 1;
            let Some(at) = left.iter().position(has) else { continue };
            let flip = left.remove(at);
            let others = done.iter_mut().map(|(_, other)| other).chain(&mut left);
            others.filter(|other| has(other)).for_each(|other| *other ^= flip);
            done.push((unknown, flip));
        }
        done
    }

    /// Whether no sign changes.
    pub fn is_none(&self) -> bool {
        self.flips.is_empty()
    }

    /// The number of sign changes, that of no unknown included. It is the number of solutions that
    /// go together.
    pub fn order(&self) -> usize {
        1 << self.flips.len()
    }

    /// Whether a monomial keeps its sign.
    pub fn keeps(&self, monomial: &Monomial) -> bool {
        self.flips.iter().all(|&flip| !is_odd(flip & parity(monomial)))
    }

    /// Generators of all sign changes: for each, the unknowns that it changes.
    pub fn generators(&self) -> Vec<Vec<usize>> {
        self.flips.iter().map(|&flip| unknowns_of(flip).collect()).collect()
    }

    /// All sign changes except that of no unknown: for each, the unknowns that it changes.
    pub fn all(&self) -> Vec<Vec<usize>> {
        let sum = |combination: usize| {
            let chosen = self.flips.iter().enumerate().filter(move |(at, _)| combination >> at & 1 == 1);
            chosen.fold(0, |sum: Flip, (_, flip)| sum ^ flip)
        };
        (1..self.order()).map(|combination| unknowns_of(sum(combination)).collect()).collect()
    }

    /// Ways to read all unknowns, one for each choice of pivots that comes first for some unknown.
    pub fn readings(&self, unknowns: &[usize]) -> Vec<Vec<Reading>> {
        let mut echelons: Vec<Vec<(usize, Flip)>> = Vec::new();
        for first in 0..unknowns.len().max(1) {
            let mut echelon = self.echelon(unknowns[first..].iter().chain(&unknowns[..first]).copied());
            echelon.sort_unstable();
            if !echelons.contains(&echelon) {
                echelons.push(echelon);
            }
        }
        let readings = |echelon: &Vec<(usize, Flip)>| {
            unknowns.iter().map(|&unknown| Reading { unknown, steps: steps(unknown, echelon) }).collect()
        };
        echelons.iter().map(readings).collect()
    }
}

/// The ratios of monomials from which an unknown is read.
fn steps(unknown: usize, echelon: &[(usize, Flip)]) -> Vec<Monomial> {
    let x = Monomial::unknown(unknown);
    if echelon.iter().any(|&(pivot, _)| pivot == unknown) {
        return vec![x.times(&x)];
    }
    let mut steps = vec![x];
    for pivot in echelon.iter().filter(|(_, flip)| flip >> unknown & 1 == 1).map(|&(pivot, _)| Monomial::unknown(pivot))
    {
        steps = steps.iter().flat_map(|step| [step.times(&pivot), step.over(&pivot)]).collect();
    }
    steps
}

fn unknowns_of(flip: Flip) -> impl Iterator<Item = usize> {
    (0..MAX_UNKNOWNS).filter(move |unknown| flip >> unknown & 1 == 1)
}

fn parity(monomial: &Monomial) -> Flip {
    monomial.exponents().iter().rev().fold(0, |bits, exponent| bits << 1 | Flip::from(exponent % 2 != 0))
}

fn is_odd(bits: Flip) -> bool {
    bits.count_ones() % 2 == 1
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(equations: &str) -> Symmetry {
        let text = format!("/// Some.\nfn sample(a: [f64; 9]) -> (x, y, z) {{\n{equations}\n}}\n");
        Symmetry::of_problem(&Problem::parse("sample.rs", &text).unwrap())
    }

    #[test]
    fn sign_changes_are_those_that_change_no_equation() {
        let three = "a[0] * x * x + a[1] * y * y + a[2] == 0; a[3] * y * y + a[4] * z * z + a[5] == 0; x * x + a[6] * z * z == a[7];";
        assert_eq!(of(three).order(), 8);
        let together = "x * y + a[0] * z * z == 1; x * x + a[1] * z + a[2] == 0; y * y + a[3] * z == a[4];";
        assert_eq!(of(together).all(), [vec![0, 1]]);
        assert!(of("x * y + a[0] * z * z == 1; x * x + a[1] * z + a[2] * x == 0; y * y + a[3] * z == a[4];").is_none());
        // A factor that must not vanish is an equation of solutions that are none.
        let factor = "x * x == a[0]; y * y == a[1]; z == a[2] * x * y; x + 1 != 0;";
        assert_eq!(of(factor).all(), [vec![1, 2]]);
    }

    #[test]
    fn unknowns_are_read_from_one_class() {
        let symmetry = of("x * x * y == a[0] * z; y * z == a[1] * x; z * z + a[2] * x * x == a[3];");
        assert_eq!(symmetry.all(), [vec![1, 2]]);
        let kept = [0, 1, 2];
        // Either y or z is the pivot.
        assert_eq!(symmetry.readings(&kept).len(), 2);
        for readings in symmetry.readings(&kept) {
            assert_eq!(readings.iter().map(|reading| reading.unknown).collect::<Vec<_>>(), kept);
            assert!(
                readings.iter().flat_map(|reading| &reading.steps).all(|step| symmetry.keeps(step)),
                "{readings:?}"
            );
        }
        let none = Symmetry::NONE.readings(&[1, 2]);
        let plain = [1, 2].map(|unknown| Reading { unknown, steps: vec![Monomial::unknown(unknown)] });
        assert_eq!(none, [plain]);
    }

    #[test]
    fn a_template_that_mixes_classes_has_no_symmetry() {
        let symmetry = of("x * x == a[0]; y * y == a[1]; z == a[2] * x * y;");
        assert_eq!(symmetry.order(), 4);
        let m = |exponents: &[i8]| Monomial::from_exponents(exponents);
        assert_eq!(symmetry.of_template(&m(&[2]), &[m(&[0]), m(&[1, 1])]).order(), 2);
        assert_eq!(symmetry.of_template(&m(&[1]), &[m(&[0]), m(&[1])]).all(), [vec![1, 2]]);
        assert!(symmetry.of_template(&m(&[1]), &[m(&[0]), m(&[0, 1])]).is_none());
    }

    #[test]
    fn all_sign_changes_are_sums_of_generators() {
        let symmetry = of("x * x == a[0]; y * y == a[1]; z * z == a[2];");
        assert_eq!(symmetry.generators(), [[0], [1], [2]]);
        // Each unknown is a pivot, whichever comes first.
        assert_eq!(symmetry.readings(&[0, 1, 2]).len(), 1);
        let mut all = symmetry.all();
        all.sort();
        let expected: [&[usize]; 7] = [&[0], &[0, 1], &[0, 1, 2], &[0, 2], &[1], &[1, 2], &[2]];
        assert_eq!(all, expected);
        assert!(!symmetry.is_none() && Symmetry::NONE.is_none());
        let m = |exponents: &[i8]| Monomial::from_exponents(exponents);
        assert!(symmetry.keeps(&m(&[2, 0, -4])) && !symmetry.keeps(&m(&[2, 1])) && Symmetry::NONE.keeps(&m(&[1])));
        // Of x and x y only y tells the classes apart.
        let of_class = symmetry.of_template(&Monomial::ONE, &[m(&[1]), m(&[1, 1])]);
        assert_eq!(of_class.generators(), [[0], [2]]);
    }

    #[test]
    fn sign_changes_of_eliminated_unknowns_are_left_out() {
        let symmetry = of("x * x == a[0]; y == a[1] * x; z * z == a[2];");
        assert_eq!(symmetry.generators(), [vec![0, 1], vec![2]]);
        assert_eq!(symmetry.on(&[0, 1]).generators(), [[0, 1]]);
        assert_eq!(symmetry.on(&[1, 2]).generators(), [vec![0, 1], vec![2]]);
        assert_eq!(symmetry.on(&[2]).generators(), [[2]]);
        assert!(symmetry.on(&[]).is_none());
    }

    /// Whichever unknowns come first.
    #[test]
    fn pivots_are_changed_by_one_generator_only() {
        let symmetry = of("x * y == a[0] * z; x * x + a[1] * y * y + a[2] * z * z == a[3]; x * y * z == a[4];");
        let mut all = symmetry.all();
        all.sort();
        assert_eq!(all, [[0, 1], [0, 2], [1, 2]]);
        for order in [[0, 1, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
            let echelon = symmetry.echelon(order.into_iter());
            assert_eq!(echelon.iter().map(|&(pivot, _)| pivot).collect::<Vec<_>>(), order[..2]);
            for &(pivot, _) in &echelon {
                assert_eq!(echelon.iter().filter(|(_, flip)| flip >> pivot & 1 == 1).count(), 1, "{echelon:?}");
            }
        }
    }
}
