//! The cost of an essential matrix: Sampson errors, truncated (MSAC).
//!
//! The cost of a correspondence is the squared Sampson error over the squared threshold, and at
//! most one. An inlier that is not in front of both cameras costs one, too.

use std::cell::RefCell;
use std::cmp::Ordering;

use inlier::core::Scoring;
use inlier::types::DataMatrix;
use nalgebra::Matrix3;

use crate::pose::{Pose, in_front};

/// Correspondences between two looks at the cost so far.
const BLOCK: usize = 32;
/// The looks give up beyond this multiple of the root of the number of rows so far. Costs are
/// between zero and one, and the rows are in random order: by Hoeffding's inequality a matrix that
/// costs less than the best one is given up at a look with a probability of at most
/// `exp(-CAUTION^2 / 2)`, 0.2 %.
const CAUTION: f64 = 3.5;

/// How well a matrix explains the data.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Score {
    /// The sum of the costs.
    pub cost: f64,
    /// Correspondences that cost less than one.
    pub inliers: usize,
}

impl PartialOrd for Score {
    /// The less the cost the better, and `inlier` takes the greater for the better.
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        other.cost.partial_cmp(&self.cost)
    }
}

/// The scoring of the loop. It remembers what the best matrix costs on the first rows: most
/// matrices of samples are given up after few.
pub struct Msac {
    threshold: f64,
    best: RefCell<Best>,
}

/// The least cost, and what its matrix costs up to the end of each block.
struct Best {
    cost: f64,
    up_to: Vec<f64>,
}

impl Msac {
    /// The threshold is a length in an image at a focal length of one.
    pub fn new(threshold: f64) -> Self {
        Self { threshold, best: RefCell::new(Best { cost: f64::INFINITY, up_to: Vec::new() }) }
    }
}

impl Scoring<Matrix3<f64>> for &Msac {
    type Score = Score;

    fn threshold(&self) -> f64 {
        self.threshold
    }

    fn score(&self, data: &DataMatrix, essential: &Matrix3<f64>, inliers: &mut Vec<usize>) -> Score {
        inliers.clear();
        let worst = Score { cost: f64::INFINITY, inliers: 0 };
        let mut best = self.best.borrow_mut();
        let Some(up_to) = costs(&best, data, essential, self.threshold) else { return worst };
        inliers.extend(within(data, essential, self.threshold));
        let Some(pose) = Pose::from_essential(essential, data, inliers) else { return worst };
        let mut cost = up_to.last().copied().unwrap_or_default();
        inliers.retain(|&row| {
            let keep = in_front(&pose, data, row);
            if !keep {
                cost += 1.0 - squared_error(data, essential, row) / self.threshold.powi(2);
            }
            keep
        });
        if cost < best.cost {
            *best = Best { cost, up_to };
        }
        Score { cost, inliers: inliers.len() }
    }
}

/// The rows of the data with Sampson errors below the threshold.
pub fn within(data: &DataMatrix, essential: &Matrix3<f64>, threshold: f64) -> impl Iterator<Item = usize> {
    (0..data.nrows()).filter(move |&row| squared_error(data, essential, row) < threshold.powi(2))
}

/// The squared Sampson error of one correspondence.
pub fn squared_error(data: &DataMatrix, essential: &Matrix3<f64>, row: usize) -> f64 {
    squared(essential, [0, 1, 2, 3].map(|column| data[(row, column)]))
}

/// The costs up to the end of each block, or nothing as soon as they are too far above the best.
fn costs(best: &Best, data: &DataMatrix, essential: &Matrix3<f64>, threshold: f64) -> Option<Vec<f64>> {
    let mut chunks = data.as_slice().chunks_exact(data.nrows());
    let columns: [&[f64]; 4] = [(); 4].map(|()| chunks.next().unwrap_or_default());
    let (inverse, mut total, mut up_to) = (threshold.powi(-2), 0.0, Vec::new());
    for (block, start) in (0..data.nrows()).step_by(BLOCK).enumerate() {
        let end = (start + BLOCK).min(data.nrows());
        let [a, b, c, d] = columns.map(|column| &column[start..end]);
        let mut costs = [0.0; BLOCK];
        for (cost, (((&a, &b), &c), &d)) in costs.iter_mut().zip(a.iter().zip(b).zip(c).zip(d)) {
            *cost = (squared(essential, [a, b, c, d]) * inverse).min(1.0);
        }
        // Four sums side by side, which the processor adds at once.
        let sums = costs.chunks_exact(4).fold([0.0; 4], |s, c| [s[0] + c[0], s[1] + c[1], s[2] + c[2], s[3] + c[3]]);
        total += sums.iter().sum::<f64>();
        let of_best = best.up_to.get(block).copied().unwrap_or(f64::INFINITY);
        if total >= best.cost || total > of_best + CAUTION * (end as f64).sqrt() {
            return None;
        }
        up_to.push(total);
    }
    Some(up_to)
}

#[inline(always)]
fn squared(e: &Matrix3<f64>, [a, b, c, d]: [f64; 4]) -> f64 {
    let lines = [0, 1, 2].map(|k| e[(k, 0)] * a + e[(k, 1)] * b + e[(k, 2)]);
    let back = [0, 1].map(|k| e[(0, k)] * c + e[(1, k)] * d + e[(2, k)]);
    let algebraic = c * lines[0] + d * lines[1] + lines[2];
    algebraic * algebraic / (lines[0] * lines[0] + lines[1] * lines[1] + back[0] * back[0] + back[1] * back[1])
}
