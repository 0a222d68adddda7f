//! Cylinders along each candidate of their direction, and the direction with the most evidence.
//!
//! What is no cylinder must not win:
//!
//! - Only lines whose viewing plane is along the direction are matched, the longest of each image.
//! - An edge of a texture is a cylinder without width: one line in each image. A cylinder needs two
//!   images that show both its silhouettes, further apart than the threshold can tell.
//! - Matching keeps what chance gives less than once among random lines. Lines of a texture are not
//!   random, and several directions are tried: a direction needs a cylinder with 1e-4 false alarms
//!   or fewer. Then it is that of cylinders, and for the others along it matching is enough.
//! - The lines of edges in space are left out (`edges`).
//! - The evidence for a direction is the sum of the orders of magnitude by which the matches of its
//!   cylinders are no chance.

use std::collections::HashSet;

use nalgebra::{Unit, Vector3};

use super::edges::edge_lines;
use super::lines::Seen;
use super::pairs::cylinders_of_ribbons;
use crate::matching::selection::Selection;
use crate::matching::{MatchError, MatchOptions, MatchedCylinder, Matching, match_cylinders, match_directions_with};
use crate::observations::scene::LineId;
use crate::observations::view::{View, ViewingPlane};
use crate::space::cylinder::LineResidual;
use crate::space::silhouette_distance::DistanceUnit;

/// Largest sine between a viewing plane and the axis of which it is a silhouette.
const MAX_TILT: f64 = 0.03;

/// Default of the largest distance between a line and its silhouette, pixels.
const THRESHOLD: f64 = 2.0;

/// Least number of images that show both silhouettes of a cylinder.
const BOTH_SIDES: usize = 2;

/// Least distance of the silhouettes of a cylinder from its axis, in thresholds.
const LEAST_WIDTH: f64 = 2.0;

/// Default of the largest number of false alarms of the best cylinder of a direction. Edges of a
/// texture are not independent of each other, as the number supposes: a rendered floor without
/// cylinders has reached it. Small scenes with cylinders are lost at 1e-8.
const FALSE_ALARMS: f64 = 1e-4;

/// How cylinders are searched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhotoOptions<'a> {
    /// Options of the matching. Its interruption ends all of the search.
    pub matching: MatchOptions<'a>,
    /// Largest number of directions of cylinders.
    pub directions: usize,
    /// Largest number of lines of an image along one direction. The longest count.
    pub lines: usize,
    /// Largest number of false alarms of the least doubtful cylinder of a direction.
    pub false_alarms: f64,
}

impl PhotoOptions<'_> {
    /// Options for these views: 5 directions, 60 lines of each image, at most 1e-4 false alarms of
    /// a direction, and a threshold of 2 pixels if all cameras have a calibration.
    pub fn of(views: &[View]) -> Self {
        let mut matching = MatchOptions::of(views);
        if matching.unit == DistanceUnit::Pixels {
            matching.threshold = THRESHOLD;
        }
        Self { matching, directions: 5, lines: 60, false_alarms: FALSE_ALARMS }
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

/// All lines of some views.
fn lines(views: &[View]) -> Vec<LineId> {
    let ids = |(view, content): (usize, &View)| (0..content.lines().len()).map(move |line| LineId { view, line });
    views.iter().enumerate().flat_map(ids).collect()
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
            match_directions_with(views, options.directions, options.matching.interrupt, along)
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
    // An edge is seen twice as precisely as the threshold asks.
    let tolerances: Vec<_> =
        all.iter().map(|view| 0.5 * options.matching.threshold / focal(view, &options.matching)).collect();
    let near = Selection::new(all, usize::MAX, |_, plane| is_along(plane));
    let edges = near.ids_in_all(edge_lines(&near.views, direction, &tolerances));
    // The longest lines come first in a view.
    let selection = Selection::new(all, options.lines, |id, plane| is_along(plane) && !edges.contains(&id));
    let views = &selection.views;
    let Matching { cylinders, least_support, .. } = match_cylinders(views, direction, &options.matching)?;
    let is_found = |found: &MatchedCylinder| is_cylinder(found, views, &options.matching);
    let cylinders: Vec<_> = cylinders.into_iter().filter(is_found).collect();
    if !cylinders.iter().any(|found| found.false_alarms <= options.false_alarms) {
        return Err(MatchError::NoCylinder { least_support, lines: lines(views).len() });
    }
    let cylinders = selection.in_all(cylinders);
    let taken: HashSet<LineId> = cylinders.iter().flat_map(|found| &found.matches).map(LineResidual::id).collect();
    let unmatched = lines(all).into_iter().filter(|id| !taken.contains(id)).collect();
    Ok(Matching { directions: vec![*direction], cylinders, unmatched, least_support })
}

/// Whether enough images show both silhouettes apart from each other.
fn is_cylinder(found: &MatchedCylinder, views: &[View], options: &MatchOptions) -> bool {
    // Matches are in the order of the views, two at most in each.
    let both = found.matches.windows(2).filter(|pair| pair[0].view == pair[1].view);
    let is_wide = |pair: &&[LineResidual]| {
        let view = &views[pair[0].view];
        let distance = found.cylinder.vector_to_axis(&view.camera().centre()).norm();
        focal(view, options) * (found.cylinder.radius / distance) >= LEAST_WIDTH * options.threshold
    };
    both.filter(is_wide).count() >= BOTH_SIDES
}

/// Units of the threshold in a radian.
fn focal(view: &View, options: &MatchOptions) -> f64 {
    match (options.unit, view.camera().calibration()) {
        (DistanceUnit::Pixels, Some(calibration)) => calibration.matrix()[(0, 0)].abs(),
        _ => 1.0,
    }
}
