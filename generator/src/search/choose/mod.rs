//! Chooses among the templates that a search found, by their cost and by what they do on random real instances.
//!
//! # The rule
//! Candidates are considered in the order of the preference ([`Preference::key`]): *speed* fewest operations first, *size* fewest rows first
//! among those with at most [`SIZE_COST`] times the operations of the cheapest, *stability* fewest operations first, up to [`STABILITY_COST`] times those of the first one that is not rejected. Of each combination of presolved
//! form, action monomial and basis only the first is.
//!
//! 1. *Screening.* [`SCREENED`] candidates are measured on [`Measuring::trials`] instances. A candidate is *rejected* if an instance fails, or if so many
//!    lack a solution that one in [`INCOMPLETE_ONE_IN`] would explain it with a probability below [`SIGNIFICANCE`]. It is *precise* if
//!    the 99 % quantile of its log10 relative residual is at most [`GOOD_RESIDUAL`], or at most 1 above the best of those that are not rejected.
//! 2. *Confirmation.* Those that are precise and not rejected are measured on [`Measuring::confirm`] instances, in the order of the preference (for *speed*
//!    second attempts count as [`SECOND_ATTEMPT`] solves, and of those that cost at most [`EQUAL_COST`] times the least the one with fewest rows comes first; for *stability*: fewest unsolved instances, then smallest 99 % quantile, then smallest median), each only until it is rejected. The first that lasts and lacks a solution
//!    on at most one instance in [`INCOMPLETE_ONE_IN`] is *accepted*. Where none is, further candidates are screened, up to [`SCREENED_AT_MOST`] and until
//!    all measurements together take [`MEASURING_WORK`].
//! 3. *Choice.* If the accepted one solves every instance it is chosen (*stability* looks on, and *speed* where second attempts turn out to make it dearer than another). Otherwise up to [`RIVALS`] others of similar cost are confirmed
//!    too (*speed*: operations, with those of second attempts, within [`SIMILAR_COST`]; *size*: as many rows; *stability*: all), and the accepted one with the fewest unsolved instances is chosen.
//!
//! Large templates are measured on fewer instances: on as many as [`SCREENING_WORK`] and [`CONFIRMING_WORK`] allow, but on [`INCOMPLETE_ONE_IN`] at least
//! for a confirmation. A problem without data has one instance.
//!
//! Where none is accepted, the one with the smallest share of unsolved instances is chosen, and the choice says so.

#[cfg(test)]
mod tests;

use std::ops::Range;

use crate::search::candidate::Candidate;
use crate::search::measuring::{Stability, measure};
use crate::search::monitor::{Monitor, Stage};
use crate::search::preference::{Cost, Preference};

/// Candidates that are screened in any case.
pub const SCREENED: usize = 8;
/// No more candidates are screened.
pub const SCREENED_AT_MOST: usize = 32;
/// One instance in so many may lack a solution.
pub const INCOMPLETE_ONE_IN: usize = 1000;
/// A candidate is rejected early only where chance explains its failures with a probability below this.
pub const SIGNIFICANCE: f64 = 0.01;
/// A 99 % quantile of the log10 relative residual that is good enough.
pub const GOOD_RESIDUAL: f64 = -12.0;
/// What stability may cost, as a factor of operations.
pub const STABILITY_COST: f64 = 2.0;
/// What few rows may cost, as a factor of operations: a larger basis always saves rows, at the cube of its size.
pub const SIZE_COST: f64 = 2.5;
/// Candidates whose operations differ by no more than this factor cost the same for the choice.
pub const SIMILAR_COST: f64 = 1.1;
/// Candidates within this factor of the fewest operations are as fast, as far as the estimate tells: fewer rows take less memory and less code.
pub const EQUAL_COST: f64 = 1.05;
/// Operations of a second attempt, at twice the precision, as a factor of those of the first.
pub const SECOND_ATTEMPT: f64 = 15.0;
/// Candidates that are confirmed besides the first accepted one.
pub const RIVALS: usize = 2;
/// Operations that screening one candidate may take, without the polish; where a solve takes so many that this binds, fewer instances are drawn.
pub const SCREENING_WORK: usize = 300_000_000;
/// Operations that confirming one candidate may take, without the polish.
pub const CONFIRMING_WORK: usize = 10_000_000_000;
/// Operations after which no further candidate is confirmed and no more than [`SCREENED`] are screened, second attempts included: so much take a few that are
/// rejected late.
pub const MEASURING_WORK: f64 = 5e10;
/// Instances that are measured at once; after each block the candidate may be rejected.
const BLOCK: usize = 100;

/// How much is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Measuring {
    /// Instances on which candidates are screened.
    pub trials: usize,
    /// Instances on which the chosen one must hold; no fewer than `trials` are used.
    pub confirm: usize,
    /// Seed of the instances.
    pub seed: u64,
}

/// What measuring a candidate came to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Not rejected on the instances so far.
    Screened,
    /// Confirmed.
    Accepted,
    /// It fails, or lacks solutions on too many instances.
    Rejected,
}

impl Verdict {
    /// The name in reports and files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Screened => "screened",
            Self::Accepted => "accepted",
            Self::Rejected => "rejected",
        }
    }
}

/// A candidate with what it does on random real instances.
#[derive(Clone, Debug)]
pub struct Measured {
    /// The candidate.
    pub candidate: Candidate,
    /// Its measurement.
    pub stability: Stability,
    /// What that came to.
    pub verdict: Verdict,
}

/// Candidates that were measured, in the order of the preference, and the one to use.
#[derive(Clone, Debug)]
pub struct Choice {
    /// At least one.
    pub measured: Vec<Measured>,
    /// Index into `measured`.
    pub chosen: usize,
    /// Different candidates that were not measured.
    pub unmeasured: usize,
    /// Whether the monitor ended the measurements.
    pub is_cut: bool,
}

/// Measures candidates and chooses one by the rule at the top of this module; `None` where there is no candidate.
/// `candidates` are in the order of the preference; `known` are measurements on the first instances, made by [`screen`] with the same `measuring`.
pub fn choose(
    candidates: &[Candidate],
    preference: Preference,
    measuring: Measuring,
    known: &dyn Fn(&Candidate) -> Option<Stability>,
    monitor: &dyn Monitor,
) -> Option<Choice> {
    let different = affordable(different(candidates), preference);
    let known = |at: usize| known(different[at]);
    let (chosen, entries) = on_board(&different, preference, measuring, &known, monitor, |board| {
        board.accept().or_else(|| board.least_bad())
    });
    let chosen = chosen?;
    let is_cut = monitor.is_over(Stage::Measuring) && entries[chosen].verdict != Verdict::Accepted;
    let unmeasured = different.len() - entries.len();
    let with = |(entry, candidate): (Entry, &&Candidate)| Measured {
        candidate: (*candidate).clone(),
        stability: entry.stability,
        verdict: entry.verdict,
    };
    Some(Choice { measured: entries.into_iter().zip(&different).map(with).collect(), chosen, unmeasured, is_cut })
}

/// Candidates that a share of a search hands over at most: more than are ever screened.
pub const HANDED_OVER: usize = 2 * SCREENED_AT_MOST;

/// The candidates that may be chosen where others join, in the order of the preference, with their measurements where they are screened.
pub fn screen<'a>(
    candidates: &'a [Candidate],
    preference: Preference,
    measuring: Measuring,
    monitor: &dyn Monitor,
) -> Vec<(&'a Candidate, Option<Stability>)> {
    let mut different = affordable(different(candidates), preference);
    // What size may cost depends on the cheapest one of all.
    let cheapest = different.iter().copied().min_by_key(|candidate| candidate.plan.operations().total());
    let dropped = different.split_off(different.len().min(HANDED_OVER));
    different.extend(cheapest.filter(|cheapest| dropped.iter().any(|candidate| std::ptr::eq(*candidate, *cheapest))));
    let ((), entries) = on_board(&different, preference, measuring, &|_| None, monitor, |board| {
        board.screen();
    });
    let measured = entries.into_iter().map(|entry| Some(entry.stability)).chain(std::iter::repeat(None));
    different.into_iter().zip(measured).collect()
}

/// Decides on a board for real candidates, and returns it with the measurements.
fn on_board<R>(
    candidates: &[&Candidate],
    preference: Preference,
    measuring: Measuring,
    known: &dyn Fn(usize) -> Option<Stability>,
    monitor: &dyn Monitor,
    decide: impl FnOnce(&mut Board<'_>) -> R,
) -> (R, Vec<Entry>) {
    let costs: Vec<Cost> = candidates.iter().map(|candidate| candidate.cost()).collect();
    let measure = |at: usize, instances: Range<usize>| {
        let t = &candidates[at].template;
        let (rows, columns) = (t.rows(), t.columns());
        monitor.say(&format!("measuring template {} ({rows} x {columns}) on {} instances", at + 1, instances.end));
        measure(&candidates[at].plan, instances, measuring.seed, &|| ())
    };
    let has_data = candidates.iter().any(|candidate| !candidate.plan.data.is_empty());
    let measuring = if has_data { measuring } else { Measuring { trials: 1, confirm: 1, ..measuring } };
    let entries = Vec::new();
    let mut board = Board { costs: &costs, preference, measuring, known, measure: &measure, monitor, entries };
    let decision = decide(&mut board);
    (decision, board.entries)
}

/// The first candidate of each combination of presolved form, action monomial and basis.
fn different(candidates: &[Candidate]) -> Vec<&Candidate> {
    let mut seen = Vec::new();
    let mut different = Vec::new();
    for candidate in candidates {
        let mut basis = candidate.template.basis.clone();
        basis.sort_unstable();
        let key = (candidate.presolve, candidate.template.action, basis);
        if !seen.contains(&key) {
            seen.push(key);
            different.push(candidate);
        }
    }
    different
}

/// Those that size may cost; all for other preferences.
fn affordable(candidates: Vec<&Candidate>, preference: Preference) -> Vec<&Candidate> {
    let operations = |candidate: &&Candidate| candidate.plan.operations().total() as f64;
    let least = candidates.iter().map(operations).fold(f64::INFINITY, f64::min);
    let is_affordable =
        |candidate: &&Candidate| preference != Preference::Size || operations(candidate) <= SIZE_COST * least;
    candidates.into_iter().filter(is_affordable).collect()
}

struct Entry {
    stability: Stability,
    verdict: Verdict,
}

/// The measurements so far, of the first candidates.
struct Board<'a> {
    costs: &'a [Cost],
    preference: Preference,
    measuring: Measuring,
    /// What is known of a candidate beforehand.
    known: &'a dyn Fn(usize) -> Option<Stability>,
    /// What a candidate does on a range of instances.
    measure: &'a dyn Fn(usize, Range<usize>) -> Stability,
    monitor: &'a dyn Monitor,
    entries: Vec<Entry>,
}

impl Board<'_> {
    /// Screens and confirms until candidates are accepted; the best of them.
    fn accept(&mut self) -> Option<usize> {
        while self.screen() {
            for first in self.finalists() {
                if self.confirm(first) {
                    return Some(self.best_rival(first));
                }
                if self.is_over() || self.is_exhausted() {
                    return None;
                }
            }
        }
        None
    }

    /// Screens at least [`SCREENED`] more, and more until one is worth confirming. Whether any is.
    fn screen(&mut self) -> bool {
        let before = self.entries.len();
        while self.entries.len() < self.costs.len().min(SCREENED_AT_MOST) {
            let enough = self.entries.len() >= before + SCREENED && !self.finalists().is_empty();
            // The first one is measured in any case, so that there is something to choose.
            let more = self.entries.len() >= SCREENED && self.is_exhausted();
            if enough || more || !self.is_affordable(self.entries.len()) || (!self.entries.is_empty() && self.is_over())
            {
                break;
            }
            let at = self.entries.len();
            let stability = (self.known)(at).unwrap_or_default();
            self.entries.push(Entry { verdict: self.verdict(at, &stability), stability });
            self.measure_up_to(at, self.trials(at));
        }
        !self.finalists().is_empty()
    }

    /// Stability has a bound on its cost.
    fn is_affordable(&self, at: usize) -> bool {
        let first = self.entries.iter().position(|entry| entry.verdict != Verdict::Rejected);
        match (self.preference, first) {
            (Preference::Stability, Some(first)) => {
                self.costs[at].operations as f64 <= STABILITY_COST * self.costs[first].operations as f64
            }
            _ => true,
        }
    }

    fn is_over(&self) -> bool {
        self.monitor.is_over(Stage::Measuring)
    }

    /// Whether the measurements so far took all the work that they may take.
    fn is_exhausted(&self) -> bool {
        let work = |at: usize| self.entries[at].stability.trials as f64 * self.expected_operations(at);
        (0..self.entries.len()).map(work).sum::<f64>() >= MEASURING_WORK
    }

    /// Precise ones that are neither rejected nor accepted, in the order in which they are confirmed.
    fn finalists(&self) -> Vec<usize> {
        let alive = |at: &usize| self.entries[*at].verdict != Verdict::Rejected;
        let best = (0..self.entries.len()).filter(alive).map(|at| self.p99(at)).fold(f64::INFINITY, f64::min);
        let precise = |at: &usize| self.p99(*at) <= GOOD_RESIDUAL.max(best + 1.0);
        let open = |at: &usize| self.entries[*at].verdict == Verdict::Screened;
        let mut finalists: Vec<usize> = (0..self.entries.len()).filter(open).filter(precise).collect();
        match self.preference {
            Preference::Speed => self.sort_by_speed(&mut finalists),
            Preference::Stability => finalists.sort_by(|&a, &b| self.by_stability(a, b)),
            Preference::Size => {}
        }
        finalists
    }

    /// Whether it is accepted.
    fn confirm(&mut self, at: usize) -> bool {
        if self.measure_up_to(at, self.confirm_trials(at)) {
            self.entries[at].verdict = Verdict::Accepted;
        }
        self.entries[at].verdict == Verdict::Accepted
    }

    /// Of `first`, which is accepted, and others of similar cost.
    fn best_rival(&mut self, first: usize) -> usize {
        let mut accepted = vec![first];
        if self.preference == Preference::Stability || self.unsolved(first) > 0 || self.is_dearer_than_screened(first) {
            let similar = |at: &usize| self.is_similar(first, *at);
            for rival in self.finalists().into_iter().filter(similar).take(RIVALS).collect::<Vec<_>>() {
                if self.confirm(rival) {
                    accepted.push(rival);
                }
            }
        }
        let least = accepted.iter().map(|&at| self.unsolved(at)).min();
        accepted.retain(|&at| self.preference == Preference::Stability || Some(self.unsolved(at)) == least);
        match self.preference {
            Preference::Stability => accepted.sort_by(|&a, &b| self.by_stability(a, b)),
            Preference::Speed => self.sort_by_speed(&mut accepted),
            Preference::Size => accepted.sort_unstable(),
        }
        accepted.first().copied().unwrap_or(first)
    }

    /// Whether more instances than were screened show that another one costs less, second attempts included.
    fn is_dearer_than_screened(&self, at: usize) -> bool {
        let is_cheaper = |&other: &usize| EQUAL_COST * self.expected_operations(other) < self.expected_operations(at);
        self.preference == Preference::Speed && self.finalists().iter().any(is_cheaper)
    }

    fn is_similar(&self, a: usize, b: usize) -> bool {
        match self.preference {
            Preference::Speed => self.expected_operations(b) <= SIMILAR_COST * self.expected_operations(a),
            Preference::Size => self.costs[b].rows == self.costs[a].rows,
            Preference::Stability => true,
        }
    }

    /// Of one that is not confirmed.
    fn verdict(&self, at: usize, stability: &Stability) -> Verdict {
        match is_rejected(stability, self.confirm_trials(at)) {
            true => Verdict::Rejected,
            false => Verdict::Screened,
        }
    }

    /// Instances on which it is screened.
    fn trials(&self, at: usize) -> usize {
        self.measuring.trials.min((SCREENING_WORK / self.costs[at].operations.max(1)).max(BLOCK))
    }

    /// Instances on which it is confirmed.
    fn confirm_trials(&self, at: usize) -> usize {
        let affordable = (CONFIRMING_WORK / self.costs[at].operations.max(1)).max(INCOMPLETE_ONE_IN);
        self.measuring.confirm.min(affordable).max(self.trials(at))
    }

    /// Measures on the first `trials` instances in all, until it is rejected or the time is over. Whether it lasted.
    fn measure_up_to(&mut self, at: usize, trials: usize) -> bool {
        loop {
            let from = self.entries[at].stability.trials;
            if self.entries[at].verdict == Verdict::Rejected {
                return false;
            }
            if from >= trials {
                return true;
            }
            if from > 0 && self.is_over() {
                return false;
            }
            let block = (self.measure)(at, from..(from + BLOCK).min(trials));
            self.entries[at].stability.join(block);
            self.entries[at].verdict = self.verdict(at, &self.entries[at].stability);
        }
    }

    /// Where nothing is accepted: a finalist if the time is over, or else the smallest share of unsolved instances; few trials say little.
    fn least_bad(&self) -> Option<usize> {
        let share = |at: usize| (self.unsolved(at) + 1) as f64 / (self.entries[at].stability.trials + 1) as f64;
        let by_share = |&a: &usize, &b: &usize| {
            share(a).total_cmp(&share(b)).then(self.p99(a).total_cmp(&self.p99(b))).then(a.cmp(&b))
        };
        self.finalists().first().copied().or_else(|| (0..self.entries.len()).min_by(by_share))
    }

    fn by_stability(&self, a: usize, b: usize) -> std::cmp::Ordering {
        let quantile = |at: usize, q: f64| self.entries[at].stability.quantile(q).unwrap_or(f64::INFINITY);
        let by_quantile = |q: f64| quantile(a, q).total_cmp(&quantile(b, q));
        self.unsolved(a).cmp(&self.unsolved(b)).then(by_quantile(0.99)).then(by_quantile(0.5)).then(a.cmp(&b))
    }

    /// Operations of a solve on the average, second attempts included.
    fn expected_operations(&self, at: usize) -> f64 {
        expected_operations(self.costs[at].operations, &self.entries[at].stability)
    }

    /// Sorts by expected operations; those that cost as much as the cheapest come first, in the order of their rows.
    fn sort_by_speed(&self, candidates: &mut [usize]) {
        let expected = |at: usize| self.expected_operations(at);
        let least = candidates.iter().map(|&at| expected(at)).fold(f64::INFINITY, f64::min);
        let rows = |at: usize| if expected(at) <= EQUAL_COST * least { self.costs[at].rows } else { usize::MAX };
        candidates.sort_by(|&a, &b| rows(a).cmp(&rows(b)).then(expected(a).total_cmp(&expected(b))).then(a.cmp(&b)));
    }

    fn p99(&self, at: usize) -> f64 {
        self.entries[at].stability.quantile(0.99).unwrap_or(f64::INFINITY)
    }

    fn unsolved(&self, at: usize) -> usize {
        self.entries[at].stability.incomplete + self.entries[at].stability.failures
    }
}

/// Operations of a solve on the average, where one without second attempts takes `operations`.
pub fn expected_operations(operations: usize, stability: &Stability) -> f64 {
    let Stability { trials, repeated, .. } = *stability;
    operations as f64 * (1.0 + SECOND_ATTEMPT * repeated as f64 / trials.max(1) as f64)
}

/// A failure, more incomplete instances than `confirm` instances may have, or more than chance explains.
fn is_rejected(stability: &Stability, confirm: usize) -> bool {
    let Stability { trials, incomplete, failures, .. } = *stability;
    failures > 0
        || incomplete * INCOMPLETE_ONE_IN > confirm
        || at_least(incomplete, trials as f64 / INCOMPLETE_ONE_IN as f64) < SIGNIFICANCE
}

/// The probability that a Poisson variable of this mean is at least `count`.
fn at_least(count: usize, mean: f64) -> f64 {
    let (mut below, mut term) = (0.0, (-mean).exp());
    for k in 0..count {
        below += term;
        term *= mean / (k + 1) as f64;
    }
    1.0 - below
}
