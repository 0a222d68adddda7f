//! RANSAC with MSAC scores, local optimisation and confidence-based termination, for any model.
//!
//! A minimal sample of the data gives one or several models. The cost of a model is
//! `sum_i min(e_i^2 / t^2, 1)` over all data (Torr & Zisserman, "MLESAC", 2000). Each model that is
//! the best so far is optimised on its inliers at once (Chum, Matas & Kittler, "Locally optimized
//! RANSAC", 2003). Models from samples are further from the inliers than the noise, so they are
//! compared with a wider threshold, with optimised ones, too: once the inliers are found, hardly
//! any sample is optimised again. If the best model has the share `p` of samples that consist of
//! its inliers only, the search ends after
//!
//! ```text
//!   n >= log(1 - confidence) / log(1 - p)
//! ```
//!
//! samples. The probability that all of them have outliers is then at most `1 - confidence`.

use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::{Rng, SeedableRng};
use thiserror::Error;

/// Local optimisation takes the data within these multiples of the threshold in turn. Models from
/// samples are compared with the first multiple.
const WIDTHS: [f64; 3] = [3.0, 2.0, 1.0];

/// Limit on the repetitions of local optimisation at the threshold itself, while the cost decreases
/// by more than [`LITTLE`].
const REPETITIONS: usize = 10;

/// A relative decrease of the cost that another repetition is not worth: far less than a datum more
/// or less.
const LITTLE: f64 = 1e-4;

/// Options of RANSAC.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RansacOptions {
    /// Largest residual of an inlier, in the unit that the estimator names.
    pub threshold: f64,
    /// Seed of the random numbers: the same seed gives the same result.
    pub seed: u64,
    /// Required probability, between zero and one, that at least one sample without outliers was
    /// drawn.
    pub confidence: f64,
    /// Limit on the number of samples.
    pub max_samples: usize,
}

/// Why the options are refused.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum RansacOptionsError {
    /// The threshold is not a positive number.
    #[error("the inlier threshold must be a positive number (found {threshold})")]
    Threshold {
        /// The value.
        threshold: f64,
    },
    /// The confidence is not between zero and one.
    #[error("the confidence must be between 0 and 1, both excluded (found {confidence})")]
    Confidence {
        /// The value.
        confidence: f64,
    },
}

impl RansacOptions {
    /// Seed 0, confidence 0.999, at most 100,000 samples.
    pub fn with_threshold(threshold: f64) -> Self {
        Self { threshold, seed: 0, confidence: 0.999, max_samples: 100_000 }
    }

    pub(crate) fn check(&self) -> Result<(), RansacOptionsError> {
        let Self { threshold, confidence, .. } = *self;
        if !(threshold > 0.0 && threshold.is_finite()) {
            return Err(RansacOptionsError::Threshold { threshold });
        }
        if !(confidence > 0.0 && confidence < 1.0) {
            return Err(RansacOptionsError::Confidence { confidence });
        }
        Ok(())
    }
}

/// What RANSAC needs to know about data and model.
pub(crate) trait Estimator {
    /// The model.
    type Model: Clone;

    /// Size of a minimal sample.
    const SAMPLE: usize;

    /// Number of data.
    fn count(&self) -> usize;

    /// Models through a minimal sample.
    fn models(&self, sample: &[usize]) -> Vec<Self::Model>;

    /// Writes the squared residual of each datum; infinite if the model cannot explain it.
    fn write_squares(&self, model: &Self::Model, squares: &mut [f64]);

    /// The model of least squares on some data, from a first guess; `None` if the data determine no
    /// model.
    fn fitted(&self, model: &Self::Model, data: &[usize]) -> Option<Self::Model>;
}

/// The best model.
#[derive(Clone, Debug)]
pub(crate) struct Consensus<M> {
    pub(crate) model: M,
    /// Indices of the data within the threshold, ascending.
    pub(crate) inliers: Vec<usize>,
    /// Number of samples drawn.
    pub(crate) samples: usize,
}

/// Searches for the model of least cost. `None` if no sample gives a model, or there are not more
/// data than in a sample.
pub(crate) fn ransac<E: Estimator>(estimator: &E, options: &RansacOptions) -> Option<Consensus<E::Model>> {
    let count = estimator.count();
    if count <= E::SAMPLE {
        return None;
    }
    let search = Search { estimator, square_threshold: options.threshold * options.threshold };
    let mut random = Xoshiro256PlusPlus::seed_from_u64(options.seed);
    let (mut best, mut least_cost, mut least_wide_cost) = (None, f64::INFINITY, f64::INFINITY);
    let (mut needed, mut samples) = (options.max_samples, 0);
    let mut squares = vec![0.0; count];
    while samples < needed {
        samples += 1;
        for model in estimator.models(&sample(&mut random, E::SAMPLE, count)) {
            estimator.write_squares(&model, &mut squares);
            let wide_cost = search.cost(&squares, WIDTHS[0]);
            if wide_cost >= least_wide_cost {
                continue;
            }
            let model = search.optimised(model, &mut squares);
            least_wide_cost = wide_cost.min(search.cost(&squares, WIDTHS[0]));
            let cost = search.cost(&squares, 1.0);
            if cost < least_cost {
                least_cost = cost;
                let inliers = search.inliers(&squares, 1.0);
                needed = samples_needed(inliers.len(), count, E::SAMPLE, options);
                best = Some((model, inliers));
            }
        }
    }
    best.map(|(model, inliers)| Consensus { model, inliers, samples })
}

/// Number of samples of which at least one has no outliers, with the required confidence, if
/// `inliers` of `count` data are inliers.
pub(crate) fn samples_needed(inliers: usize, count: usize, size: usize, options: &RansacOptions) -> usize {
    // Samples are drawn without repetition.
    let share: f64 = (0..size).map(|drawn| inliers.saturating_sub(drawn) as f64 / (count - drawn) as f64).product();
    let needed = (-options.confidence).ln_1p() / (-share).ln_1p();
    // The number is infinite without inliers, and the conversion saturates.
    (needed.ceil() as usize).clamp(1, options.max_samples)
}

/// Different indices below `count`, each the high part of a product with a random number.
fn sample(random: &mut Xoshiro256PlusPlus, size: usize, count: usize) -> Vec<usize> {
    let mut sample = Vec::with_capacity(size);
    while sample.len() < size {
        let index = ((u128::from(random.next_u64()) * count as u128) >> 64) as usize;
        if !sample.contains(&index) {
            sample.push(index);
        }
    }
    sample
}

struct Search<'a, E> {
    estimator: &'a E,
    square_threshold: f64,
}

impl<E: Estimator> Search<'_, E> {
    /// The cost at a multiple of the threshold.
    fn cost(&self, squares: &[f64], width: f64) -> f64 {
        let scale = 1.0 / (width * width * self.square_threshold);
        // A NaN counts as one: the minimum of NaN and one is one.
        squares.iter().map(|square| (square * scale).min(1.0)).sum()
    }

    /// The data within a multiple of the threshold.
    fn inliers(&self, squares: &[f64], width: f64) -> Vec<usize> {
        let limit = width * width * self.square_threshold;
        (0..squares.len()).filter(|&datum| squares[datum] < limit).collect()
    }

    /// Fits to inliers, first those of wide thresholds, while this lowers the cost. The squared
    /// residuals become those of the result.
    fn optimised(&self, mut model: E::Model, squares: &mut Vec<f64>) -> E::Model {
        let mut cost = self.cost(squares, 1.0);
        let mut of_fitted = vec![0.0; squares.len()];
        for width in WIDTHS.into_iter().chain([1.0; REPETITIONS]) {
            let before = cost;
            if let Some(fitted) = self.estimator.fitted(&model, &self.inliers(squares, width)) {
                self.estimator.write_squares(&fitted, &mut of_fitted);
                let lower = self.cost(&of_fitted, 1.0);
                if lower < cost {
                    (model, cost) = (fitted, lower);
                    std::mem::swap(squares, &mut of_fitted);
                }
            }
            if width <= 1.0 && cost >= (1.0 - LITTLE) * before {
                break;
            }
        }
        model
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The model is a number among scattered data, and a sample is one datum.
    struct Number(Vec<f64>);

    impl Estimator for Number {
        type Model = f64;
        const SAMPLE: usize = 1;

        fn count(&self) -> usize {
            self.0.len()
        }

        fn models(&self, sample: &[usize]) -> Vec<f64> {
            sample.iter().map(|&datum| self.0[datum]).collect()
        }

        fn write_squares(&self, model: &f64, squares: &mut [f64]) {
            squares.iter_mut().zip(&self.0).for_each(|(square, number)| *square = (number - model).powi(2));
        }

        fn fitted(&self, _: &f64, data: &[usize]) -> Option<f64> {
            (!data.is_empty()).then(|| data.iter().map(|&datum| self.0[datum]).sum::<f64>() / data.len() as f64)
        }
    }

    #[test]
    fn the_mean_of_the_inliers() {
        let numbers = Number(vec![3.0, 90.0, 3.2, -50.0, 2.8, 70.0, 20.0, f64::NAN]);
        let result = ransac(&numbers, &RansacOptions::with_threshold(0.5)).expect("a model");
        assert_eq!(result.inliers, [0, 2, 4]);
        assert!((result.model - 3.0).abs() < 1e-15);
        // log(0.001) / log(5 / 8) = 14.7.
        assert_eq!(result.samples, 15);
    }

    #[test]
    fn no_more_data_than_a_sample() {
        assert!(ransac(&Number(vec![1.0]), &RansacOptions::with_threshold(0.5)).is_none());
    }

    #[test]
    fn the_limit_on_samples_holds() {
        let numbers = Number((0..100).map(f64::from).collect());
        let options = RansacOptions { max_samples: 7, ..RansacOptions::with_threshold(0.5) };
        assert_eq!(ransac(&numbers, &options).expect("a model").samples, 7);
    }

    #[test]
    fn samples_without_repetition_are_uniform() {
        let mut random = Xoshiro256PlusPlus::seed_from_u64(1);
        let mut seen = [0; 5];
        for _ in 0..10_000 {
            let sample = sample(&mut random, 3, 5);
            assert!(sample[0] != sample[1] && sample[0] != sample[2] && sample[1] != sample[2]);
            sample.into_iter().for_each(|index| seen[index] += 1);
        }
        // 6,000 are expected for each, with a standard deviation of 49.
        assert!(seen.iter().all(|count: &i32| (count - 6000).abs() < 250), "{seen:?}");
    }

    #[test]
    fn options_are_checked() {
        for threshold in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(matches!(
                RansacOptions::with_threshold(threshold).check(),
                Err(RansacOptionsError::Threshold { .. })
            ));
        }
        for confidence in [0.0, 1.0, -0.5, 1.5, f64::NAN] {
            let options = RansacOptions { confidence, ..RansacOptions::with_threshold(1.0) };
            assert!(matches!(options.check(), Err(RansacOptionsError::Confidence { .. })));
        }
    }
}
