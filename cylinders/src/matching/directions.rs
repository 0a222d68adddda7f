//! Candidates of the directions of the axes: the directions in space on which many lines agree, one
//! after the other, each without the lines of those before.
//!
//! A direction is along a random viewing plane within the angle `t` with the probability `sin(t)`.
//! Two of `n` lines determine a direction, so that the expected number of directions on which `k`
//! or more lines agree by chance is at most
//!
//! ```text
//!   false alarms = n (n - 1) / 2 * P(B >= k - 2),    B binomial: n - 2 trials, probability sin(t)
//! ```

use nalgebra::{Unit, Vector3};

use super::chance::{FALSE_ALARMS, tail};
use crate::axis::robust_direction::{default_direction_options, estimate_direction_robustly};
use crate::numerics::interrupt::Interrupt;
use crate::numerics::ransac::RansacOptions;
use crate::observations::view::View;

/// Directions that differ by less than this sine are one.
const SAME: f64 = 0.05;

/// Whether a direction is one of some others.
pub(super) fn is_known(direction: &Unit<Vector3<f64>>, others: &[Unit<Vector3<f64>>]) -> bool {
    others.iter().any(|other| other.cross(direction).norm() <= SAME)
}

/// Up to `count` directions on which more lines agree than by chance, those with the most lines
/// first. There are fewer after an interruption.
pub fn candidate_directions(views: &[View], count: usize, interrupt: Interrupt<'_>) -> Vec<Unit<Vector3<f64>>> {
    let options = RansacOptions { interrupt, ..default_direction_options() };
    let mut planes: Vec<_> = views.iter().flat_map(View::planes).collect();
    let mut found: Vec<Unit<Vector3<f64>>> = Vec::new();
    // A direction may be found twice, so there are more attempts than directions.
    for _ in 0..2 * count {
        if found.len() == count {
            break;
        }
        let Ok(best) = estimate_direction_robustly(&planes, &options) else { break };
        if false_alarms(planes.len(), best.inliers.len(), options.threshold.sin()) > FALSE_ALARMS {
            break;
        }
        let direction = best.direction.direction;
        if !is_known(&direction, &found) {
            found.push(direction);
        }
        let mut index = 0;
        planes.retain(|_| {
            index += 1;
            best.inliers.binary_search(&(index - 1)).is_err()
        });
    }
    found
}

/// Expected number of directions on which so many of the lines agree by chance.
fn false_alarms(lines: usize, agreeing: usize, probability: f64) -> f64 {
    let pairs = lines as f64 * (lines as f64 - 1.0) / 2.0;
    pairs * tail(lines - 2, agreeing - 2, probability)
}
