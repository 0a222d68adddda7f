//! Chooses among the templates that a search found, by their cost and by what they do on random
//! real instances.
//!
//! # The rule
//! Candidates are considered in the order of the preference ([`Preference::key`]):
//! - *speed*: the least predicted time of a solve first ([`crate::plan::time`]);
//! - *size*: fewest rows first, whatever they cost;
//! - *stability*: the least predicted time first, up to [`STABILITY_COST`] times that of the first
//!   one that is not rejected.
//!
//! Of each combination of presolved form, action monomial and basis only the first candidate is
//! considered.
//!
//! 1. *Screening.* [`SCREENED`] candidates are measured on [`Measuring::trials`] instances. A
//!    candidate is *rejected* if an instance fails, or if more instances lack a solution than a
//!    rate of one in [`INCOMPLETE_ONE_IN`] would explain with a probability of [`SIGNIFICANCE`]. It
//!    is *precise* if the 99 % quantile of its log10 relative residual is at most
//!    [`GOOD_RESIDUAL`], or at most 1 above the best of the candidates that are not rejected.
//! 2. *Confirmation.* Precise candidates that are not rejected are the *finalists*. They are
//!    measured on [`Measuring::confirm`] instances one after another, each only until it is
//!    rejected. The order is that of the preference, with two exceptions. For *speed*, the time
//!    of second attempts is added, as many as scenes take, if there are any: users have data like
//!    them, and they may take forty times as many as random numbers. Of those that take at most
//!    [`EQUAL_COST`] times the least the one with fewest rows comes first, then the one with fewest
//!    operations. For *stability*, the order is fewest unsolved instances, then smallest 99 %
//!    quantile, then smallest median.
//!    The first finalist that lasts and lacks a solution on at most one instance in
//!    [`INCOMPLETE_ONE_IN`] is *accepted*. If none is, further candidates are screened, up to
//!    [`SCREENED_AT_MOST`] and until all measurements together take [`MEASURING_WORK`].
//! 3. *Choice.* If the accepted candidate solves every instance it is chosen. There are two
//!    exceptions: *stability* always looks at others, and *speed* does if second attempts turn out
//!    to make the accepted candidate dearer than another; the cheapest of the others then comes
//!    first. Up to [`OTHERS_CONFIRMED`] others of similar cost are confirmed too, and the accepted
//!    candidate with the fewest unsolved instances is chosen. Similar cost means for *speed* times
//!    within [`SIMILAR_COST`], second attempts included, for *size* as many rows, for *stability*
//!    any.
//!
//! If the problem has a scene that says what solves it, a scene is solved with every instance,
//! which lacks a solution, too, if that of the scene is not among the real ones that are returned.
//!
//! Large templates are measured on fewer instances: as many as [`SCREENING_WORK`] and
//! [`CONFIRMING_WORK`] allow, but at least [`INCOMPLETE_ONE_IN`] for a confirmation, unless that
//! takes more than [`MOST_CONFIRMING_WORK`]. A problem
//! without data has one instance.
//!
//! If no candidate is accepted, the one with the smallest portion of unsolved instances is chosen,
//! and the choice says so.

mod rule;
mod tournament;

#[cfg(test)]
mod tests;

use std::ops::Range;

use crate::search::candidate::TemplateCandidate;
use crate::search::measuring::{Stability, measure};
use crate::search::monitor::{Monitor, Stage};
use crate::search::preference::{Cost, Preference};
pub use rule::*;
use tournament::{Entry, Tournament};

/// A candidate with what it does on random real instances.
#[derive(Clone, Debug)]
pub struct Measured {
    /// The candidate.
    pub candidate: TemplateCandidate,
    /// Its measurement.
    pub stability: Stability,
    /// What the measurement says.
    pub verdict: Verdict,
}

/// The candidates that were measured, in the order of the preference, and the one to use.
#[derive(Clone, Debug)]
pub struct Choice {
    /// The measured candidates, at least one.
    pub measured: Vec<Measured>,
    /// Index into `measured`.
    pub chosen: usize,
    /// Number of different candidates that were not measured.
    pub unmeasured: usize,
    /// Whether the monitor ended the measurements.
    pub is_cut: bool,
}

impl Choice {
    /// Whether the chosen candidate passed its measurements.
    pub fn solves_well(&self) -> bool {
        self.measured[self.chosen].verdict != Verdict::Rejected
    }
}

/// Measures candidates and chooses one by the rule at the top of this module; `None` if there is no
/// candidate.
///
/// `candidates` are in the order of the preference. `known` returns measurements on the first
/// instances that [`screen`] made with the same `measuring`.
pub fn choose(
    candidates: &[TemplateCandidate],
    preference: Preference,
    measuring: Measuring,
    known: &dyn Fn(&TemplateCandidate) -> Option<Stability>,
    monitor: &dyn Monitor,
) -> Option<Choice> {
    let different = different(candidates);
    let known = |at: usize| known(different[at]);
    let rule = Rule { preference, measuring };
    let (chosen, entries) = in_tournament(&different, rule, &known, monitor, |tournament| {
        tournament.accept().or_else(|| tournament.least_bad())
    });
    let chosen = chosen?;
    let is_cut = monitor.is_over(Stage::Measuring) && entries[chosen].verdict != Verdict::Accepted;
    let unmeasured = different.len() - entries.len();
    let with = |(entry, candidate): (Entry, &&TemplateCandidate)| Measured {
        candidate: (*candidate).clone(),
        stability: entry.stability,
        verdict: entry.verdict,
    };
    Some(Choice { measured: entries.into_iter().zip(&different).map(with).collect(), chosen, unmeasured, is_cut })
}

/// Most candidates that a shard of a search hands over: more than are ever screened.
pub const HANDED_OVER: usize = 2 * SCREENED_AT_MOST;

/// The candidates of a shard that may be chosen when those of other shards join, in the order of
/// the preference. Those that are screened come with their measurement.
pub fn screen<'a>(
    candidates: &'a [TemplateCandidate],
    preference: Preference,
    measuring: Measuring,
    monitor: &dyn Monitor,
) -> Vec<(&'a TemplateCandidate, Option<Stability>)> {
    let mut different = different(candidates);
    different.truncate(HANDED_OVER);
    let rule = Rule { preference, measuring };
    let ((), entries) = in_tournament(&different, rule, &|_| None, monitor, |tournament| {
        tournament.screen();
    });
    let measured = entries.into_iter().map(|entry| Some(entry.stability)).chain(std::iter::repeat(None));
    different.into_iter().zip(measured).collect()
}

/// What is preferred, and how much is measured.
#[derive(Clone, Copy)]
struct Rule {
    preference: Preference,
    measuring: Measuring,
}

/// Decides in a tournament of real candidates. Returns the decision and the measurements.
fn in_tournament<R>(
    candidates: &[&TemplateCandidate],
    rule: Rule,
    known: &dyn Fn(usize) -> Option<Stability>,
    monitor: &dyn Monitor,
    decide: impl FnOnce(&mut Tournament<'_>) -> R,
) -> (R, Vec<Entry>) {
    let Rule { preference, measuring } = rule;
    let costs: Vec<Cost> = candidates.iter().map(|candidate| candidate.cost()).collect();
    let measure = |at: usize, instances: Range<usize>| {
        let t = &candidates[at].template;
        let (rows, columns) = (t.rows(), t.columns());
        monitor.say(&format!("measuring template {} ({rows} x {columns}) on {} instances", at + 1, instances.end));
        measure(&candidates[at].plan, instances, measuring.seed, monitor.interruption())
    };
    let has_data = candidates.iter().any(|candidate| !candidate.plan.data.is_empty());
    let measuring = if has_data { measuring } else { Measuring { trials: 1, confirm: 1, ..measuring } };
    let entries = Vec::new();
    let mut tournament =
        Tournament { costs: &costs, preference, measuring, known, measure: &measure, monitor, entries };
    let decision = decide(&mut tournament);
    (decision, tournament.entries)
}

/// The first candidate of each combination of presolved form, action monomial and basis. The others
/// have the same action matrix and cost more.
fn different(candidates: &[TemplateCandidate]) -> Vec<&TemplateCandidate> {
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
