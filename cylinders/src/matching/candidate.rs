//! Cylinders along a direction that is only supposed: lines agree on it, but perhaps not those of
//! cylinders.
//!
//! What is no cylinder must not win:
//!
//! - A cylinder needs two lines on each side, further apart than the threshold can tell: what is
//!   seen as one line in each image has no width.
//! - Matching keeps what chance gives less than once among random lines. Lines of a texture are not
//!   random, and several directions are tried: a direction needs a cylinder with far fewer false
//!   alarms, and with both silhouettes in two images. Where each cylinder has few lines, those that
//!   must be round may have so few false alarms together. Then it is a direction of cylinders, and
//!   for the others along it matching is enough.

use nalgebra::{Unit, Vector3};

use super::chance::joint_false_alarms;
use super::error::MatchError;
use super::found::{MatchedCylinder, Matching};
use super::options::{LEAST_WIDTH, MatchOptions};
use super::plan::threshold;
use super::search::{Progress, match_cylinders_with};
use crate::observations::view::View;
use crate::space::cylinder::{LineResidual, Side};

/// Least number of lines on each side of a cylinder, and of images that show both silhouettes of
/// one that makes a direction one of cylinders.
const BOTH_SIDES: usize = 2;

/// Like [`match_cylinders_with`], for a direction that is not known to be one of cylinders. Those
/// that are found must say so themselves, with at most `options.direction_false_alarms`: one of
/// them, or all that must be round together. If their number is given, all that are found count.
///
/// # Errors
/// [`MatchError`].
pub fn match_candidate_with(
    views: &[View],
    direction: &Unit<Vector3<f64>>,
    options: &MatchOptions,
    progress: &(dyn Fn(Progress) + Sync),
) -> Result<Matching, MatchError> {
    let mut matching = match_cylinders_with(views, direction, options, progress)?;
    if options.count.is_some() {
        return Ok(matching);
    }
    let lines = |found: &MatchedCylinder| found.matches.iter().map(LineResidual::id).collect::<Vec<_>>();
    let (cylinders, others): (Vec<_>, Vec<_>) =
        matching.cylinders.into_iter().partition(|found| is_wide(found, views, options));
    let decides =
        |found: &MatchedCylinder| found.false_alarms <= options.direction_false_alarms && shows_both_sides(found);
    if !cylinders.iter().any(decides) && !has_round(&cylinders, views, options) {
        let lines = views.iter().map(|view| view.lines().len()).sum();
        return Err(MatchError::NoCylinder { least_support: matching.least_support, lines });
    }
    matching.unmatched.extend(others.iter().flat_map(lines));
    matching.unmatched.sort_unstable_by_key(|id| (id.view, id.line));
    Ok(Matching { cylinders, ..matching })
}

/// Whether the cylinders that must be round are no chance, one of them or all together.
pub(super) fn has_round(cylinders: &[MatchedCylinder], views: &[View], options: &MatchOptions) -> bool {
    let round = cylinders.iter().filter(|found| shows_both_sides(found) && found.is_round(views));
    let round: Vec<f64> = round.map(|found| found.false_alarms).collect();
    let is_no_chance = |false_alarms: f64| false_alarms <= options.direction_false_alarms;
    round.iter().any(|alone| is_no_chance(*alone)) || is_no_chance(joint_false_alarms(&round))
}

/// Whether a cylinder has lines on both sides that are apart from each other.
fn is_wide(found: &MatchedCylinder, views: &[View], options: &MatchOptions) -> bool {
    let is_apart = |line: &&LineResidual| {
        let camera = views[line.view].camera();
        let distance = found.cylinder.vector_to_axis(&camera.centre()).norm();
        // The search has refused thresholds that are no angles.
        threshold(line.view, camera, options)
            .is_ok_and(|threshold| found.cylinder.radius >= LEAST_WIDTH * threshold * distance)
    };
    let apart: Vec<_> = found.matches.iter().filter(is_apart).collect();
    let on = |side: Side| apart.iter().filter(|line| line.side == side).count();
    on(Side::Left) >= BOTH_SIDES && on(Side::Right) >= BOTH_SIDES
}

/// Whether enough images show both silhouettes.
fn shows_both_sides(found: &MatchedCylinder) -> bool {
    // Matches are in the order of the views, two at most in each.
    found.matches.windows(2).filter(|pair| pair[0].view == pair[1].view).count() >= BOTH_SIDES
}
