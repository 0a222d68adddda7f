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

use super::interrupt::{Interrupt, Interrupted};

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
pub struct RansacOptions<'a> {
    /// Largest residual of an inlier, in the unit that the estimator names.
    pub threshold: f64,
    /// Seed of the random numbers: the same seed gives the same result.
    pub seed: u64,
    /// Required probability, between zero and one, that at least one sample without outliers was
    /// drawn.
    pub confidence: f64,
    /// Limit on the number of samples.
    pub max_samples: usize,
    /// Ends the search between samples.
    pub interrupt: Interrupt<'a>,
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

impl RansacOptions<'_> {
    /// Seed 0, confidence 0.999, at most 100,000 samples, never interrupted.
    pub fn with_threshold(threshold: f64) -> Self {
        Self { threshold, seed: 0, confidence: 0.999, max_samples: 100_000, interrupt: Interrupt::never() }
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

    /// Appends the models through a minimal sample.
    fn add_models(&self, sample: &[usize], models: &mut Vec<Self::Model>);

    /// Writes the squared residual of each datum in turn, infinite if the model cannot explain it.
    /// After each of a few data `go_on` gets what was written for them and says whether to go on.
    fn write_squares(&self, model: &Self::Model, squares: &mut [f64], go_on: impl FnMut(&[f64]) -> bool);

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
///
/// # Errors
/// [`Interrupted`].
pub(crate) fn ransac<E: Estimator>(
    estimator: &E,
    options: &RansacOptions,
) -> Result<Option<Consensus<E::Model>>, Interrupted> {
    let count = estimator.count();
    if count <= E::SAMPLE {
        return Ok(None);
    }
    let search = Search { estimator, square_threshold: options.threshold * options.threshold };
    let mut random = Xoshiro256PlusPlus::seed_from_u64(options.seed);
    let (mut best, mut least_cost, mut least_wide_cost) = (None, f64::INFINITY, f64::INFINITY);
    let (mut needed, mut samples) = (options.max_samples, 0);
    let (mut sample, mut models, mut squares) = (vec![0; E::SAMPLE], Vec::new(), vec![0.0; count]);
    while samples < needed {
        options.interrupt.check()?;
        samples += 1;
        draw(&mut random, &mut sample, count);
        estimator.add_models(&sample, &mut models);
        for model in models.drain(..) {
            let Some(wide_cost) = search.cost_below(least_wide_cost, &model, WIDTHS[0], &mut squares) else { continue };
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
    Ok(best.map(|(model, inliers)| Consensus { model, inliers, samples }))
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

/// Draws different indices below `count`, each the high part of a product with a random number.
fn draw(random: &mut Xoshiro256PlusPlus, sample: &mut [usize], count: usize) {
    let mut drawn = 0;
    while drawn < sample.len() {
        let index = ((u128::from(random.next_u64()) * count as u128) >> 64) as usize;
        if !sample[..drawn].contains(&index) {
            sample[drawn] = index;
            drawn += 1;
        }
    }
}

struct Search<'a, E> {
    estimator: &'a E,
    square_threshold: f64,
}

impl<E: Estimator> Search<'_, E> {
    /// The cost at a multiple of the threshold.
    fn cost(&self, squares: &[f64], width: f64) -> f64 {
        squares.iter().fold(0.0, |cost, square| cost + self.cost_of_datum(*square, width))
    }

    /// Writes the squared residuals of a model and sums its cost at a multiple of the threshold;
    /// `None` as soon as the sum reaches the limit. No datum has a negative cost, and rounding does
    /// not make a sum smaller than one of its terms, so the whole sum would reach it, too.
    fn cost_below(&self, limit: f64, model: &E::Model, width: f64, squares: &mut [f64]) -> Option<f64> {
        let mut cost = 0.0;
        self.estimator.write_squares(model, squares, |part| {
            cost = part.iter().fold(cost, |cost, square| cost + self.cost_of_datum(*square, width));
            cost < limit
        });
        (cost < limit).then_some(cost)
    }

    /// A NaN counts as one: the minimum of NaN and one is one.
    fn cost_of_datum(&self, square: f64, width: f64) -> f64 {
        (square * (1.0 / (width * width * self.square_threshold))).min(1.0)
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
            if let Some(fitted) = self.estimator.fitted(&model, &self.inliers(squares, width))
                && let Some(lower) = self.cost_below(cost, &fitted, 1.0, &mut of_fitted)
            {
                (model, cost) = (fitted, lower);
                std::mem::swap(squares, &mut of_fitted);
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
    use std::cell::Cell;

    /// The model is a number among scattered data, and a sample is one datum.
    struct Number {
        data: Vec<f64>,
        /// Number of data after which costs are compared.
        part: usize,
        /// Number of squared residuals that were written.
        written: Cell<usize>,
    }

    impl Number {
        fn new(data: Vec<f64>, part: usize) -> Self {
            Self { data, part, written: Cell::new(0) }
        }
    }

    impl Estimator for Number {
        type Model = f64;
        const SAMPLE: usize = 1;

        fn count(&self) -> usize {
            self.data.len()
        }

        fn add_models(&self, sample: &[usize], models: &mut Vec<f64>) {
            models.extend(sample.iter().map(|&datum| self.data[datum]));
        }

        fn write_squares(&self, model: &f64, squares: &mut [f64], mut go_on: impl FnMut(&[f64]) -> bool) {
            for (part, data) in squares.chunks_mut(self.part).zip(self.data.chunks(self.part)) {
                part.iter_mut().zip(data).for_each(|(square, number)| *square = (number - model).powi(2));
                self.written.set(self.written.get() + part.len());
                if !go_on(part) {
                    return;
                }
            }
        }

        fn fitted(&self, _: &f64, data: &[usize]) -> Option<f64> {
            (!data.is_empty()).then(|| data.iter().map(|&datum| self.data[datum]).sum::<f64>() / data.len() as f64)
        }
    }

    #[test]
    fn the_mean_of_the_inliers() {
        let numbers = Number::new(vec![3.0, 90.0, 3.2, -50.0, 2.8, 70.0, 20.0, f64::NAN], 8);
        let result = ransac(&numbers, &RansacOptions::with_threshold(0.5)).expect("the end").expect("a model");
        assert_eq!(result.inliers, [0, 2, 4]);
        assert!((result.model - 3.0).abs() < 1e-15);
        // log(0.001) / log(5 / 8) = 14.7.
        assert_eq!(result.samples, 15);
    }

    #[test]
    fn what_is_not_summed_changes_no_bit() {
        for seed in 0..50 {
            let mut random = Xoshiro256PlusPlus::seed_from_u64(seed);
            let mut number = || (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64;
            let data: Vec<f64> =
                (0..200).map(|datum| if datum % 2 > 0 { number() } else { 100.0 * number() }).collect();
            let options = RansacOptions { seed, ..RansacOptions::with_threshold(0.3) };
            let [early, whole] = [1, 200].map(|part| {
                let numbers = Number::new(data.clone(), part);
                let found = ransac(&numbers, &options).expect("the end").expect("a model");
                ((found.model.to_bits(), found.inliers, found.samples), numbers.written.get())
            });
            assert_eq!(early.0, whole.0, "seed {seed}");
            assert!(early.1 < whole.1, "seed {seed}: {} of {} residuals", early.1, whole.1);
        }
    }

    #[test]
    fn no_more_data_than_a_sample() {
        let found = ransac(&Number::new(vec![1.0], 1), &RansacOptions::with_threshold(0.5));
        assert!(found.expect("the end").is_none());
    }

    #[test]
    fn the_limit_on_samples_holds() {
        let numbers = Number::new((0..100).map(f64::from).collect(), 100);
        let options = RansacOptions { max_samples: 7, ..RansacOptions::with_threshold(0.5) };
        assert_eq!(ransac(&numbers, &options).expect("the end").expect("a model").samples, 7);
    }

    #[test]
    fn samples_without_repetition_are_uniform() {
        let mut random = Xoshiro256PlusPlus::seed_from_u64(1);
        let mut seen = [0; 5];
        for _ in 0..10_000 {
            let mut sample = [0; 3];
            draw(&mut random, &mut sample, 5);
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
