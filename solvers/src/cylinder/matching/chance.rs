//! How much support a circle may have by chance (Desolneux, Moisan & Morel, "From Gestalt Theory to Image Analysis", 2008).
//!
//! Where the rays of an image lie in no order, a silhouette has one of them within the threshold with the probability
//!
//! ```text
//!   p = (sum of 2 t over all rays) / (sum of the images' angles between their outermost rays)
//! ```
//!
//! A hypothesis matches three lines by construction. The number of hypotheses that have `k` matches or more by chance is at most
//! the number of all of them times the tail of a binomial distribution, `P(B >= k - 3)` over the other silhouettes.

use super::pair::Pair;
use super::plan::Plan;

/// Expected number of hypotheses that have the least support by chance.
const FALSE_ALARMS: f64 = 0.01;

/// Number of matches that a hypothesis has by construction.
const SAMPLE: usize = 3;

/// The least number of matches that the hypotheses of the lines that are left do not reach by chance: more than there are
/// silhouettes where any number may be reached.
pub(super) fn least_by_chance(plan: &Plan, pairs: &[Pair]) -> usize {
    let views = plan.views();
    let silhouettes = 2 * views.iter().filter(|view| !view.lines.is_empty()).count();
    let free: Vec<_> = views.iter().map(|view| plan.free_lines(view)).collect();
    let covered: f64 = views.iter().zip(&free).map(|(view, &free)| 2.0 * view.threshold * free as f64).sum();
    let probability = covered / views.iter().map(|view| view.span).sum::<f64>();
    let lines: usize = free.iter().sum();
    let of_pair = |pair: &Pair| 2 * (lines - free[pair.view()]);
    let hypotheses: usize = pairs.iter().filter(|pair| pair.is_free(plan)).map(of_pair).sum();
    // Not so where no image has two lines: their angle is zero.
    let sparse = probability > 0.0 && probability < 1.0;
    if !sparse {
        return silhouettes + 1;
    }
    let trials = silhouettes - SAMPLE;
    let mut least = trials + 1;
    let mut tail = 0.0;
    for successes in (0..=trials).rev() {
        tail += binomial(trials, successes, probability);
        if tail * hypotheses as f64 > FALSE_ALARMS {
            break;
        }
        least = successes;
    }
    least + SAMPLE
}

/// Probability of so many successes in so many trials.
fn binomial(trials: usize, successes: usize, probability: f64) -> f64 {
    let choices: f64 = (0..successes).map(|index| ((trials - index) as f64 / (index + 1) as f64).ln()).sum();
    (choices + successes as f64 * probability.ln() + (trials - successes) as f64 * (-probability).ln_1p()).exp()
}

#[cfg(test)]
mod tests {
    use super::binomial;

    #[test]
    fn probabilities_are_those_of_coins_and_sum_to_one() {
        for (successes, expected) in [1.0, 4.0, 6.0, 4.0, 1.0].into_iter().enumerate() {
            assert!((binomial(4, successes, 0.5) - expected / 16.0).abs() < 1e-15);
        }
        let sum: f64 = (0..=97).map(|successes| binomial(97, successes, 0.23)).sum();
        assert!((sum - 1.0).abs() < 1e-12, "{sum}");
    }
}
