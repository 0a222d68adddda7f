//! Cylinders of several directions: the direction with the most evidence for cylinders first, then
//! the next one among the lines that are left. A line is used once. Along a direction of texture
//! there are flat bands, along one of cylinders there are some that must be round: if there are
//! such directions, no others count.

use std::cmp::Ordering;

use nalgebra::{Unit, Vector3};

use super::candidate::{has_round, match_candidate_with};
use super::directions::{candidate_directions, is_known};
use super::error::MatchError;
use super::found::{MatchedCylinder, Matching};
use super::options::MatchOptions;
use super::selection::Selection;
use crate::axis::direction::estimate_direction;
use crate::observations::scene::LineId;
use crate::observations::view::View;

/// Number of directions that are tried at a time.
const CANDIDATES: usize = 5;

/// A direction is improved by the lines of its cylinders if it changes by more than this angle,
/// radians: half a pixel at a focal length of 1000.
const CHANGE: f64 = 5e-4;

/// Finds all cylinders of all directions among lines without labels, and the lines that are their
/// silhouettes. Directions that differ by less than three degrees are one. Each must be one of
/// cylinders by what is found along it: see [`match_candidate_with`].
///
/// # Errors
/// [`MatchError`]: that of the direction on which most lines agree if no direction has cylinders.
pub fn match_directions(views: &[View], options: &MatchOptions) -> Result<Matching, MatchError> {
    match_directions_with(views, usize::MAX, options, |views, direction| {
        match_candidate_with(views, direction, options, &|_| {})
    })
}

/// Like [`match_directions`], with at most `count` directions and any search along one direction,
/// which ends itself after an interruption. Of the options only `interrupt` and
/// `direction_false_alarms` are used here.
///
/// # Errors
/// [`MatchError`], as the search gives it.
pub fn match_directions_with(
    views: &[View],
    count: usize,
    options: &MatchOptions,
    search: impl Fn(&[View], &Unit<Vector3<f64>>) -> Result<Matching, MatchError>,
) -> Result<Matching, MatchError> {
    let (free, tried, queue) = (all(views), Vec::new(), Vec::new());
    let mut progress = Progress { views, search, options, free, tried, queue, error: None };
    let mut found = Matching { directions: Vec::new(), cylinders: Vec::new(), unmatched: Vec::new(), least_support: 0 };
    let mut any_round = false;
    while found.directions.len() < count {
        let Some((direction, matching)) = progress.next() else { break };
        let is_round = has_round(&matching.cylinders, views, options);
        if found.directions.is_empty() {
            any_round = is_round;
        }
        if any_round && !is_round {
            // It may have lost lines to others since it was searched; the next one may be round.
            continue;
        }
        progress.take(&matching.cylinders);
        found.least_support = match found.least_support {
            0 => matching.least_support,
            known => known.min(matching.least_support),
        };
        found.directions.push(direction);
        found.cylinders.extend(matching.cylinders);
    }
    // What was interrupted found nothing.
    options.interrupt.check()?;
    if found.cylinders.is_empty() {
        // There is no direction if no two lines are left.
        return Err(progress.error.unwrap_or(MatchError::TooFewViews { views: 0 }));
    }
    found.unmatched = progress.free_lines();
    Ok(found.among(views.iter().map(|view| view.lines().len()).sum()))
}

/// Orders of magnitude by which the matches are no chance.
pub(super) fn evidence(matching: &Matching) -> f64 {
    let of_cylinder = |found: &MatchedCylinder| -found.false_alarms.max(f64::MIN_POSITIVE).log10();
    matching.cylinders.iter().map(of_cylinder).sum()
}

/// Which lines are free: all of them.
fn all(views: &[View]) -> Vec<Vec<bool>> {
    views.iter().map(|view| vec![true; view.lines().len()]).collect()
}

/// A direction with its cylinders.
type Found = (Unit<Vector3<f64>>, Matching);

struct Progress<'a, S> {
    views: &'a [View],
    search: S,
    options: &'a MatchOptions<'a>,
    /// Whether each line of each view belongs to no cylinder found so far.
    free: Vec<Vec<bool>>,
    /// All directions that were searched.
    tried: Vec<Unit<Vector3<f64>>>,
    /// Directions that had cylinders when they were searched.
    queue: Vec<Found>,
    /// The first failure.
    error: Option<MatchError>,
}

impl<S: Fn(&[View], &Unit<Vector3<f64>>) -> Result<Matching, MatchError>> Progress<'_, S> {
    /// The direction with the most evidence for cylinders among the free lines.
    fn next(&mut self) -> Option<Found> {
        self.try_candidates();
        loop {
            let most =
                (0..self.queue.len()).max_by(|&one, &other| self.compare(&self.queue[one].1, &self.queue[other].1))?;
            let (direction, matching) = self.queue.swap_remove(most);
            // Other cylinders may have taken some of its lines.
            let is_free = matching.cylinders.iter().flat_map(|found| &found.matches);
            let is_free = is_free.into_iter().all(|line| self.free[line.view][line.line]);
            let matching = if is_free { Some(matching) } else { self.along(&direction).ok() };
            if let Some(matching) = matching {
                return Some(self.improved(direction, matching));
            }
        }
    }

    /// Directions with a cylinder that must be round come before others.
    fn compare(&self, one: &Matching, other: &Matching) -> Ordering {
        let [first, second] = [one, other].map(|matching| has_round(&matching.cylinders, self.views, self.options));
        first.cmp(&second).then(evidence(one).total_cmp(&evidence(other)))
    }

    /// Searches the candidates that were not searched before; at first also that of all lines, if
    /// no other has cylinders.
    fn try_candidates(&mut self) {
        let selection = self.selection();
        let mut candidates = candidate_directions(&selection.views, CANDIDATES, self.options.interrupt);
        if self.tried.is_empty() {
            let planes: Vec<_> = self.views.iter().flat_map(View::planes).collect();
            candidates.extend(estimate_direction(&planes).ok().map(|of_all| of_all.direction));
        }
        for direction in candidates {
            if is_known(&direction, &self.tried) {
                continue;
            }
            self.tried.push(direction);
            match self.along(&direction) {
                Ok(matching) => self.queue.push((direction, matching)),
                Err(error) => self.error = self.error.or(Some(error)),
            }
        }
    }

    /// The cylinders along the direction that their lines have, if there is more evidence for them:
    /// lines of cylinders determine their direction better than all lines do.
    fn improved(&self, direction: Unit<Vector3<f64>>, matching: Matching) -> Found {
        let lines = matching.cylinders.iter().flat_map(|found| &found.matches);
        let planes: Vec<_> = lines.filter_map(|line| self.views[line.view].planes().nth(line.line)).collect();
        let Ok(better) = estimate_direction(&planes) else { return (direction, matching) };
        let better = better.direction;
        if better.cross(&direction).norm() <= CHANGE {
            return (direction, matching);
        }
        match self.along(&better) {
            Ok(again) if evidence(&again) > evidence(&matching) => (better, again),
            _ => (direction, matching),
        }
    }

    fn along(&self, direction: &Unit<Vector3<f64>>) -> Result<Matching, MatchError> {
        self.options.interrupt.check()?;
        let selection = self.selection();
        let matching = (self.search)(&selection.views, direction)?;
        Ok(Matching { cylinders: selection.in_all(matching.cylinders), ..matching })
    }

    fn selection(&self) -> Selection {
        Selection::new(self.views, usize::MAX, |LineId { view, line }, _| self.free[view][line])
    }

    fn take(&mut self, cylinders: &[MatchedCylinder]) {
        for line in cylinders.iter().flat_map(|found| &found.matches) {
            self.free[line.view][line.line] = false;
        }
    }

    fn free_lines(&self) -> Vec<LineId> {
        let of_view = |(view, free): (usize, &Vec<bool>)| {
            let lines = free.iter().enumerate().filter(|(_, free)| **free);
            lines.map(|(line, _)| LineId { view, line }).collect::<Vec<_>>()
        };
        self.free.iter().enumerate().flat_map(of_view).collect()
    }
}
