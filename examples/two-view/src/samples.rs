//! Samples of five correspondences, and their essential matrices by Eliminant's solver.
//!
//! The loop draws a sample and asks for its matrices at once. The solver computes several instances
//! side by side in less time: samples are drawn and solved many at a time, and wait for the loop.

use std::cell::RefCell;

use eliminant::Solutions;
use eliminant_solvers::relpose_5pt_rays::{Data, relative_pose_of_each, solve_batch};
use inlier::core::{Estimator, Sampler};
use inlier::samplers::UniformRandomSampler;
use inlier::types::DataMatrix;
use nalgebra::Matrix3;

use crate::pose::rays;

/// Correspondences of a sample.
pub const SAMPLE: usize = 5;
/// Samples that are solved together.
const BATCH: usize = 32;
/// After so many batches without a matrix no more are drawn: the data are degenerate.
const BARREN: usize = 10;

/// The matrices of samples, drawn and waiting.
#[derive(Default)]
pub struct Queue {
    waiting: Vec<Vec<Matrix3<f64>>>,
    barren: usize,
}

/// Fills the queue.
pub struct Samples<'a> {
    random: UniformRandomSampler,
    queue: &'a RefCell<Queue>,
}

impl<'a> Samples<'a> {
    /// The same seed draws the same samples.
    pub fn new(seed: u64, queue: &'a RefCell<Queue>) -> Self {
        Self { random: UniformRandomSampler::from_seed(seed), queue }
    }

    fn draw(&mut self, data: &DataMatrix) -> Data {
        let mut sample = [0; SAMPLE];
        self.random.sample(data, SAMPLE, &mut sample);
        let [first, second] = [0, 1].map(|image| sample.map(|row| rays(data, row)[image].into()));
        Data { first, second }
    }
}

impl Sampler for Samples<'_> {
    fn sample(&mut self, data: &DataMatrix, _: usize, _: &mut [usize]) -> bool {
        let mut queue = self.queue.borrow_mut();
        if queue.waiting.is_empty() && queue.barren < BARREN {
            queue.waiting = solved(&[(); BATCH].map(|()| self.draw(data)));
            let is_barren = queue.waiting.iter().all(Vec::is_empty);
            queue.barren = if is_barren { queue.barren + 1 } else { 0 };
        }
        !queue.waiting.is_empty()
    }

    fn update(&mut self, _: &[usize], _: usize, _: usize, _: f64) {}
}

/// The essential matrices of each sample.
fn solved(samples: &[Data; BATCH]) -> Vec<Vec<Matrix3<f64>>> {
    let mut results = [(); BATCH].map(|()| Ok(Solutions::new()));
    solve_batch(samples, &mut results);
    let matrices = |(Data { first, second }, result): (&Data, _)| {
        let poses = Result::and_then(result, |solutions| relative_pose_of_each(first, second, &solutions));
        let poses = poses.unwrap_or_default();
        poses.iter().map(|pose| Matrix3::from_fn(|row, column| pose.essential[row][column])).collect()
    };
    samples.iter().zip(results).map(matrices).collect()
}

/// Empties the queue.
pub struct FivePoint<'a>(pub &'a RefCell<Queue>);

impl Estimator for FivePoint<'_> {
    type Model = Matrix3<f64>;

    fn sample_size(&self) -> usize {
        SAMPLE
    }

    fn is_valid_sample(&self, _: &DataMatrix, _: &[usize]) -> bool {
        true
    }

    fn estimate_model(&self, _: &DataMatrix, _: &[usize]) -> Vec<Matrix3<f64>> {
        self.0.borrow_mut().waiting.pop().unwrap_or_default()
    }

    fn is_valid_model(&self, _: &Matrix3<f64>, _: &DataMatrix, _: &[usize], _: f64) -> bool {
        true
    }
}
