//! Cylinders that were found among lines without labels, for the subcommands that search.

use nalgebra::Point3;

use super::output::Output;
use crate::matching_report::MatchingReport;
use crate::page::Table;
use crate::report::Report;
use crate::report_table::{cylinder_table, residual_table};
use crate::{Cylinder, CylinderLines, Matching, Scene, View, estimate_from};

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
    /// Refines each cylinder on its lines.
    pub(super) fn new(views: Vec<View>, points: Vec<Point3<f64>>, threshold: f64, matching: &Matching) -> Self {
        let (mut cylinders, mut reports) = (Vec::new(), Vec::new());
        for (number, found) in (1..).zip(&matching.cylinders) {
            let lines = found.lines(&views, &u32::to_string(&number));
            let estimate = estimate_from(&lines.views, &found.cylinder);
            let cylinder = estimate.as_ref().map_or(found.cylinder, |estimate| estimate.cylinder);
            reports.push(estimate.map(|estimate| Report::new(&lines, &estimate, &points)));
            cylinders.push((lines, cylinder));
        }
        let refined: Vec<Report> = reports.iter().flatten().cloned().collect();
        let tables = std::iter::once(cylinder_table(&refined)).chain(refined.iter().map(residual_table)).collect();
        let report = MatchingReport::new(&views, threshold, matching).with_refined(reports);
        let output = Output::of(&report).with_warnings(report.warnings);
        Self { output, scene: Scene { views, points }, cylinders, tables }
    }
}
