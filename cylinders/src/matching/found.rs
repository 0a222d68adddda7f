//! The cylinders that were found, with their silhouettes.

use crate::observations::scene::LineId;
use crate::space::cylinder::{Cylinder, LineResidual};

/// A cylinder and its silhouettes among the lines.
#[derive(Clone, Debug, PartialEq)]
pub struct MatchedCylinder {
    /// Least squares cylinder of its matches.
    pub cylinder: Cylinder,
    /// Root mean square distance between matches and circle in the cross-section, world units.
    pub rms: f64,
    /// Its silhouettes, in the order of views and lines, at most one for each side in a view.
    pub matches: Vec<LineResidual>,
    /// Part of all lines that are not its silhouettes.
    pub outlier_rate: f64,
    /// Expected number of cylinders with matches as many and as near, if the lines that were left
    /// when it was found were in no order.
    pub false_alarms: f64,
}

/// All cylinders that were found.
#[derive(Clone, Debug, PartialEq)]
pub struct Matching {
    /// The cylinders, the best supported first.
    pub cylinders: Vec<MatchedCylinder>,
    /// Lines of no cylinder, in the order of views and lines.
    pub unmatched: Vec<LineId>,
    /// Least number of matches that was asked of a cylinder, at the end.
    pub least_support: usize,
}
