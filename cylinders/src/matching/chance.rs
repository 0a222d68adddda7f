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
//! Each line is near a given silhouette by chance with the density `lambda = p / 2`, in units of
//! the threshold. If a silhouette is detected with the probability `pi`, and its line is off by
//! normal noise of the scale `s`, then the likelihood ratio of a silhouette whose nearest line is
//! at the distance `d`, and of one without a line, is at most
//!
//! ```text
//!   1 - pi + pi N(d; s) / lambda,     1 - pi
//! ```
//!
//! whose mean over random lines is at most 1. So is that of their product over the silhouettes, and
//! of its mean `R` over several `s` and `pi`: both are unknown, and are marginalised over as the
//! scale is by Barath, Noskova, Ivashechkin & Matas, "MAGSAC++", 2020. By Markov's inequality
//! chance reaches `R` with a probability of `1 / R` at most. Three lines match by construction, and
//! the three nearest are left out of the product. The expected number of circles that are as good
//! or better by chance is at most
//!
//! ```text
//!   false alarms = hypotheses / (hypotheses that make the same circle) / R
//! ```
//!
//! A silhouette that another cylinder hides does not count: a cylinder behind others has few
//! visible silhouettes, but nearly all of them match.

use std::f64::consts::{FRAC_1_SQRT_2, TAU};

use super::pair::Pair;
use super::plan::Plan;

/// Largest expected number of hypotheses that are accepted by chance: the usual choice in the
/// literature.
pub(super) const FALSE_ALARMS: f64 = 1.0;

/// Standard deviations of the distances between lines and silhouettes, in thresholds: three of them
/// are a threshold, or less in equal ratios. All are equally likely beforehand.
pub(super) const SCALES: [f64; 8] = [
    1.0 / 3.0,
    FRAC_1_SQRT_2 / 3.0,
    1.0 / 6.0,
    FRAC_1_SQRT_2 / 6.0,
    1.0 / 12.0,
    FRAC_1_SQRT_2 / 12.0,
    1.0 / 24.0,
    FRAC_1_SQRT_2 / 24.0,
];

/// Parts of the silhouettes that are detected. All are equally likely beforehand.
const DETECTIONS: [f64; 4] = [0.3, 0.5, 0.7, 0.9];

/// Lines are sparse if a silhouette has one of them within the threshold with less than this
/// probability.
const SPARSE: f64 = 0.35;

/// Number of matches that a hypothesis has by construction.
const SAMPLE: usize = 3;

/// The matches that the remaining lines give by chance.
#[derive(Clone, Copy, Debug)]
pub(super) struct Chance {
    /// Number of silhouettes of a circle that no other circle hides.
    silhouettes: usize,
    hypotheses: usize,
    /// `p`; not between 0 and 1 if there are no lines, or no image has two of them.
    probability: f64,
}

impl Chance {
    pub(super) fn of(plan: &Plan, pairs: &[Pair]) -> Self {
        let views = plan.views();
        let free: Vec<_> = views.iter().map(|view| plan.free_lines(view)).collect();
        let covered: f64 = views.iter().zip(&free).map(|(view, &free)| 2.0 * view.threshold * free as f64).sum();
        let lines: usize = free.iter().sum();
        let hypotheses = |pair: &Pair| 2 * (lines - if pair.is_of_one_view() { free[pair.view()] } else { 2 });
        Self {
            silhouettes: 2 * views.iter().filter(|view| !view.lines.is_empty()).count(),
            hypotheses: pairs.iter().filter(|pair| pair.is_free(plan)).map(hypotheses).sum(),
            probability: covered / views.iter().map(|view| view.span).sum::<f64>(),
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

    /// Expected number of hypotheses whose matches are by chance as near as these `distances`, in
    /// units of the threshold, and the scale of the noise. `silhouettes` is the number of
    /// silhouettes that are not hidden.
    pub(super) fn false_alarms(&self, mut distances: Vec<f64>, silhouettes: usize) -> FalseAlarms {
        distances.sort_unstable_by(f64::total_cmp);
        let trials = silhouettes.saturating_sub(SAMPLE);
        let beyond = distances.get(SAMPLE..).unwrap_or_default();
        let hypotheses = (self.hypotheses.max(1) as f64).ln();
        let density = 0.5 * self.probability;
        if !(density > 0.0 && density.is_finite()) {
            return FalseAlarms { logarithm: hypotheses, scale: SCALES[0] };
        }
        let mut best = (f64::NEG_INFINITY, SCALES[0]);
        let mut ratios = Vec::with_capacity(SCALES.len());
        for scale in SCALES {
            let of_detection = DETECTIONS.map(|detection| ratio(beyond, trials, density, scale, detection));
            let mean = mean_of_exponentials(&of_detection);
            ratios.push(mean);
            if mean > best.0 {
                best = (mean, scale);
            }
        }
        FalseAlarms { logarithm: hypotheses - mean_of_exponentials(&ratios), scale: best.1 }
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

/// Logarithm of the likelihood ratio of `trials` silhouettes of which some have lines at these
/// distances.
fn ratio(distances: &[f64], trials: usize, density: f64, scale: f64, detection: f64) -> f64 {
    let most = detection / (density * scale * TAU.sqrt());
    let missing = 1.0 - detection;
    let matched: f64 = distances.iter().map(|d| (missing + most * (-0.5 * (d / scale).powi(2)).exp()).ln()).sum();
    matched + trials.saturating_sub(distances.len()) as f64 * missing.ln()
}

/// `ln(mean(exp(x)))`.
fn mean_of_exponentials(logarithms: &[f64]) -> f64 {
    let most = logarithms.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let sum: f64 = logarithms.iter().map(|logarithm| (logarithm - most).exp()).sum();
    most + (sum / logarithms.len() as f64).ln()
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
        let chance = Chance { silhouettes: 24, hypotheses: 1000, probability: 0.1 };
        let of = |distances: Vec<f64>, silhouettes| chance.false_alarms(distances, silhouettes).logarithm;
        let near = |matches: usize, distance: f64, silhouettes| of(vec![distance; matches], silhouettes);
        assert!(near(9, 0.5, 24) < near(8, 0.5, 24));
        assert!(near(8, 0.25, 24) < near(8, 0.5, 24));
        assert!(near(8, 0.5, 10) < near(8, 0.5, 24));
        // A line that is far away adds next to nothing to six that are near.
        let with_far = of(vec![0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 1.0], 24);
        assert!((with_far - near(6, 0.1, 24)).abs() < 0.05, "{with_far}");
        // Three lines say nothing.
        assert!(near(3, 0.0, 24) > 1000.0_f64.ln() && near(3, 0.0, 3) == 1000.0_f64.ln());
        let unknown = Chance { probability: f64::NAN, ..chance };
        assert_eq!(unknown.false_alarms(vec![0.1; 6], 24).logarithm, 1000.0_f64.ln());
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

    /// The mean over random lines of the ratio by which a circle stands out is at most one, so that
    /// chance is never underestimated.
    #[test]
    fn the_mean_ratio_of_random_lines_is_at_most_one() {
        let mut random = 1_u64;
        let mut uniform = || {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (random >> 11) as f64 / (1_u64 << 53) as f64
        };
        for (density, scale, detection) in [(0.05, 1.0 / 3.0, 0.5), (0.5, 1.0 / 6.0, 0.9), (2.0, 1.0 / 12.0, 0.3)] {
            let (mut sum, runs) = (0.0, 200_000);
            for _ in 0..runs {
                // The nearest line on either side of each of four silhouettes: distances are
                // exponential at twice the density.
                let nearest = (0..4).map(|_| -(1.0 - uniform()).ln() / (2.0 * density)).filter(|d| *d <= 1.0);
                sum += ratio(&nearest.collect::<Vec<_>>(), 4, density, scale, detection).exp();
            }
            let mean = sum / f64::from(runs);
            assert!(mean < 1.03, "{density} {scale} {detection}: {mean}");
        }
    }

    #[test]
    fn the_scale_is_that_of_the_distances() {
        let chance = Chance { silhouettes: 24, hypotheses: 1000, probability: 0.1 };
        for scale in SCALES {
            // Quantiles of the normal distribution.
            let distances = [0.03, 0.1, 0.16, 0.23, 0.3, 0.37, 0.45, 0.53, 0.62, 0.73, 0.86, 1.02, 1.24, 1.6];
            let distances: Vec<_> = distances.map(|quantile| quantile * scale).into();
            let found = chance.false_alarms(distances, 20).scale;
            assert!((found / scale).ln().abs() < 0.5, "{found} {scale}");
        }
    }
}
