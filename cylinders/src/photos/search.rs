//! Cylinders along each candidate of their direction, and the direction with the most evidence.

use nalgebra::{Unit, Vector3};

use super::directions::candidate_directions;
use crate::matching::{MatchError, MatchOptions, Matching, match_cylinders};
use crate::observations::view::View;

/// Largest sine between a viewing plane and the axis of which it is a silhouette.
const MAX_TILT: f64 = 0.03;

/// How cylinders are searched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhotoOptions {
    /// Options of the matching.
    pub matching: MatchOptions,
    /// Number of directions that are tried.
    pub directions: usize,
    /// Largest number of lines of an image along one direction, the longest.
    pub lines: usize,
}

impl PhotoOptions {
    /// Options for these views.
    pub fn of(views: &[View]) -> Self {
        Self { matching: MatchOptions { threshold: 2.0, ..MatchOptions::of(views) }, directions: 5, lines: 60 }
    }
}

/// Cylinders of one direction and the lines that were searched.
#[derive(Clone, Debug)]
pub struct PhotoMatching {
    /// Direction of all axes.
    pub direction: Unit<Vector3<f64>>,
    /// The views with the lines along the direction only.
    pub views: Vec<View>,
    /// The cylinders; places of lines are those in `views`.
    pub matching: Matching,
}

/// The cylinders along the direction with the most evidence.
///
/// # Errors
/// [`MatchError`]: that of the first direction if no direction has cylinders.
pub fn find_cylinders(views: &[View], given: Option<Unit<Vector3<f64>>>, options: &PhotoOptions) -> Result<PhotoMatching, MatchError> {
    let directions = given.map_or_else(|| candidate_directions(views, options.directions), |given| vec![given]);
    let mut best: Result<PhotoMatching, MatchError> = Err(MatchError::NoPair);
    for direction in directions {
        let views = along(views, &direction, options.lines);
        let found = match_cylinders(&views, &direction, &options.matching)
            .map(|matching| PhotoMatching { direction, views, matching });
        let is_better = match (&best, &found) {
            (Ok(best), Ok(found)) => evidence(found) > evidence(best),
            (Err(_), Ok(_)) => true,
            _ => false,
        };
        if is_better || best == Err(MatchError::NoPair) {
            best = found;
        }
    }
    best
}

impl PartialEq for PhotoMatching {
    fn eq(&self, other: &Self) -> bool {
        self.direction == other.direction && self.matching == other.matching
    }
}

/// Orders of magnitude by which the matches are no chance.
pub(super) fn evidence(found: &PhotoMatching) -> f64 {
    found.matching.cylinders.iter().map(|cylinder| -cylinder.false_alarms.max(1e-300).log10()).sum()
}

/// The views with the longest lines along a direction.
fn along(views: &[View], direction: &Unit<Vector3<f64>>, count: usize) -> Vec<View> {
    let near = |view: &View| {
        let planes = view.planes().enumerate().filter(|(_, plane)| plane.normal.dot(direction).abs() <= MAX_TILT);
        view.selected(&planes.map(|(line, _)| line).take(count).collect::<Vec<_>>())
    };
    views.iter().map(near).collect()
}
