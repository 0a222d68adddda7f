//! Cylinders that were found among lines without labels, for the subcommands that search.

use nalgebra::Point3;

use super::output::Output;
use crate::matching::{RefinedMatch, refined_matches};
use crate::matching_report::MatchingReport;
use crate::page::Table;
use crate::report::Report;
use crate::report_table::{cylinder_table, residual_table};
use crate::{Cylinder, CylinderLines, Interrupt, Matching, Scene, View};

/// What was found, in the forms that subcommands show.
pub(super) struct Found {
    pub(super) output: Output,
    pub(super) scene: Scene,
    /// Each cylinder with its lines, refined if it can be. Its number, from 1, is its label.
    pub(super) cylinders: Vec<(CylinderLines, Cylinder)>,
    /// For the page: all cylinders, and the lines of each.
    pub(super) tables: Vec<Table>,
}

impl Found {
    /// Refines the cylinders on their lines, and on the points of the scene if they are `evidence`.
    pub(super) fn new(
        (views, points): (Vec<View>, Vec<Point3<f64>>),
        evidence: bool,
        threshold: f64,
        matching: &Matching,
    ) -> Self {
        let (mut cylinders, mut reports) = (Vec::new(), Vec::new());
        // Nothing interrupts it.
        let refined = refined_matches(&views, matching, if evidence { &points } else { &[] }, Interrupt::never());
        for (RefinedMatch { lines, estimate, is_parallel }, found) in
            refined.into_iter().flatten().zip(&matching.cylinders)
        {
            let cylinder = estimate.as_ref().map_or(found.cylinder, |estimate| estimate.cylinder);
            reports.push(estimate.map(|estimate| (Report::new(&lines, &estimate, &points), is_parallel)));
            cylinders.push((lines, cylinder));
        }
        let refined: Vec<Report> = reports.iter().flatten().map(|(report, _)| report.clone()).collect();
        let tables = std::iter::once(cylinder_table(&refined)).chain(refined.iter().map(residual_table)).collect();
        let report = MatchingReport::new(&views, threshold, matching).with_refined(reports);
        let output = Output::of(&report).with_warnings(report.warnings);
        Self { output, scene: Scene { views, points }, cylinders, tables }
    }
}
