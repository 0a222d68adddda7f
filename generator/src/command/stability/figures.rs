//! The figures of many instances.

use serde::Serialize;

use super::outcome::{Count, Outcome};

/// The first edge of the histogram, as log10 of a residual.
pub(super) const FIRST: f64 = -18.0;
/// The width of its bins.
pub(super) const WIDTH: f64 = 0.5;
/// The number of its bins. The first and the last hold what lies beyond, too.
pub(super) const BINS: usize = 36;

/// What a solver did on the instances of one family and level.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Row {
    pub(super) problem: String,
    pub(super) family: String,
    /// What the level means depends on the family: a power of ten as a rule.
    pub(super) level: Option<f64>,
    pub(super) instances: usize,
    /// Instances on which `solve` or `solve_complex` returned an error.
    pub(super) failed: usize,
    /// Instances that lack a solution, or on which a solver failed.
    pub(super) incomplete: usize,
    /// Instances on which a point was returned that is no solution.
    pub(super) wrong: usize,
    /// Instances of which the oracle does not know the number of solutions for certain.
    pub(super) uncertain: usize,
    /// Sums over the instances, of `solve`.
    pub(super) real: Count,
    /// The same of `solve_complex`.
    pub(super) complex: Count,
    /// Solutions that the instances came with, and how many of them were not returned.
    pub(super) known: usize,
    pub(super) known_missed: usize,
    /// Instances on which `solve`, and `solve_complex`, made a second attempt.
    pub(super) repeated: usize,
    pub(super) repeated_complex: usize,
    /// log10 of the largest relative residual of each instance.
    pub(super) residual: Quantiles,
    /// log10 of the largest relative forward error of each instance.
    pub(super) forward_error: Quantiles,
    /// Nanoseconds of `solve`, of emitted code.
    pub(super) nanoseconds: Quantiles,
    /// log10 of the growth of pivots.
    pub(super) growth: Quantiles,
    /// log10 of the inverse of the separation of eigenvalues.
    pub(super) closeness: Quantiles,
    /// How many complex solutions have a log10 of their residual in each bin of half a power of
    /// ten, from -18 on.
    pub(super) histogram: Vec<usize>,
}

/// Quantiles; `null` if there is no value.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub(super) struct Quantiles {
    pub(super) median: Option<f64>,
    pub(super) p99: Option<f64>,
    pub(super) max: Option<f64>,
}

/// Values in increasing order.
pub(super) fn sorted(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.filter(|value| !value.is_nan()).collect();
    values.sort_by(f64::total_cmp);
    values
}

/// log10 to three decimals, with exact zeros at the level of rounding, so that they count as good
/// and not as -infinity.
pub(super) fn log10(value: f64) -> f64 {
    (1000.0 * value.max(1e-18).log10()).round() / 1000.0
}

impl Quantiles {
    fn of(values: &[f64]) -> Self {
        let at = |q: f64| values.len().checked_sub(1).map(|last| values[(q * last as f64).round() as usize]);
        Self { median: at(0.5), p99: at(0.99), max: at(1.0) }
    }
}

/// log10 of the largest residuals of instances, in increasing order.
pub(super) fn residuals(outcomes: &[&Outcome]) -> Vec<f64> {
    sorted(outcomes.iter().filter_map(|outcome| outcome.residual).map(log10))
}

/// log10 of the largest forward errors of instances, in increasing order.
pub(super) fn forward_errors(outcomes: &[&Outcome]) -> Vec<f64> {
    sorted(outcomes.iter().filter_map(|outcome| outcome.forward_error).map(log10))
}

/// Whether an instance lacks a solution.
pub(super) fn is_incomplete(outcome: &Outcome) -> bool {
    outcome.error.is_some() || outcome.missed() + outcome.known_missed > 0
}

/// Whether a point was returned that is no solution.
pub(super) fn is_wrong(outcome: &Outcome) -> bool {
    outcome.real.spurious + outcome.complex.spurious > 0
}

impl Row {
    /// The figures of some instances of one problem, family and level.
    pub(super) fn of(name: (&str, &str, Option<f64>), outcomes: &[&Outcome]) -> Self {
        let count = |is: &dyn Fn(&Outcome) -> bool| outcomes.iter().filter(|outcome| is(outcome)).count();
        let sum = |part: &dyn Fn(&Outcome) -> usize| outcomes.iter().map(|outcome| part(outcome)).sum::<usize>();
        let total = |of: &dyn Fn(&Outcome) -> Count| Count {
            expected: sum(&|outcome| of(outcome).expected),
            missed: sum(&|outcome| of(outcome).missed),
            spurious: sum(&|outcome| of(outcome).spurious),
        };
        let quantiles = |value: &dyn Fn(&Outcome) -> Option<f64>| {
            Quantiles::of(&sorted(outcomes.iter().filter_map(|outcome| value(outcome))))
        };
        let (problem, family, level) = name;
        Self {
            problem: problem.to_owned(),
            family: family.to_owned(),
            level,
            instances: outcomes.len(),
            failed: count(&|outcome| outcome.error.is_some()),
            incomplete: count(&is_incomplete),
            wrong: count(&is_wrong),
            uncertain: count(&|outcome| !outcome.is_certain),
            real: total(&|outcome| outcome.real),
            complex: total(&|outcome| outcome.complex),
            known: sum(&|outcome| outcome.known),
            known_missed: sum(&|outcome| outcome.known_missed),
            repeated: count(&|outcome| outcome.is_repeated),
            repeated_complex: count(&|outcome| outcome.is_repeated_complex),
            residual: Quantiles::of(&residuals(outcomes)),
            forward_error: Quantiles::of(&forward_errors(outcomes)),
            nanoseconds: quantiles(&|outcome| outcome.nanoseconds),
            growth: quantiles(&|outcome| outcome.growth.map(log10)),
            closeness: quantiles(&|outcome| outcome.separation.map(|separation| -log10(separation))),
            histogram: histogram(outcomes),
        }
    }
}

fn histogram(outcomes: &[&Outcome]) -> Vec<usize> {
    let mut bins = vec![0; BINS];
    for residual in outcomes.iter().flat_map(|outcome| &outcome.residuals) {
        let bin = ((log10(*residual) - FIRST) / WIDTH).clamp(0.0, (BINS - 1) as f64);
        bins[bin as usize] += 1;
    }
    bins
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn residuals_are_counted_in_their_bins() {
        let outcome = Outcome { residuals: vec![0.0, 2e-16, 1e-15, 3.0], ..Outcome::default() };
        let bins = histogram(&[&outcome]);
        // log10 of 2e-16 is -15.7.
        assert_eq!((bins[0], bins[4], bins[6], bins[BINS - 1]), (1, 1, 1, 1));
        assert_eq!(bins.iter().sum::<usize>(), 4);
    }

    #[test]
    fn quantiles_are_by_nearest_rank() {
        let values: Vec<f64> = (0..101).map(f64::from).collect();
        assert_eq!(Quantiles::of(&values), Quantiles { median: Some(50.0), p99: Some(99.0), max: Some(100.0) });
        assert_eq!(Quantiles::of(&[]), Quantiles::default());
    }
}
