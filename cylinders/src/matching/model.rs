//! A circle of the cross-section with its matches.

use nalgebra::{Unit, Vector3};

use super::found::MatchedCylinder;
use super::plan::{Plan, PlanMatch};
use crate::cross_section::circle::{Circle, CircleFit, fit_circle};
use crate::observations::scene::LineId;
use crate::observations::view::View;
use crate::space::cylinder::{Cylinder, LineResidual};

/// Limit on the repetitions of fit and choice of matches. They agree after two or three.
const REPETITIONS: usize = 10;

/// A circle of the cross-section with its matches.
pub(super) struct Model {
    pub(super) fit: CircleFit,
    pub(super) matches: Vec<PlanMatch>,
    pub(super) false_alarms: f64,
}

impl Model {
    pub(super) fn in_space(
        &self,
        views: &[View],
        plan: &Plan,
        direction: &Unit<Vector3<f64>>,
        lines: usize,
    ) -> MatchedCylinder {
        let cylinder = Cylinder::from_circle(&self.fit.circle, plan.rectification(), *direction);
        let residual = |found: &PlanMatch| {
            let LineId { view, line } = plan.id(found.line);
            // No camera of a match is inside the cylinder.
            let residuals = cylinder.residuals(view, &views[view])?;
            Some(LineResidual { side: found.side, ..residuals[line] })
        };
        MatchedCylinder {
            cylinder,
            rms: self.fit.rms,
            matches: self.matches.iter().filter_map(residual).collect(),
            outlier_rate: 1.0 - self.matches.len() as f64 / lines as f64,
            false_alarms: self.false_alarms,
        }
    }
}

/// The circle that fits its matches best, fitted and matched in turn while the support increases.
/// `None` if no circle can be fitted to the matches.
pub(super) fn fitted(plan: &Plan, circle: Circle) -> Option<Model> {
    let fit = |circle: &Circle| {
        let matches = plan.matches(circle);
        let lines: Vec<_> = matches.iter().map(|line| plan.tangent_line(line.line)).collect();
        Some(Model { fit: fit_circle(&lines, plan.extent()).ok()?, matches, false_alarms: f64::INFINITY })
    };
    let mut model = fit(&circle)?;
    for _ in 0..REPETITIONS {
        match fit(&model.fit.circle) {
            Some(next) if next.matches.len() >= model.matches.len() && next.matches != model.matches => model = next,
            _ => break,
        }
    }
    // The last fit may have moved the circle away from some matches.
    model.matches = plan.matches(&model.fit.circle);
    Some(model)
}
