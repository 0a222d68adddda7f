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
//! and within a part `q` of the threshold with the probability `q p`. A hypothesis matches three
//! lines by construction. Let there be `n` silhouettes, and let the `k`-th nearest match be `q_k`
//! thresholds away. The expected number of hypotheses that are as good or better by chance is at
//! most
//!
//! ```text
//!   false alarms = hypotheses * (n - 3) * min over k of P(B >= k - 3)
//! ```
//!
//! where `B` is binomial with `n - 3` trials of probability `q_k p`, and the factor `n - 3`
//! accounts for the choice of `k` (Moisan & Stival, "A Probabilistic Criterion to Detect Rigid
//! Point Matches between Two Images", 2004). A silhouette that another cylinder hides does not
//! count as a trial: a cylinder behind others has few visible silhouettes, but nearly all of them
//! match.

use super::pair::Pair;
use super::plan::Plan;

/// Largest expected number of hypotheses that are accepted by chance: the usual choice in the
/// literature.
pub(super) const FALSE_ALARMS: f64 = 1.0;

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
        let of_pair = |pair: &Pair| 2 * (lines - free[pair.view()]);
        Self {
            silhouettes: 2 * views.iter().filter(|view| !view.lines.is_empty()).count(),
            hypotheses: pairs.iter().filter(|pair| pair.is_free(plan)).map(of_pair).sum(),
            probability: covered / views.iter().map(|view| view.span).sum::<f64>(),
        }
    }

    /// The least number of matches that the hypotheses do not reach by chance. It exceeds the
    /// number of silhouettes if chance can reach any number.
    pub(super) fn least_support(&self) -> usize {
        let sparse = self.probability > 0.0 && self.probability < 1.0;
        if !sparse {
            return self.silhouettes + 1;
        }
        let trials = self.silhouettes - SAMPLE;
        let is_more =
            |successes: &usize| self.hypotheses as f64 * tail(trials, *successes, self.probability) <= FALSE_ALARMS;
        (0..=trials).find(is_more).unwrap_or(trials + 1) + SAMPLE
    }

    /// Expected number of hypotheses whose matches are by chance as near as these `distances`, in
    /// units of the threshold. `silhouettes` is the number of silhouettes that are not hidden.
    /// If fewer lines match than decide, all hypotheses are as good.
    pub(super) fn false_alarms(&self, mut distances: Vec<f64>, silhouettes: usize) -> f64 {
        let trials = silhouettes.saturating_sub(SAMPLE);
        distances.sort_unstable_by(f64::total_cmp);
        let beyond = distances.iter().enumerate().skip(SAMPLE);
        let tails = beyond.map(|(matches, distance)| tail(trials, matches + 1 - SAMPLE, distance * self.probability));
        tails.fold(1.0, f64::min) * (trials * self.hypotheses).max(1) as f64
    }
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
        let near =
            |matches: usize, distance: f64, silhouettes| chance.false_alarms(vec![distance; matches], silhouettes);
        assert!(near(9, 0.5, 24) < near(8, 0.5, 24));
        assert!(near(8, 0.25, 24) < near(8, 0.5, 24));
        assert!(near(8, 0.5, 10) < near(8, 0.5, 24));
        // Three of seven trials succeed at half of the probability. The factor seven is for the
        // choice of `k`.
        let expected = 7.0 * 1000.0 * tail(7, 3, 0.05);
        assert!((near(6, 0.5, 10) / expected - 1.0).abs() < 1e-12);
        // A line that is far away adds nothing.
        let with_far = chance.false_alarms(vec![0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 1.0], 24);
        assert_eq!(with_far, near(6, 0.1, 24));
        assert_eq!(near(3, 0.0, 24), 21_000.0);
        let unknown = Chance { probability: f64::NAN, ..chance };
        assert_eq!(unknown.false_alarms(vec![0.1; 6], 24), 21_000.0);
    }
}
