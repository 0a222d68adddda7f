//! A part of the lines of some views.

use std::collections::HashSet;

use super::found::{MatchedCylinder, Matching};
use crate::observations::scene::LineId;
use crate::observations::view::{View, ViewingPlane};
use crate::space::cylinder::LineResidual;

/// All lines of some views.
pub(crate) fn lines(views: &[View]) -> Vec<LineId> {
    let ids = |(view, content): (usize, &View)| (0..content.lines().len()).map(move |line| LineId { view, line });
    views.iter().enumerate().flat_map(ids).collect()
}

/// Some of the lines of views, and their places there.
pub(crate) struct Selection {
    /// The views with these lines only.
    pub(crate) views: Vec<View>,
    /// The place of each line in its view.
    places: Vec<Vec<usize>>,
}

impl Selection {
    /// The lines that are kept by their place and viewing plane, at most `count` of each view.
    pub(crate) fn new(views: &[View], count: usize, keep: impl Fn(LineId, &ViewingPlane) -> bool) -> Self {
        let places = |(view, content): (usize, &View)| -> Vec<usize> {
            let planes = content.planes().enumerate();
            let kept = planes.filter(|(line, plane)| keep(LineId { view, line: *line }, plane));
            kept.map(|(line, _)| line).take(count).collect()
        };
        let places: Vec<_> = views.iter().enumerate().map(places).collect();
        let views = views.iter().zip(&places).map(|(view, places)| view.selected(places)).collect();
        Self { views, places }
    }

    /// What was found in the selection, with the places of its lines in all views.
    pub(crate) fn matching_in_all(&self, all: &[View], matching: Matching) -> Matching {
        let cylinders = self.in_all(matching.cylinders);
        let taken: HashSet<LineId> = cylinders.iter().flat_map(|found| &found.matches).map(LineResidual::id).collect();
        let lines = lines(all);
        let count = lines.len();
        let unmatched = lines.into_iter().filter(|id| !taken.contains(id)).collect();
        Matching { cylinders, unmatched, ..matching }.among(count)
    }

    /// Cylinders that were found in the selection, with the places of their lines in all views.
    pub(crate) fn in_all(&self, cylinders: Vec<MatchedCylinder>) -> Vec<MatchedCylinder> {
        let line = |found: LineResidual| LineResidual { line: self.places[found.view][found.line], ..found };
        let cylinder = |found: MatchedCylinder| MatchedCylinder {
            matches: found.matches.into_iter().map(line).collect(),
            ..found
        };
        cylinders.into_iter().map(cylinder).collect()
    }

    /// Cylinders that were found in all views, with the places of their lines in the selection.
    pub(crate) fn in_selection(&self, matching: Matching) -> Matching {
        let place = |view: usize, line: usize| self.places[view].iter().position(|&place| place == line);
        let cylinder = |found: MatchedCylinder| {
            let line = |line: LineResidual| Some(LineResidual { line: place(line.view, line.line)?, ..line });
            MatchedCylinder { matches: found.matches.into_iter().filter_map(line).collect(), ..found }
        };
        let unmatched = |id: LineId| Some(LineId { line: place(id.view, id.line)?, ..id });
        Matching {
            cylinders: matching.cylinders.into_iter().map(cylinder).collect(),
            unmatched: matching.unmatched.into_iter().filter_map(unmatched).collect(),
            ..matching
        }
    }
}
