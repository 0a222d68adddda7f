//! The support that a circle may have by chance (Desolneux, Moisan & Morel, "From Gestalt Theory to
//! Image Analysis", 2008).
//!
//! If the rays of an image are random, a silhouette has one of them within the threshold with the
//! probability
//!
//! ```text
//!   p = (sum of 2 t over all rays) / (sum of the images' angles between their outermost rays)
//! ```
//!
//! The distances of the nearest lines from the silhouettes of a circle have a likelihood ratio `R`
//! ([`ratio`](super::ratio)). Three lines match by construction, and the three nearest are left out
//! of it. The expected number of circles that are as good or better by chance is at most
//!
//! ```text
//!   false alarms = hypotheses / (hypotheses that make the same circle) * P(chance reaches R)
//! ```
//!
//! A silhouette that another cylinder hides does not count: a cylinder behind others has few
//! visible silhouettes, but nearly all of them match.

use std::sync::Arc;

use super::pair::Pair;
use super::plan::Plan;
use super::ratio::{ByChance, Nearest, Ratio, SCALES};

/// Largest expected number of hypotheses that are accepted by chance: the usual choice in the
/// literature.
pub(super) const FALSE_ALARMS: f64 = 1.0;

/// Lines are sparse if a silhouette has one of them within the threshold with less than this
/// probability.
const SPARSE: f64 = 0.35;

/// The distribution of ratios by chance is sampled again when the density of lines has fallen by
/// this factor: it changes slowly.
const NEARLY: f64 = 1.25;

/// Number of matches that a hypothesis has by construction.
const SAMPLE: usize = 3;

/// The matches that the remaining lines give by chance.
#[derive(Clone, Debug)]
pub(super) struct Chance {
    /// Number of silhouettes of a circle that no other circle hides.
    silhouettes: usize,
    hypotheses: usize,
    /// `p`; not between 0 and 1 if there are no lines, or no image has two of them.
    probability: f64,
    /// The distribution of ratios, at this probability or at a somewhat larger one.
    by_chance: Arc<ByChance>,
}

impl Chance {
    pub(super) fn of(plan: &Plan, pairs: &[Pair]) -> Self {
        Self::after(None, plan, pairs)
    }

    /// After lines were taken away.
    pub(super) fn updated(&self, plan: &Plan, pairs: &[Pair]) -> Self {
        Self::after(Some(&self.by_chance), plan, pairs)
    }

    fn after(before: Option<&Arc<ByChance>>, plan: &Plan, pairs: &[Pair]) -> Self {
        let views = plan.views();
        let free: Vec<_> = views.iter().map(|view| plan.free_lines(view)).collect();
        let covered: f64 = views.iter().zip(&free).map(|(view, &free)| 2.0 * view.threshold * free as f64).sum();
        let lines: usize = free.iter().sum();
        let hypotheses = |pair: &Pair| 2 * (lines - if pair.is_of_one_view() { free[pair.view()] } else { 2 });
        let silhouettes = 2 * views.iter().filter(|view| !view.lines.is_empty()).count();
        let probability = covered / views.iter().map(|view| view.span).sum::<f64>();
        let density = 0.5 * probability;
        let is_near = |before: &&Arc<ByChance>| before.density() <= NEARLY * density;
        let by_chance = before.filter(is_near).map_or_else(|| ByChance::new(density, silhouettes).into(), Arc::clone);
        Self {
            silhouettes,
            hypotheses: pairs.iter().filter(|pair| pair.is_free(plan)).map(hypotheses).sum(),
            probability,
            by_chance,
        }
    }

    /// The least number of matches within a part of the threshold that the hypotheses do not reach
    /// by chance; `None` if lines are not sparse, or chance can reach any number.
    pub(super) fn least_support(&self, part: f64) -> Option<usize> {
        let probability = part * self.probability;
        let sparse = probability > 0.0 && probability < SPARSE;
        let trials = self.silhouettes.saturating_sub(SAMPLE);
        let is_more =
            |successes: &usize| self.hypotheses as f64 * tail(trials, *successes, probability) <= FALSE_ALARMS;
        (0..=trials).find(is_more).filter(|_| sparse).map(|successes| successes + SAMPLE)
    }

    /// Expected number of hypotheses whose matches are by chance as near as these, and the scale of
    /// the noise. The density of lines counts as at least that of all lines. `silhouettes` is the
    /// number of silhouettes that are not hidden.
    pub(super) fn false_alarms(&self, mut nearest: Vec<Nearest>, silhouettes: usize) -> FalseAlarms {
        let hypotheses = (self.hypotheses.max(1) as f64).ln();
        let density = 0.5 * self.probability;
        if !(density > 0.0 && density.is_finite()) {
            return FalseAlarms { logarithm: hypotheses, scale: SCALES[0] };
        }
        nearest.iter_mut().for_each(|line| line.density = line.density.max(density));
        nearest.sort_unstable_by(|one, other| one.distance.total_cmp(&other.distance));
        let trials = silhouettes.saturating_sub(SAMPLE);
        let Ratio { logarithm, scale } = Ratio::of(nearest.get(SAMPLE..).unwrap_or_default(), trials);
        FalseAlarms { logarithm: hypotheses + self.by_chance.logarithm(logarithm, trials), scale }
    }
}

/// Expected number of sets of cylinders as good by chance, from the false alarms of each, which
/// bound its probability by chance. The product `e` of `k` such numbers is as small by chance with
/// a probability of at most
///
/// ```text
///   e (1 + x + x^2 / 2! + ... + x^(k-1) / (k-1)!),    x = -ln e
/// ```
///
/// (Fisher, "Statistical Methods for Research Workers", 1932). One for none.
pub(super) fn joint_false_alarms(of_each: &[f64]) -> f64 {
    let x: f64 = of_each.iter().map(|alone| -alone.clamp(f64::MIN_POSITIVE, 1.0).ln()).sum();
    // The first terms may be less than the smallest number, so their logarithms are computed.
    let mut logarithm = -x;
    let terms = (1..=of_each.len()).map(|next| {
        let term = logarithm.exp();
        logarithm += (x / next as f64).ln();
        term
    });
    if of_each.is_empty() { 1.0 } else { terms.sum() }
}

/// How much a circle stands out from chance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FalseAlarms {
    /// Natural logarithm of the expected number of circles as good by chance.
    pub(super) logarithm: f64,
    /// Most likely standard deviation of the distances, in thresholds.
    pub(super) scale: f64,
}

/// Probability of at least `successes` successes in `trials` trials.
pub(crate) fn tail(trials: usize, successes: usize, probability: f64) -> f64 {
    // Without lines, or if no image has two of them, nothing is known.
    let probability = if probability.is_nan() { 1.0 } else { probability.clamp(f64::MIN_POSITIVE, 1.0) };
    // The smallest terms are added first.
    (successes..=trials).rev().map(|successes| binomial(trials, successes, probability)).sum()
}

/// Probability of exactly `successes` successes in `trials` trials.
fn binomial(trials: usize, successes: usize, probability: f64) -> f64 {
    let failures = trials - successes;
    if failures > 0 && probability >= 1.0 {
        return 0.0;
    }
    let choices: f64 = (0..successes).map(|index| ((trials - index) as f64 / (index + 1) as f64).ln()).sum();
    let all_others = if failures > 0 { failures as f64 * (-probability).ln_1p() } else { 0.0 };
    (choices + successes as f64 * probability.ln() + all_others).exp()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chance() -> Chance {
        let by_chance = ByChance::new(0.05, 24).into();
        Chance { silhouettes: 24, hypotheses: 1000, probability: 0.1, by_chance }
    }

    /// Lines at these distances, no denser than elsewhere.
    fn lines(distances: impl IntoIterator<Item = f64>) -> Vec<Nearest> {
        distances.into_iter().map(|distance| Nearest { distance, density: 0.0 }).collect()
    }

    #[test]
    fn probabilities_are_those_of_coins_and_sum_to_one() {
        for (successes, expected) in [1.0, 4.0, 6.0, 4.0, 1.0].into_iter().enumerate() {
            assert!((binomial(4, successes, 0.5) - expected / 16.0).abs() < 1e-15);
        }
        assert!((tail(4, 3, 0.5) - 5.0 / 16.0).abs() < 1e-15);
        assert!((tail(97, 0, 0.23) - 1.0).abs() < 1e-12);
        for (tail, expected) in [(tail(5, 5, 1.0), 1.0), (tail(5, 0, 0.0), 1.0), (tail(5, 6, 0.5), 0.0)] {
            assert!((tail - expected).abs() < 1e-14, "{tail} {expected}");
        }
    }

    #[test]
    fn a_circle_is_the_less_by_chance_the_more_of_its_visible_silhouettes_match_and_the_nearer() {
        let chance = chance();
        let of = |distances: Vec<f64>, silhouettes| chance.false_alarms(lines(distances), silhouettes).logarithm;
        let near = |matches: usize, distance: f64, silhouettes| of(vec![distance; matches], silhouettes);
        assert!(near(9, 0.5, 24) < near(8, 0.5, 24));
        assert!(near(8, 0.25, 24) < near(8, 0.5, 24));
        assert!(near(8, 0.5, 10) < near(8, 0.5, 24));
        // A line that is far away adds next to nothing to six that are near.
        let with_far = of(vec![0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 1.0], 24);
        assert!((with_far - near(6, 0.1, 24)).abs() < 0.05, "{with_far}");
        // So does one among many others.
        let crowded = |density: f64| {
            let mut lines = lines([0.1; 8]);
            lines.iter_mut().for_each(|line| line.density = density);
            chance.false_alarms(lines, 24).logarithm
        };
        assert!(crowded(0.5) > crowded(0.1) && crowded(0.1) > crowded(0.05) && crowded(0.05) == crowded(0.01));
        // Three lines say nothing.
        assert!(near(3, 0.0, 24) == 1000.0_f64.ln() && near(3, 0.0, 3) == 1000.0_f64.ln());
        let unknown = Chance { probability: f64::NAN, ..chance };
        assert_eq!(unknown.false_alarms(lines([0.1; 6]), 24).logarithm, 1000.0_f64.ln());
    }

    /// Pairs of even random numbers have a product of at most `e` with the probability
    /// `e (1 - ln e)`.
    #[test]
    fn false_alarms_of_several_cylinders_are_those_of_their_product() {
        assert_eq!(joint_false_alarms(&[]), 1.0);
        for alone in [1e-300_f64, 1e-4, 0.3, 1.0, 7.0] {
            assert!((joint_false_alarms(&[alone]) / alone.min(1.0) - 1.0).abs() < 1e-12);
        }
        assert!((joint_false_alarms(&[0.1, 0.02]) - 0.002 * (1.0 - 0.002_f64.ln())).abs() < 1e-15);
        assert_eq!(joint_false_alarms(&[1.0; 5]), 1.0);
        assert_eq!(joint_false_alarms(&[1e-200; 9]), 0.0);
        // Cylinders that chance gives once make the others no better.
        assert!(joint_false_alarms(&[1e-3, 1.0, 1.0]) > 1e-3 && joint_false_alarms(&[0.01; 5]) < 1e-4);
    }

    #[test]
    fn the_scale_is_that_of_the_distances() {
        let chance = chance();
        for scale in SCALES {
            // Quantiles of the normal distribution.
            let distances = [0.03, 0.1, 0.16, 0.23, 0.3, 0.37, 0.45, 0.53, 0.62, 0.73, 0.86, 1.02, 1.24, 1.6];
            let found = chance.false_alarms(lines(distances.map(|quantile| quantile * scale)), 20).scale;
            assert!((found / scale).ln().abs() < 0.5, "{found} {scale}");
        }
    }
}
