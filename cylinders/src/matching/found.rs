//! The cylinders that were found, with their silhouettes.

use nalgebra::{Unit, Vector3};

use crate::observations::scene::{CylinderLines, LineId};
use crate::observations::view::View;
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
    /// The part of all lines that are not silhouettes of the cylinder.
    pub outlier_rate: f64,
    /// Expected number of cylinders with as many and as near matches, if the lines that remained
    /// when it was found were random.
    pub false_alarms: f64,
}

impl MatchedCylinder {
    /// Its silhouettes in the views of the search, under this label.
    pub fn lines(&self, views: &[View], label: &str) -> CylinderLines {
        let of_view = |view: usize| self.matches.iter().filter(move |line| line.view == view).map(|line| line.line);
        let selected = |(index, view): (usize, &View)| view.selected(&of_view(index).collect::<Vec<_>>());
        CylinderLines {
            label: Some(label.to_owned()),
            views: views.iter().enumerate().map(selected).collect(),
            lines: self.matches.iter().map(|&LineResidual { view, line, .. }| LineId { view, line }).collect(),
        }
    }
}

/// All cylinders that were found.
#[derive(Clone, Debug, PartialEq)]
pub struct Matching {
    /// The directions of the cylinders.
    pub directions: Vec<Unit<Vector3<f64>>>,
    /// The cylinders, direction by direction, the least likely by chance first.
    pub cylinders: Vec<MatchedCylinder>,
    /// Lines that belong to no cylinder, in the order of views and lines.
    pub unmatched: Vec<LineId>,
    /// Least number of matches that was required of a cylinder at the end.
    pub least_support: usize,
}

impl Matching {
    /// The same cylinders among so many lines.
    pub(crate) fn among(mut self, lines: usize) -> Self {
        for found in &mut self.cylinders {
            found.outlier_rate = 1.0 - found.matches.len() as f64 / lines as f64;
        }
        self
    }
}
