//! The numbers of the rule by which a template is chosen; [`super`] states the rule.

use crate::search::measuring::Stability;
use crate::search::preference::Cost;

/// Candidates that are screened in any case.
pub const SCREENED: usize = 8;
/// No more candidates than this are screened.
pub const SCREENED_AT_MOST: usize = 32;
/// One instance in this many may lack a solution.
pub const INCOMPLETE_ONE_IN: usize = 1000;
/// A candidate is rejected early only if chance explains its incomplete instances with a
/// probability below this.
pub const SIGNIFICANCE: f64 = 0.01;
/// A 99 % quantile of the log10 relative residual that is good enough.
pub const GOOD_RESIDUAL: f64 = -12.0;
/// Limit on the cost of stability, as a factor of the predicted time.
pub const STABILITY_COST: f64 = 2.0;
/// Candidates whose predicted times differ by no more than this factor cost the same for the
/// choice.
pub const SIMILAR_COST: f64 = 1.1;
/// Candidates within this factor of the least predicted time are equally fast, as far as the model
/// tells, which is off by such a factor in the median. Fewer rows then take less memory and less
/// code. It also keeps a difference of one chain from deciding: a determinant of fewer chains is a
/// little faster, but no more than one solution per chain can have the same value of the action
/// monomial, and on symmetric data more of them do.
pub const EQUAL_COST: f64 = 1.1;
/// Candidates that are confirmed besides the first accepted one.
pub const OTHERS_CONFIRMED: usize = 2;
/// Operations that screening one candidate may take, without the polish. If a solve takes so many
/// that this binds, fewer instances are drawn.
pub const SCREENING_WORK: usize = 300_000_000;
/// Operations that confirming one candidate may take, without the polish.
pub const CONFIRMING_WORK: usize = 10_000_000_000;
/// Operations that screening one candidate may take even if that is fewer than `BLOCK` instances:
/// a template by the trace of a Gröbner basis may have thousands of rows.
pub const MOST_SCREENING_WORK: usize = 100_000_000_000;
/// Operations that confirming one candidate may take even if that is fewer than
/// [`INCOMPLETE_ONE_IN`] instances.
pub const MOST_CONFIRMING_WORK: usize = 1_000_000_000_000;
/// Operations after which the search asks whether the time is over.
pub(super) const BLOCK_WORK: usize = 10_000_000_000;
/// Operations, second attempts included, after which no further candidate is confirmed and no more
/// than [`SCREENED`] are screened. A few candidates that are rejected late take that many.
pub const MEASURING_WORK: f64 = 1e11;
/// Instances that are measured at once; after each block the candidate may be rejected.
pub(super) const BLOCK: usize = 100;

/// How much is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Measuring {
    /// Instances on which candidates are screened.
    pub trials: usize,
    /// Instances on which the chosen candidate must hold; no fewer than `trials` are used.
    pub confirm: usize,
    /// Seed of the instances.
    pub seed: u64,
}

/// What the measurement of a candidate says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Not rejected on the instances so far.
    Screened,
    /// Confirmed.
    Accepted,
    /// The candidate fails, or lacks solutions on too many instances.
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

/// The average predicted nanoseconds of a solve, second attempts included: as many as scenes need,
/// where they are known, since they are like the data of users.
pub fn expected_nanoseconds(cost: &Cost, stability: &Stability) -> f64 {
    let (repeated, of) = match stability.scenes {
        0 => (stability.repeated, stability.trials),
        scenes => (stability.scenes_repeated, scenes),
    };
    let repeated = repeated as f64 / of.max(1) as f64;
    cost.nanoseconds as f64 + cost.second_attempt as f64 * repeated
}

/// Whether a candidate fails, lacks a solution on more instances than `confirm` instances may, or
/// on more than chance explains.
pub(super) fn is_rejected(stability: &Stability, confirm: usize) -> bool {
    let Stability { trials, incomplete, failures, .. } = *stability;
    failures > 0
        || incomplete * INCOMPLETE_ONE_IN > confirm
        || at_least(incomplete, trials as f64 / INCOMPLETE_ONE_IN as f64) < SIGNIFICANCE
}

/// The probability that a Poisson variable of this mean is at least `count`.
pub(super) fn at_least(count: usize, mean: f64) -> f64 {
    let (mut below, mut term) = (0.0, (-mean).exp());
    for k in 0..count {
        below += term;
        term *= mean / (k + 1) as f64;
    }
    1.0 - below
}
