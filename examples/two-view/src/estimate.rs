//! The estimator.

use std::cell::RefCell;

use inlier::core::{NoopInlierSelector, SuperRansac, TerminationCriterion};
use inlier::settings::RansacSettings;
use inlier::types::DataMatrix;
use nalgebra::Matrix3;
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::{RngCore, SeedableRng};
use thiserror::Error;

use crate::input::Pair;
use crate::pose::{Pose, in_front, rays};
use crate::refine::{LocalFit, last_fit};
use crate::samples::{FivePoint, Queue, SAMPLE, Samples};
use crate::score::{Msac, Score, within};

/// What the loop does, and when it ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// The largest Sampson error of an inlier, in pixels.
    pub threshold: f64,
    /// The required probability that some sample had no outlier.
    pub confidence: f64,
    /// How many times the samples that the confidence asks for are drawn, as samples of inliers
    /// only can be bad, too.
    pub repeats: f64,
    /// At least, and at most, so many samples are drawn.
    pub samples: [usize; 2],
    /// Of the random numbers: the same seed gives the same result.
    pub seed: u64,
}

impl Default for Options {
    fn default() -> Self {
        Self { threshold: 3.0, confidence: 0.9999, repeats: 3.0, samples: [1_000, 100_000], seed: 0 }
    }
}

/// What comes out.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// The pose of the second camera.
    pub pose: Pose,
    /// Its essential matrix, of rays.
    pub essential: Matrix3<f64>,
    /// Rows within the threshold, with their points in front of both cameras.
    pub inliers: Vec<usize>,
    /// Samples drawn.
    pub samples: usize,
}

/// Why there is no pose.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum EstimateError {
    /// An option is out of its range.
    #[error("the threshold must be above 0 and the confidence between 0 and 1 (found {threshold}, {confidence})")]
    Options {
        /// The threshold.
        threshold: f64,
        /// The confidence.
        confidence: f64,
    },
    /// The five-point solver takes five.
    #[error("five correspondences are needed at least (found {0})")]
    TooFew(usize),
    /// A number of the input, or one that is computed from it, is infinite or none.
    #[error("correspondence {0} or its camera is not finite")]
    NotFinite(usize),
    /// The correspondences state fewer than five independent equations.
    #[error("the correspondences are too much alike: they do not determine a pose")]
    Degenerate,
    /// No pose has more than five inliers.
    #[error("no pose agrees with more than five correspondences")]
    NoPose,
}

/// The pose that most correspondences agree with.
///
/// # Errors
/// Where the input is degenerate, or no pose has more than five inliers.
pub fn estimate(pair: &Pair, options: &Options) -> Result<Estimate, EstimateError> {
    let Options { threshold, confidence, samples: [min_iterations, max_iterations], .. } = *options;
    if !(threshold > 0.0 && threshold.is_finite() && confidence > 0.0 && confidence < 1.0) {
        return Err(EstimateError::Options { threshold, confidence });
    }
    checked(&pair.rays())?;
    let order = order(pair.points.len(), options.seed);
    let data = pair.rays().select_rows(&order);
    let threshold = threshold * pair.pixel();
    let msac = Msac::new(threshold);
    let settings = RansacSettings { min_iterations, max_iterations, ..RansacSettings::default() };
    let queue = RefCell::new(Queue::default());
    let (sampler, solver) = (Samples::new(options.seed, &queue), FivePoint(&queue));
    let (local, end) = (Some(LocalFit(&msac)), Confidence(*options));
    let mut ransac = SuperRansac::new(settings, solver, sampler, &msac, local, None, end, None::<NoopInlierSelector>);
    ransac.run(&data);
    let essential = ransac.best_model.ok_or(EstimateError::NoPose)?;
    let pose = Pose::from_essential(&essential, &data, &ransac.best_inliers).ok_or(EstimateError::NoPose)?;
    let pose = last_fit(pose, &data, threshold);
    let essential = pose.essential();
    let inliers = within(&data, &essential, threshold).filter(|&row| in_front(&pose, &data, row));
    let mut inliers: Vec<usize> = inliers.map(|row| order[row]).collect();
    inliers.sort_unstable();
    match inliers.len() > SAMPLE {
        true => Ok(Estimate { pose, essential, inliers, samples: ransac.iteration }),
        false => Err(EstimateError::NoPose),
    }
}

/// Ends the loop after the samples that the inliers found so far ask for.
struct Confidence(Options);

impl TerminationCriterion<Score> for Confidence {
    fn check(&mut self, data: &DataMatrix, best: &Score, sample: usize, limit: &mut usize) -> bool {
        let Options { confidence, repeats, samples: [least, most], .. } = self.0;
        let share = |k: usize| best.inliers.saturating_sub(k) as f64 / (data.nrows() - k) as f64;
        let good: f64 = (0..sample).map(share).product();
        let needed = repeats * (1.0 - confidence).ln() / (-good).ln_1p();
        // Too many for a `usize` where no sample is good: the conversion saturates.
        *limit = (needed.ceil() as usize).min(most).max(least);
        false
    }
}

/// A random order of rows, by Fisher and Yates.
fn order(rows: usize, seed: u64) -> Vec<usize> {
    let mut random = Xoshiro256PlusPlus::seed_from_u64(seed);
    let mut order: Vec<usize> = (0..rows).collect();
    for last in (1..rows).rev() {
        order.swap(last, (random.next_u64() % (last as u64 + 1)) as usize);
    }
    order
}

/// Whether the data can determine a pose.
fn checked(data: &DataMatrix) -> Result<(), EstimateError> {
    if data.nrows() < SAMPLE {
        return Err(EstimateError::TooFew(data.nrows()));
    }
    if let Some(row) = (0..data.nrows()).find(|&row| data.row(row).iter().any(|x| !x.is_finite())) {
        return Err(EstimateError::NotFinite(row));
    }
    // Each correspondence states a linear equation for the nine elements of the matrix.
    let mut squares = nalgebra::SMatrix::<f64, 9, 9>::zeros();
    for row in 0..data.nrows() {
        let [first, second] = rays(data, row);
        let equation = first.kronecker(&second);
        squares.syger(1.0, &equation, &equation, 1.0);
    }
    let mut values = squares.symmetric_eigenvalues();
    values.as_mut_slice().sort_by(|a, b| b.total_cmp(a));
    // Rounding leaves eigenvalues of the squares that are zero at some 1e-16 of the largest.
    if values[SAMPLE - 1] > 1e-14 * values[0] { Ok(()) } else { Err(EstimateError::Degenerate) }
}
