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
#[derive(Clone)]
pub(super) struct Model {
    pub(super) fit: CircleFit,
    pub(super) matches: Vec<PlanMatch>,
    /// Natural logarithm of the number of false alarms.
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
            false_alarms: self.false_alarms.exp(),
        }
    }
}

/// The circle that fits its matches best, fitted and matched in turn while the support increases.
/// `None` if no circle can be fitted to the matches.
pub(super) fn fitted(plan: &Plan, circle: Circle) -> Option<CircleFit> {
    let fit = |circle: &Circle| {
        let matches = plan.matches(circle, 1.0);
        let lines: Vec<_> = matches.iter().map(|line| plan.tangent_line(line.line)).collect();
        Some((fit_circle(&lines, plan.extent()).ok()?, matches))
    };
    let (mut best, mut matches) = fit(&circle)?;
    for _ in 0..REPETITIONS {
        match fit(&best.circle) {
            Some((next, more)) if more.len() >= matches.len() && more != matches => (best, matches) = (next, more),
            _ => break,
        }
    }
    Some(best)
}
