//! The density of Sampson errors: normal for right correspondences, constant for wrong ones.
//!
//! Wrong correspondences that happen to agree with a pose do so at any parallax, right ones at
//! those of the scene. At the largest parallaxes, which move a pose most, many are wrong. So the
//! share of wrong ones is found for parts of the correspondences, in the order of the parallax: the
//! lower half, half of the rest, and so on.

use std::f64::consts::TAU;

/// How many parts there are.
const PARTS: usize = 10;
/// Repetitions that find the noise from errors.
const STEPS: usize = 20;
/// The least standard deviation: exact correspondences do not divide by zero.
const LEAST_DEVIATION: f64 = 1e-4;

/// What errors show. They are in any unit, such as thresholds.
#[derive(Clone, Debug, PartialEq)]
pub struct Noise {
    /// The standard deviation of right correspondences.
    pub deviation: f64,
    /// For each correspondence the density of wrong ones, relative to the largest of right ones.
    pub outliers: Vec<f64>,
}

impl Noise {
    /// The noise of these errors, all below the reach, in the order of the parallax; by expectation
    /// and maximisation.
    pub fn of(errors: &[f64], reach: f64) -> Self {
        let part_of = |index: usize| ((errors.len() / (errors.len() - index)).ilog2() as usize).min(PARTS - 1);
        let parts: Vec<usize> = (0..errors.len()).map(part_of).collect();
        let mut counts = [0.0; PARTS];
        parts.iter().for_each(|&part| counts[part] += 1.0);
        let (mut deviation, mut outliers) = (0.5 * reach / 3.0, [0.1; PARTS]);
        for _ in 0..STEPS {
            let (mut right, mut squares) = ([0.0; PARTS], 0.0);
            for (error, &part) in errors.iter().zip(&parts) {
                let density = (-0.5 * (error / deviation).powi(2)).exp();
                let probability = density / (density + outliers[part]);
                right[part] += probability;
                squares += probability * error * error;
            }
            deviation = (squares / right.iter().sum::<f64>()).sqrt().max(LEAST_DEVIATION);
            let peak = 1.0 / (deviation * TAU.sqrt());
            for part in 0..PARTS {
                // One more: a part is never without doubt.
                let wrong = counts[part] - right[part] + 1.0;
                outliers[part] = wrong / right[part] / (2.0 * reach * peak);
            }
        }
        Self { deviation, outliers: parts.into_iter().map(|part| outliers[part]).collect() }
    }

    /// The number whose square is minus twice the logarithm of the density of an error, relative to
    /// its largest value, and the derivative.
    pub fn root(&self, index: usize, error: f64) -> (f64, f64) {
        let (e, outliers) = (error / self.deviation, self.outliers[index]);
        let less = (-0.5 * e * e).exp_m1();
        let root = (-2.0 * (less / (1.0 + outliers)).ln_1p()).sqrt().copysign(e);
        if root.abs() < 1e-6 {
            let slope = (1.0 + outliers).sqrt().recip();
            return (slope * e, slope / self.deviation);
        }
        let probability = (1.0 + less) / (1.0 + less + outliers);
        (root, probability * e / (root * self.deviation))
    }
}

#[cfg(test)]
mod tests {
    use rand_xoshiro::Xoshiro256PlusPlus;
    use rand_xoshiro::rand_core::{RngCore, SeedableRng};

    use super::*;

    #[test]
    fn noise_is_found_among_outliers() {
        let mut random = Xoshiro256PlusPlus::seed_from_u64(1);
        let mut uniform = || (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64;
        // Twelve uniform numbers have nearly a normal sum, of variance one.
        let mut errors: Vec<f64> = (0..3000).map(|_| 0.3 * ((0..12).map(|_| uniform()).sum::<f64>() - 6.0)).collect();
        errors.extend((0..1000).map(|_| 6.0 * uniform() - 3.0));
        let noise = Noise::of(&errors, 3.0);
        assert!((noise.deviation - 0.3).abs() < 0.02, "{}", noise.deviation);
        assert!(noise.outliers[3900] > 100.0 * noise.outliers[0]);
    }

    #[test]
    fn exact_correspondences_have_little_noise() {
        let noise = Noise::of(&[0.0; 100], 3.0);
        assert_eq!(noise.deviation, LEAST_DEVIATION);
        assert!(noise.outliers.iter().all(|value| value.is_finite()));
        assert!(Noise::of(&[], 3.0).outliers.is_empty());
    }
}
