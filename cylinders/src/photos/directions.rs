//! Candidates of the direction of the axes: the directions in space on which many lines agree, one
//! after the other, each without the lines of those before.

use nalgebra::{Unit, Vector3};

use crate::axis::robust_direction::{default_direction_options, estimate_direction_robustly};
use crate::observations::view::View;

/// Directions that differ by less than this sine are one.
const SAME: f64 = 0.05;

/// Up to `count` directions on which many lines agree, those with the most lines first.
pub fn candidate_directions(views: &[View], count: usize) -> Vec<Unit<Vector3<f64>>> {
    let mut planes: Vec<_> = views.iter().flat_map(View::planes).collect();
    let mut found: Vec<Unit<Vector3<f64>>> = Vec::new();
    // A direction may be found twice, so there are more attempts than directions.
    for _ in 0..2 * count {
        if found.len() == count {
            break;
        }
        let Ok(best) = estimate_direction_robustly(&planes, &default_direction_options()) else { break };
        let direction = best.direction.direction;
        if found.iter().all(|other| other.cross(&direction).norm() > SAME) {
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
