//! Cylinders along each candidate of their direction, and the direction with the most evidence.
//!
//! Matching says what is no cylinder (`matching::candidate`, `matching::edges`). Here only lines
//! whose viewing plane is along the direction are matched, the longest of each image.

use std::collections::HashSet;

use nalgebra::{Unit, Vector3};

use super::lines::Seen;
use super::pairs::cylinders_of_ribbons;
use crate::matching::selection::{Selection, lines};
use crate::matching::{MatchError, MatchOptions, Matching, match_candidate_with, match_directions_with};
use crate::observations::scene::LineId;
use crate::observations::view::{View, ViewingPlane};
use crate::space::cylinder::LineResidual;
use crate::space::silhouette_distance::DistanceUnit;

/// Largest sine between a viewing plane and the axis of which it is a silhouette.
const MAX_TILT: f64 = 0.03;

/// Default of the largest distance between a line and its silhouette, pixels.
const THRESHOLD: f64 = 2.0;

/// Largest number of lines of an image along one direction. Detected lines are in the order of
/// their length, the longest first.
const LINES: usize = 60;

/// How cylinders are searched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhotoOptions<'a> {
    /// Options of the matching. Its interruption ends all of the search.
    pub matching: MatchOptions<'a>,
    /// Largest number of directions of cylinders.
    pub directions: usize,
}

impl PhotoOptions<'_> {
    /// Options for these views: 5 directions, 60 lines of each image, and a threshold of 2 pixels
    /// if all cameras have a calibration.
    pub fn of(views: &[View]) -> Self {
        let mut matching = MatchOptions::of(views);
        if matching.unit == DistanceUnit::Pixels {
            matching.threshold = THRESHOLD;
        }
        matching.lines = LINES;
        Self { matching, directions: 5 }
    }
}

/// Cylinders and the lines along their directions.
#[derive(Clone, Debug, PartialEq)]
pub struct PhotoMatching {
    /// The views with the lines along the directions only.
    pub views: Vec<View>,
    /// The cylinders; places of lines are those in `views`.
    pub matching: Matching,
}

/// The cylinders along the given direction, or of all directions for which there is evidence.
///
/// # Errors
/// [`MatchError`]: that of the first direction if no direction has cylinders.
pub fn find_cylinders(
    views: &[View],
    given: Option<Unit<Vector3<f64>>>,
    options: &PhotoOptions,
) -> Result<PhotoMatching, MatchError> {
    Ok(shown(views, by_directions(views, given, options)?))
}

/// The cylinders in photographs: those of [`find_cylinders`] and, if no direction is given, those
/// beside them whose silhouettes are ribbons of several images.
///
/// # Errors
/// [`MatchError`]: that of [`find_cylinders`] if there are none.
pub fn find_in_photographs(
    seen: &[Seen],
    given: Option<Unit<Vector3<f64>>>,
    options: &PhotoOptions,
) -> Result<PhotoMatching, MatchError> {
    let views: Vec<View> = seen.iter().map(|seen| seen.view.clone()).collect();
    let found = by_directions(&views, given, options);
    if given.is_some() {
        return Ok(shown(&views, found?));
    }
    let known = found.as_ref().map_or(&[][..], |matching| &matching.cylinders);
    let of_ribbons = cylinders_of_ribbons(seen, known, &options.matching);
    // What was interrupted found too few.
    options.matching.interrupt.check()?;
    let mut matching = match found {
        Err(error) if of_ribbons.is_empty() => return Err(error),
        Err(_) => {
            Matching { directions: Vec::new(), cylinders: Vec::new(), unmatched: lines(&views), least_support: 4 }
        }
        Ok(matching) => matching,
    };
    let taken: HashSet<LineId> = of_ribbons.iter().flat_map(|found| &found.matches).map(LineResidual::id).collect();
    matching.unmatched.retain(|line| !taken.contains(line));
    matching.directions.extend(of_ribbons.iter().map(|found| found.cylinder.direction));
    matching.cylinders.extend(of_ribbons);
    Ok(shown(&views, matching))
}

fn by_directions(
    views: &[View],
    given: Option<Unit<Vector3<f64>>>,
    options: &PhotoOptions,
) -> Result<Matching, MatchError> {
    match given {
        Some(direction) => find_along(views, &direction, options),
        None => {
            let along = |views: &[View], direction: &_| find_along(views, direction, options);
            match_directions_with(views, options.directions, &options.matching, along)
        }
    }
}

/// A matching with the lines along its directions only.
fn shown(views: &[View], matching: Matching) -> PhotoMatching {
    let is_along = |plane: &ViewingPlane| {
        matching.directions.iter().any(|direction| plane.normal.dot(direction).abs() <= MAX_TILT)
    };
    let matches = matching.cylinders.iter().flat_map(|found| &found.matches);
    let taken: HashSet<LineId> = matches.map(LineResidual::id).collect();
    let selection = Selection::new(views, usize::MAX, |id, plane| is_along(plane) || taken.contains(&id));
    let lines = selection.views.iter().map(|view| view.lines().len()).sum();
    let matching = selection.in_selection(matching).among(lines);
    PhotoMatching { views: selection.views, matching }
}

fn find_along(all: &[View], direction: &Unit<Vector3<f64>>, options: &PhotoOptions) -> Result<Matching, MatchError> {
    let is_along = |plane: &ViewingPlane| plane.normal.dot(direction).abs() <= MAX_TILT;
    let selection = Selection::new(all, usize::MAX, |_, plane| is_along(plane));
    let matching = match_candidate_with(&selection.views, direction, &options.matching, &|_| {})?;
    Ok(selection.matching_in_all(all, matching))
}
