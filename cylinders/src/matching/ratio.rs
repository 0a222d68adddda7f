//! The likelihood ratio of silhouettes that have lines near them, and how often chance reaches it.
//!
//! Lines are near a given silhouette by chance with the density `lambda`, on either side and per
//! threshold, so that the nearest of them has the distance `d` with the density `2
//! lambda exp(-2 lambda d)`. If a silhouette is detected with the probability `pi`, and its line is
//! off by normal noise of the scale `s`, then the likelihood ratio of a silhouette whose nearest
//! line is at the distance `d`, and of one without a line, is at most
//!
//! ```text
//!   q(d) = 1 - pi + pi N(d; s) / lambda,     q = 1 - pi
//! ```
//!
//! The ratio `R` is the mean over several `s` and `pi` of the product over the silhouettes: both
//! are unknown, and are marginalised over as the scale is by Barath, Noskova, Ivashechkin & Matas,
//! "MAGSAC++", 2020. The mean of `R` over random lines is at most 1, so that chance reaches `R`
//! with a probability of `1 / R` at most (Markov's inequality). It does so 20 to 100 times less
//! often, because `R` has no one value but is spread over orders of magnitude. Its distribution by
//! chance is sampled where it matters (importance sampling; Hammersley & Handscomb, "Monte Carlo
//! Methods", 1964): distances are drawn with the density
//!
//! ```text
//!   Q = mean over s, pi of the product of q(d) 2 lambda exp(-2 lambda d) / Z,
//!       Z = 1 - pi + pi K(s),   K(s) = integral from 0 to 1 of 2 N(d; s) exp(-2 lambda d)
//! ```
//!
//! as a cylinder gives them, and count with the weight of `chance / Q`.
//!
//! Lines of a texture crowd together. Where they are denser than on average, `lambda` of a line is
//! that of its neighbourhood, which makes `R` smaller. The distribution is that of the average.

use std::f64::consts::{FRAC_1_SQRT_2, TAU};
use std::sync::OnceLock;

use crate::numerics::random::Random;

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

/// So many factors neither overflow nor vanish.
const FACTORS: usize = 16;

/// Fewest and most samples for each scale and part, and the number of silhouettes that they have in
/// all, so that many images do not take long.
const SAMPLES: [usize; 2] = [4, 64];
const SAMPLED_SILHOUETTES: usize = 2048;

/// Distance between the ratios at which the probability is tabulated, as logarithms.
const STEP: f64 = 0.5;

/// Intervals by which `K` is integrated.
const INTERVALS: usize = 512;

/// A value for each scale and each part of the silhouettes that is detected.
type Table = [[f64; DETECTIONS.len()]; SCALES.len()];

/// The line nearest to a silhouette.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Nearest {
    /// Distance from the silhouette, in thresholds.
    pub(super) distance: f64,
    /// `lambda` there.
    pub(super) density: f64,
}

/// How much a circle stands out from random lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ratio {
    /// `ln R`.
    pub(super) logarithm: f64,
    /// Most likely scale.
    pub(super) scale: f64,
}

impl Ratio {
    /// The ratio of `trials` silhouettes, of which some have lines.
    pub(super) fn of(nearest: &[Nearest], trials: usize) -> Self {
        let of_scales = logarithms(nearest, trials).map(|of_scale| mean_of_exponentials(&of_scale));
        let more = |best: usize, next: usize| if of_scales[next] > of_scales[best] { next } else { best };
        let best = (0..SCALES.len()).fold(0, more);
        Self { logarithm: mean_of_exponentials(&of_scales), scale: SCALES[best] }
    }
}

/// Logarithms of the products over `trials` silhouettes, of which some have lines.
fn logarithms(nearest: &[Nearest], trials: usize) -> Table {
    let most = SCALES.map(|scale| 1.0 / (scale * TAU.sqrt()));
    let missed = trials.saturating_sub(nearest.len()) as f64;
    let mut sums = [DETECTIONS.map(|detection| missed * (1.0 - detection).ln()); SCALES.len()];
    for part in nearest.chunks(FACTORS) {
        let mut products = [[1.0; DETECTIONS.len()]; SCALES.len()];
        for &Nearest { distance, density } in part {
            // The square of each scale is half of that of the one before.
            let mut near = (-0.5 * (distance / SCALES[0]).powi(2)).exp();
            for (products, most) in products.iter_mut().zip(most) {
                let more_likely = most * near / density;
                for (product, detection) in products.iter_mut().zip(DETECTIONS) {
                    *product *= 1.0 - detection + detection * more_likely;
                }
                near *= near;
            }
        }
        let all = sums.as_flattened_mut().iter_mut().zip(products.as_flattened());
        all.for_each(|(sum, product)| *sum += product.ln());
    }
    sums
}

/// How often chance reaches a ratio.
#[derive(Debug)]
pub(super) struct ByChance {
    density: f64,
    /// For each number of silhouettes.
    tails: Vec<OnceLock<Tail>>,
}

impl ByChance {
    /// For up to so many silhouettes.
    pub(super) fn new(density: f64, silhouettes: usize) -> Self {
        Self { density, tails: (0..=silhouettes).map(|_| OnceLock::new()).collect() }
    }

    /// The density of random lines.
    pub(super) fn density(&self) -> f64 {
        self.density
    }

    /// Natural logarithm of the probability with which so many silhouettes among random lines have
    /// a ratio of at least this one.
    pub(super) fn logarithm(&self, ratio: f64, silhouettes: usize) -> f64 {
        let markov = (-ratio).min(0.0);
        match self.tails.get(silhouettes) {
            Some(tail) => tail.get_or_init(|| Tail::new(self.density, silhouettes)).logarithm(ratio).min(markov),
            None => markov,
        }
    }
}

/// The distribution of the ratio of a number of silhouettes among random lines.
#[derive(Debug)]
struct Tail {
    /// `ln R` of the first entry of the table.
    first: f64,
    /// Logarithms of the probability that `ln R` is `first + k STEP` or more.
    probabilities: Vec<f64>,
}

impl Tail {
    fn new(density: f64, silhouettes: usize) -> Self {
        let mut random = Random::new(silhouettes as u64);
        let masses = SCALES.map(|scale| mass(density, scale));
        let of_each = (SAMPLED_SILHOUETTES / silhouettes.max(1)).clamp(SAMPLES[0], SAMPLES[1]);
        let mut samples = Vec::with_capacity(SCALES.len() * DETECTIONS.len() * of_each);
        for (scale, mass) in SCALES.into_iter().zip(masses) {
            for detection in DETECTIONS {
                let detected = detection * mass / (1.0 - detection + detection * mass);
                for _ in 0..of_each {
                    let nearest = (0..silhouettes).filter_map(|_| draw(density, scale, detected, &mut random));
                    samples.push(weighted(&nearest.collect::<Vec<_>>(), silhouettes, &masses));
                }
            }
        }
        samples.sort_unstable_by(|one, other| one.0.total_cmp(&other.0));
        let count = samples.len() as f64;
        let [least, most] = [samples[0].0, samples[samples.len() - 1].0];
        let first = (least / STEP).floor() * STEP;
        let steps = ((most - first) / STEP) as usize;
        let mut probabilities = vec![f64::NEG_INFINITY; steps + 1];
        let (mut sum, mut next) = (0.0, samples.len());
        for step in (0..=steps).rev() {
            while next > 0 && samples[next - 1].0 >= first + step as f64 * STEP {
                next -= 1;
                sum += samples[next].1;
            }
            probabilities[step] = (sum / count).ln().min(0.0);
        }
        Self { first, probabilities }
    }

    fn logarithm(&self, ratio: f64) -> f64 {
        let place = (ratio - self.first) / STEP;
        let last = self.probabilities.len() - 1;
        if place <= 0.0 {
            0.0
        } else if place >= last as f64 {
            // Beyond the samples, Markov's inequality gives the slope.
            self.probabilities[last] - (place - last as f64) * STEP
        } else {
            let (step, part) = (place as usize, place.fract());
            self.probabilities[step] * (1.0 - part) + self.probabilities[step + 1] * part
        }
    }
}

/// `K`.
fn mass(density: f64, scale: f64) -> f64 {
    let at = |interval: usize| {
        let distance = (interval as f64 + 0.5) / INTERVALS as f64;
        (-0.5 * (distance / scale).powi(2) - 2.0 * density * distance).exp()
    };
    2.0 * (0..INTERVALS).map(at).sum::<f64>() / (INTERVALS as f64 * scale * TAU.sqrt())
}

/// The nearest line of a silhouette: that of a cylinder with the probability `detected`, or a
/// random one. `None` if none is within the threshold.
fn draw(density: f64, scale: f64, detected: f64, random: &mut Random) -> Option<Nearest> {
    let uniform = |random: &mut Random| random.uniform(0.0, 1.0);
    if uniform(random) >= detected {
        let distance = -(1.0 - uniform(random)).ln() / (2.0 * density);
        return Some(Nearest { distance, density }).filter(|nearest| nearest.distance <= 1.0);
    }
    loop {
        let distance = scale * random.normal().abs();
        if distance <= 1.0 && uniform(random) < (-2.0 * density * distance).exp() {
            return Some(Nearest { distance, density });
        }
    }
}

/// `ln R` of a sample and its weight, `chance / Q`.
fn weighted(nearest: &[Nearest], silhouettes: usize, masses: &[f64; SCALES.len()]) -> (f64, f64) {
    let mut logarithms = logarithms(nearest, silhouettes);
    let of_all = |logarithms: &Table| mean_of_exponentials(&logarithms.map(|of_scale| mean_of_exponentials(&of_scale)));
    let ratio = of_all(&logarithms);
    for (of_scale, mass) in logarithms.iter_mut().zip(masses) {
        for (logarithm, detection) in of_scale.iter_mut().zip(DETECTIONS) {
            *logarithm -= silhouettes as f64 * (1.0 - detection + detection * mass).ln();
        }
    }
    (ratio, (-of_all(&logarithms)).exp())
}

/// `ln(mean(exp(x)))`.
fn mean_of_exponentials(logarithms: &[f64]) -> f64 {
    let most = logarithms.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let sum: f64 = logarithms.iter().map(|logarithm| (logarithm - most).exp()).sum();
    most + (sum / logarithms.len() as f64).ln()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The nearest lines of so many silhouettes among random lines.
    fn random_lines(density: f64, silhouettes: usize, random: &mut Random) -> Vec<Nearest> {
        (0..silhouettes).filter_map(|_| draw(density, SCALES[0], 0.0, random)).collect()
    }

    /// The mean over random lines of the ratio of a silhouette is `Z`, at most one, so that chance
    /// is never underestimated.
    #[test]
    fn the_mean_ratio_of_random_lines_is_at_most_one() {
        const PARTS: usize = 10_000;
        for density in [0.001_f64, 0.05, 0.5, 2.0] {
            let mut means = logarithms(&[], 1).map(|of_scale| of_scale.map(|logarithm| logarithm.exp()));
            means.as_flattened_mut().iter_mut().for_each(|mean| *mean *= (-2.0 * density).exp());
            for part in 0..PARTS {
                let distance = (part as f64 + 0.5) / PARTS as f64;
                let chance = 2.0 * density * (-2.0 * density * distance).exp() / PARTS as f64;
                let ratios = logarithms(&[Nearest { distance, density }], 1);
                let all = means.as_flattened_mut().iter_mut().zip(ratios.as_flattened());
                all.for_each(|(mean, ratio)| *mean += chance * ratio.exp());
            }
            for (of_scale, scale) in means.into_iter().zip(SCALES) {
                for (mean, detection) in of_scale.into_iter().zip(DETECTIONS) {
                    let expected = 1.0 - detection + detection * mass(density, scale);
                    assert!(
                        (mean - expected).abs() < 1e-4 && expected <= 1.0 + 1e-9,
                        "{density} {scale}: {mean} {expected}"
                    );
                }
            }
        }
    }

    /// Logarithms of many factors are those of the factors one by one.
    #[test]
    fn ratios_of_many_silhouettes_neither_overflow_nor_vanish() {
        let distances: Vec<f64> = (0..500).map(|index| 0.002 * f64::from(index)).collect();
        for (density, missed) in [(1e-6, 0), (0.1, 3000)] {
            let trials = distances.len() + missed;
            let nearest: Vec<_> = distances.iter().map(|&distance| Nearest { distance, density }).collect();
            for (of_scale, scale) in logarithms(&nearest, trials).into_iter().zip(SCALES) {
                for (logarithm, detection) in of_scale.into_iter().zip(DETECTIONS) {
                    let most = detection / (density * scale * TAU.sqrt());
                    let factor = |d: &f64| (1.0 - detection + most * (-0.5 * (d / scale).powi(2)).exp()).ln();
                    let expected = distances.iter().map(factor).sum::<f64>() + missed as f64 * (1.0 - detection).ln();
                    assert!((logarithm - expected).abs() < 1e-9 * expected.abs().max(1.0), "{logarithm} {expected}");
                }
            }
        }
    }

    /// The probability of a ratio is the part of random lines that reach it, counted where that
    /// happens often enough.
    #[test]
    fn chance_reaches_a_ratio_as_often_as_it_is_said_to() {
        let mut random = Random::new(2);
        for (density, silhouettes) in [(0.02, 9), (0.05, 21), (0.3, 21), (1.0, 40)] {
            let by_chance = ByChance::new(density, silhouettes);
            let runs = 400_000;
            let ratio = |_| Ratio::of(&random_lines(density, silhouettes, &mut random), silhouettes).logarithm;
            let mut ratios: Vec<f64> = (0..runs).map(ratio).collect();
            ratios.sort_unstable_by(|one, other| other.total_cmp(one));
            for reached in [40, 400, 4000, 40000] {
                let said = by_chance.logarithm(ratios[reached], silhouettes).exp();
                let counted = reached as f64 / f64::from(runs);
                assert!((said / counted).ln().abs() < 0.5, "{density} {silhouettes} {counted}: {said}");
            }
        }
    }

    #[test]
    fn a_larger_ratio_is_less_likely_and_markov_bounds_it() {
        let by_chance = ByChance::new(0.05, 3000);
        for silhouettes in [0, 1, 5, 24, 25, 3000, 3001] {
            let of = |ratio: f64| by_chance.logarithm(ratio, silhouettes);
            let mut last = 0.0;
            for step in -100..1000 {
                let ratio = 0.1 * f64::from(step);
                let next = of(ratio);
                let is_less = next <= last + 1e-12 && next <= (-ratio).min(0.0);
                assert!(is_less, "{silhouettes} {ratio}: {next} after {last}");
                last = next;
            }
        }
    }
}
