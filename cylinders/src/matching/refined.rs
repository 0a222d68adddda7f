//! Cylinders that were found among lines without labels, refined on their matches.
//!
//! Those of one direction are refined with that direction in common, unless their lines say
//! otherwise; all on the points of the scene, too, if these are asked.

use nalgebra::Point3;

use super::found::{MatchedCylinder, Matching};
use crate::estimation::estimate::{Estimate, estimate_from};
use crate::estimation::joint::Radii;
use crate::estimation::joint_estimate::{JointEstimate, JointMethod, parallel_from};
use crate::estimation::loss::Loss;
use crate::estimation::refine_error::RefineError;
use crate::estimation::surface_points::with_points;
use crate::numerics::interrupt::{Interrupt, Interrupted};
use crate::observations::scene::CylinderLines;
use crate::observations::view::View;

/// A cylinder, refined.
#[derive(Clone, Debug)]
pub struct RefinedMatch {
    /// Its matches; the number of the cylinder, from 1, is their label.
    pub lines: CylinderLines,
    /// The estimate, or why it could not be refined.
    pub estimate: Result<Estimate, RefineError>,
    /// Whether the direction is shared with the others of its direction.
    pub is_parallel: bool,
}

/// Refines the cylinders of a matching in these views. `points` are evidence, too; there may be
/// none.
///
/// # Errors
/// [`Interrupted`] between cylinders or between the steps of joint refinements.
pub fn refined_matches(
    views: &[View],
    matching: &Matching,
    points: &[Point3<f64>],
    interrupt: Interrupt<'_>,
) -> Result<Vec<RefinedMatch>, Interrupted> {
    let mut refined = Vec::with_capacity(matching.cylinders.len());
    let is_same = |a: &MatchedCylinder, b: &MatchedCylinder| a.cylinder.direction == b.cylinder.direction;
    for of_direction in matching.cylinders.chunk_by(is_same) {
        let first = refined.len();
        for (found, number) in of_direction.iter().zip(first + 1..) {
            interrupt.check()?;
            let lines = found.lines(views, &number.to_string());
            let estimate = estimate_from(&lines.views, &found.cylinder);
            refined.push(RefinedMatch { lines, estimate, is_parallel: false });
        }
        together(&mut refined[first..], points, interrupt);
    }
    interrupt.check()?;
    Ok(refined)
}

/// Refines the cylinders of one direction together, where that can be.
fn together(refined: &mut [RefinedMatch], points: &[Point3<f64>], interrupt: Interrupt<'_>) {
    let mut good: Vec<&mut RefinedMatch> = refined.iter_mut().filter(|one| one.estimate.is_ok()).collect();
    let views: Vec<Vec<View>> = good.iter().map(|one| one.lines.views.clone()).collect();
    let own: Vec<Estimate> = good.iter().filter_map(|one| one.estimate.clone().ok()).collect();
    let shared = parallel_from(&own, &views, interrupt);
    let is_parallel = shared.is_some();
    let mut estimates = shared.unwrap_or(own);
    if !points.is_empty() {
        let refinement = Some((Radii::Own, Loss::Quadratic));
        let method = JointMethod { parallel: is_parallel, refinement, interrupt };
        // Where points and lines do not determine the cylinders together, lines have to do.
        let joint = JointEstimate { cylinders: estimates.clone(), radius: None };
        if let Ok(joint) = with_points(joint, &views, points, &method) {
            estimates = joint.cylinders;
        }
    }
    for (one, estimate) in good.iter_mut().zip(estimates) {
        one.estimate = Ok(estimate);
        one.is_parallel = is_parallel;
    }
}
