//! The tournament by which candidates are screened, confirmed and chosen; [`super`] states its
//! rule.

use std::ops::Range;

use super::rule::{
    BLOCK, BLOCK_WORK, CONFIRMING_WORK, EQUAL_COST, GOOD_RESIDUAL, INCOMPLETE_ONE_IN, MEASURING_WORK,
    MOST_CONFIRMING_WORK, MOST_SCREENING_WORK, Measuring, OTHERS_CONFIRMED, SCREENED, SCREENED_AT_MOST, SCREENING_WORK,
    SIMILAR_COST, STABILITY_COST, Verdict, expected_nanoseconds, is_rejected,
};
use crate::search::measuring::Stability;
use crate::search::monitor::{Monitor, Stage};
use crate::search::preference::{Cost, Preference};

/// The measurement of a candidate so far.
pub(super) struct Entry {
    pub(super) stability: Stability,
    pub(super) verdict: Verdict,
}

/// The measurements so far. Candidates are indices into their costs.
///
/// ```text
///              entries              costs without an entry
/// candidate    0   1   2   ...  k | k+1  ...  n
/// verdict      R   S   A   ...  S |                         rejected, screened, accepted
/// ```
pub(super) struct Tournament<'a> {
    /// All candidates, in the order of the preference.
    pub(super) costs: &'a [Cost],
    pub(super) preference: Preference,
    pub(super) measuring: Measuring,
    /// A measurement of a candidate that was made before.
    pub(super) known: &'a dyn Fn(usize) -> Option<Stability>,
    /// Measures a candidate on a range of instances.
    pub(super) measure: &'a dyn Fn(usize, Range<usize>) -> Stability,
    pub(super) monitor: &'a dyn Monitor,
    /// The candidates that are measured, the first ones.
    pub(super) entries: Vec<Entry>,
}

impl Tournament<'_> {
    /// Screens and confirms until candidates are accepted. Returns the best of these.
    pub(super) fn accept(&mut self) -> Option<usize> {
        while self.screen() {
            for first in self.finalists() {
                if self.confirm(first) {
                    return Some(self.best_confirmed(first));
                }
                if self.is_over() || self.is_exhausted() {
                    return None;
                }
            }
        }
        None
    }

    /// Screens at least [`SCREENED`] more candidates, and more until there is a finalist. Returns
    /// whether there is one.
    pub(super) fn screen(&mut self) -> bool {
        let before = self.entries.len();
        while self.entries.len() < self.costs.len().min(SCREENED_AT_MOST) {
            let enough = self.entries.len() >= before + SCREENED && !self.finalists().is_empty();
            let too_much = self.entries.len() >= SCREENED && self.is_exhausted();
            // The first candidate is measured in any case, so that there is something to choose.
            if enough
                || too_much
                || !self.is_affordable(self.entries.len())
                || (!self.entries.is_empty() && self.is_over())
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

    /// Whether a candidate is within the limit on the cost of stability.
    fn is_affordable(&self, at: usize) -> bool {
        let first = self.entries.iter().position(|entry| entry.verdict != Verdict::Rejected);
        match (self.preference, first) {
            (Preference::Stability, Some(first)) => {
                self.costs[at].nanoseconds as f64 <= STABILITY_COST * self.costs[first].nanoseconds as f64
            }
            _ => true,
        }
    }

    fn is_over(&self) -> bool {
        self.monitor.is_over(Stage::Measuring)
    }

    /// Whether the measurements so far took [`MEASURING_WORK`].
    fn is_exhausted(&self) -> bool {
        let work = |at: usize| self.entries[at].stability.trials as f64 * self.expected_operations(at);
        (0..self.entries.len()).map(work).sum::<f64>() >= MEASURING_WORK
    }

    /// Precise candidates that are neither rejected nor accepted, in the order in which they are
    /// confirmed.
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

    /// Measures a finalist on all instances. Returns whether it is accepted.
    fn confirm(&mut self, at: usize) -> bool {
        if self.measure_up_to(at, self.confirm_trials(at)) {
            self.entries[at].verdict = Verdict::Accepted;
        }
        self.entries[at].verdict == Verdict::Accepted
    }

    /// The best of the first accepted candidate and of others of similar cost that are confirmed,
    /// too.
    fn best_confirmed(&mut self, first: usize) -> usize {
        let mut accepted = vec![first];
        let is_dearer = self.is_dearer_than_screened(first);
        if self.preference == Preference::Stability || self.unsolved(first) > 0 || is_dearer {
            let mut others = self.finalists();
            others.retain(|&other| self.is_similar(first, other));
            if is_dearer {
                let expected = |&at: &usize| self.expected_nanoseconds(at);
                others.sort_by(|a, b| expected(a).total_cmp(&expected(b)));
            }
            for other in others.into_iter().take(OTHERS_CONFIRMED) {
                if self.confirm(other) {
                    accepted.push(other);
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

    /// Whether the confirmation shows that another finalist costs less, second attempts included.
    /// Screening sees too few instances to count second attempts well.
    fn is_dearer_than_screened(&self, at: usize) -> bool {
        let is_cheaper = |&other: &usize| EQUAL_COST * self.expected_nanoseconds(other) < self.expected_nanoseconds(at);
        self.preference == Preference::Speed && self.finalists().iter().any(is_cheaper)
    }

    fn is_similar(&self, a: usize, b: usize) -> bool {
        match self.preference {
            Preference::Speed => self.expected_nanoseconds(b) <= SIMILAR_COST * self.expected_nanoseconds(a),
            Preference::Size => self.costs[b].rows == self.costs[a].rows,
            Preference::Stability => true,
        }
    }

    /// The verdict on a candidate that is not confirmed.
    fn verdict(&self, at: usize, stability: &Stability) -> Verdict {
        match is_rejected(stability, self.confirm_trials(at)) {
            true => Verdict::Rejected,
            false => Verdict::Screened,
        }
    }

    /// Number of instances on which a candidate is screened.
    fn trials(&self, at: usize) -> usize {
        let within = |work: usize| work / self.costs[at].operations.max(1);
        let least = within(MOST_SCREENING_WORK).clamp(1, BLOCK);
        self.measuring.trials.min(within(SCREENING_WORK).max(least))
    }

    /// Number of instances on which a candidate is confirmed.
    fn confirm_trials(&self, at: usize) -> usize {
        let within = |work: usize| work / self.costs[at].operations.max(1);
        let least = within(MOST_CONFIRMING_WORK).clamp(1, INCOMPLETE_ONE_IN);
        self.measuring.confirm.min(within(CONFIRMING_WORK).max(least)).max(self.trials(at))
    }

    /// Measures a candidate until it has seen the first `trials` instances, is rejected, or the
    /// time is over. Returns whether it has seen them all and is not rejected.
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
            let most = (BLOCK_WORK / self.costs[at].operations.max(1)).clamp(1, BLOCK);
            let block = (self.measure)(at, from..(from + most).min(trials));
            // A search that is interrupted may not have measured anything.
            let is_cut = block.trials == 0;
            self.entries[at].stability.join(block);
            self.entries[at].verdict = self.verdict(at, &self.entries[at].stability);
            if is_cut {
                return false;
            }
        }
    }

    /// The choice if no candidate is accepted: a finalist if the time is over, or else the
    /// candidate with the smallest portion of unsolved instances. One is added to both counts,
    /// because few instances say little.
    pub(super) fn least_bad(&self) -> Option<usize> {
        let portion = |at: usize| (self.unsolved(at) + 1) as f64 / (self.entries[at].stability.trials + 1) as f64;
        let by_portion = |&a: &usize, &b: &usize| {
            portion(a).total_cmp(&portion(b)).then(self.p99(a).total_cmp(&self.p99(b))).then(a.cmp(&b))
        };
        self.finalists().first().copied().or_else(|| (0..self.entries.len()).min_by(by_portion))
    }

    fn by_stability(&self, a: usize, b: usize) -> std::cmp::Ordering {
        let quantile = |at: usize, q: f64| self.entries[at].stability.quantile(q).unwrap_or(f64::INFINITY);
        let by_quantile = |q: f64| quantile(a, q).total_cmp(&quantile(b, q));
        self.unsolved(a).cmp(&self.unsolved(b)).then(by_quantile(0.99)).then(by_quantile(0.5)).then(a.cmp(&b))
    }

    /// The average predicted nanoseconds of a solve, second attempts included.
    fn expected_nanoseconds(&self, at: usize) -> f64 {
        expected_nanoseconds(&self.costs[at], &self.entries[at].stability)
    }

    /// The operations that take this time.
    fn expected_operations(&self, at: usize) -> f64 {
        let Cost { nanoseconds, operations, .. } = self.costs[at];
        operations as f64 * self.expected_nanoseconds(at) / nanoseconds.max(1) as f64
    }

    /// Sorts by the expected time. Candidates that are as fast as the fastest, as far as the model
    /// tells, come first, in the order of their rows and operations.
    fn sort_by_speed(&self, candidates: &mut [usize]) {
        let expected = |at: usize| self.expected_nanoseconds(at);
        let least = candidates.iter().map(|&at| expected(at)).fold(f64::INFINITY, f64::min);
        let is_fast = |at: usize| expected(at) <= EQUAL_COST * least;
        let rows = |at: usize| if is_fast(at) { self.costs[at].rows } else { usize::MAX };
        let cost = |at: usize| if is_fast(at) { self.expected_operations(at) } else { expected(at) };
        candidates.sort_by(|&a, &b| rows(a).cmp(&rows(b)).then(cost(a).total_cmp(&cost(b))).then(a.cmp(&b)));
    }

    fn p99(&self, at: usize) -> f64 {
        self.entries[at].stability.quantile(0.99).unwrap_or(f64::INFINITY)
    }

    fn unsolved(&self, at: usize) -> usize {
        self.entries[at].stability.incomplete + self.entries[at].stability.failures
    }
}
