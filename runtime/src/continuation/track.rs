//! Follows a solution along a path of the data, by steps of Newton's method.

extern crate alloc;

use alloc::vec::Vec;
use num_complex::Complex;

use crate::continuation::family::Family;
use crate::continuation::member::Member;
use crate::continuation::path::DataPath;
use crate::dynamic_size::Dynamic;
use crate::size::filled_matrix;
use crate::solution::polish::{Polish, Step, largest, zero_below_accuracy};

/// The first step in t.
const FIRST: f64 = 0.125;
/// So many systems of equations are kept.
const MOST_MEMBERS: usize = 64;
/// A step in t is accepted if Newton's method moves the predicted point by at most this part of its
/// largest unknown, and each of its steps is at most [`RATE`] times the one before: other solutions
/// are then far away.
const NEAR: f64 = 0.03;
const RATE: f64 = 0.25;
/// Newton's method has converged at steps of this part of the largest unknown: the next one would
/// be the square of it.
const CONVERGED: f64 = 1e-7;
/// It takes at most so many steps.
const NEWTON_STEPS: usize = 6;
/// The step in t is doubled where the first step of Newton's method was at most this, but not in
/// the next few steps after one that was too long.
const EASY: f64 = 0.003;
const PATIENCE: u32 = 3;
/// A point is predicted from so many before.
const PREDICTING: usize = 3;
/// A path is given up after so many steps in t.
const MOST_STEPS: usize = 300;
/// It has ended, at a solution that is not isolated or at infinity, if t is so small.
const LEAST: f64 = 1e-9;
/// So many multiplications are spent on all paths at most: less than a tenth of a second.
const MOST_WORK: u64 = 50_000_000;
/// The steps of Newton's method that a path takes at least, to tell whether the work is too much.
const LEAST_STEPS: u64 = 150;
/// A path may end with all unknowns 0: they count as at least this part of the largest at its
/// start.
const AT_ORIGIN: f64 = 1e-2;
/// An end is isolated if a relative error of the equations moves it by at most so many times this
/// error, relative to its largest unknown.
const ISOLATED: f64 = 1e10;

/// A point of the path of a solution, with its t.
type Passed = (f64, Vec<Complex<f64>>);

/// A corrected point, and how far the first step moved it.
type Passing = (Vec<Complex<f64>>, f64);

/// Follows the solutions along one path of the data.
pub(crate) struct Tracker<'a> {
    family: &'a Family<'a>,
    path: &'a DataPath,
    /// Equations with their t. All t are sums of a few powers of two, so that paths of different
    /// solutions often meet the same; the coefficients cost more than Newton's step.
    members: Vec<(f64, Member<'a>)>,
    /// The place of the next one that is forgotten for a new one.
    oldest: usize,
    /// The multiplications that are left.
    work: u64,
}

/// About how many multiplications a step of Newton's method takes, and how many the coefficients.
fn work_of(family: &Family<'_>) -> [u64; 2] {
    let (unknowns, equations) = (family.unknowns, family.ends.len());
    let step = family.terms.len() * (unknowns + 1) + equations * unknowns * unknowns;
    [step, family.counts.0].map(|count| 4 * count as u64)
}

/// Whether so many paths can be followed with the work that may be spent.
pub(crate) fn is_affordable(family: &Family<'_>, paths: usize) -> bool {
    let [step, coefficients] = work_of(family);
    (LEAST_STEPS * paths as u64).saturating_mul(step + coefficients / 4) <= MOST_WORK
}

impl<'a> Tracker<'a> {
    pub(crate) fn new(family: &'a Family<'a>, path: &'a DataPath) -> Self {
        Self { family, path, members: Vec::new(), oldest: 0, work: MOST_WORK }
    }

    /// The end of the path of a solution; `None` if it is at infinity, or not isolated.
    pub(crate) fn end_of_path(&mut self, start: &[Complex<f64>]) -> Option<Vec<Complex<f64>>> {
        let mut passed: Vec<Passed> = alloc::vec![(1.0, start.into())];
        let least = AT_ORIGIN * largest(start);
        let (mut t, mut step, mut streak) = (1.0, FIRST, PATIENCE);
        for _ in 0..MOST_STEPS {
            // Most steps in t take three of Newton's method.
            let Some(rest) = self.work.checked_sub(3 * work_of(self.family)[0]) else { break };
            self.work = rest;
            // No short step remains before the end.
            let next = if step < 0.8 * t { t - step } else { 0.0 };
            match corrected(self.member(next), predicted(&passed, next), least) {
                Some((point, _)) if next == 0.0 => {
                    return is_isolated(self.member(0.0), &point, least).then_some(point);
                }
                Some((point, moved)) => {
                    if passed.len() == PREDICTING {
                        passed.remove(0);
                    }
                    passed.push((next, point));
                    t = next;
                    streak += 1;
                    step *= if moved <= EASY && streak > PATIENCE { 2.0 } else { 1.0 };
                }
                None => (step, streak) = (0.5 * step, 0),
            }
            if t < LEAST || step < LEAST * t {
                break;
            }
        }
        None
    }

    /// The equations for the data at t.
    fn member(&mut self, t: f64) -> &Member<'a> {
        let known = self.members.iter().position(|(of_member, _)| *of_member == t);
        let at = known.unwrap_or_else(|| {
            self.work = self.work.saturating_sub(work_of(self.family)[1]);
            let member = (t, self.family.at(&self.path.at(t)));
            if self.members.len() < MOST_MEMBERS {
                self.members.push(member);
                return self.members.len() - 1;
            }
            let at = self.oldest;
            self.members[at] = member;
            self.oldest = (at + 1) % MOST_MEMBERS;
            at
        });
        &self.members[at].1
    }
}

/// The point at t of the polynomial through points of the path, by Lagrange's formula.
fn predicted(passed: &[Passed], t: f64) -> Vec<Complex<f64>> {
    let unknowns = passed.first().map_or(0, |(_, x)| x.len());
    let mut sum = alloc::vec![Complex::ZERO; unknowns];
    for (i, (own, x)) in passed.iter().enumerate() {
        let others = passed.iter().enumerate().filter(|(j, _)| *j != i);
        let factor: f64 = others.map(|(_, (other, _))| (t - other) / (own - other)).product();
        sum.iter_mut().zip(x).for_each(|(sum, x)| *sum += x.scale(factor));
    }
    sum
}

/// The step of Newton's method at x.
fn newton_step(member: &Member<'_>, x: &Vec<Complex<f64>>) -> Option<Step<Complex<f64>, Dynamic>> {
    let sizes = member.sizes();
    let mut newton = Polish::new(x, sizes, member);
    if newton.residual() == f64::INFINITY {
        return None;
    }
    newton.newton_step(x, &mut filled_matrix(sizes.0, sizes.1, Complex::ZERO))
}

/// The solution that Newton's method finds near a point, and the length of its first step. Lengths
/// are relative to the largest unknown, or to the least that counts.
fn corrected(member: &Member<'_>, mut x: Vec<Complex<f64>>, least: f64) -> Option<Passing> {
    let (mut first, mut longest) = (0.0, NEAR);
    for k in 0..NEWTON_STEPS {
        let step = newton_step(member, &x)?.correction;
        let length = largest(&step) / largest(&x).max(least);
        if !(length <= longest) {
            return None;
        }
        x.iter_mut().zip(&step).for_each(|(x, &step)| *x -= step);
        // Rounding errors of zeros would be all terms of some equations, and give these a weight
        // beside which others count for nothing.
        x = zero_below_accuracy(member.sizes().0, &x, 0.0);
        if k == 0 {
            first = length;
        }
        if length <= CONVERGED {
            return Some((x, first));
        }
        longest = RATE * length;
    }
    None
}

fn is_isolated(member: &Member<'_>, x: &Vec<Complex<f64>>, least: f64) -> bool {
    newton_step(member, x).is_some_and(|step| step.enlargement <= ISOLATED * largest(x).max(least))
}
