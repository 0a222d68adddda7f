//! Triangulations as tables of numbers, for a page.

use super::number::number;
use super::page::Table;
use super::report::{Report, ResidualReport};

/// One row for each cylinder, with standard deviations where there was a refinement.
pub fn cylinder_table(reports: &[Report]) -> Table {
    let header = ["cylinder", "radius", "+-", "axis point", "direction", "+- rad", "extent", "image rms", "inliers"];
    let row = |(index, report): (usize, &Report)| {
        let refined = report.refinement.as_ref();
        let or_dash = |value: Option<f64>| value.map_or("-".to_owned(), short);
        vec![
            report.label.clone().unwrap_or_else(|| (index + 1).to_string()),
            short(report.radius),
            or_dash(refined.map(|refined| refined.radius_deviation)),
            joined(&report.axis_point),
            joined(&report.direction),
            or_dash(refined.map(|refined| refined.direction_deviation)),
            report.extent.map_or("-".to_owned(), |extent| joined(&extent)),
            refined.map_or("-".to_owned(), |refined| format!("{} {}", short(refined.image_rms), refined.unit)),
            report
                .consensus
                .map_or("-".to_owned(), |consensus| format!("{} of {}", consensus.inliers, consensus.lines)),
        ]
    };
    let rows = reports.iter().enumerate().map(row).collect();
    Table { caption: "Cylinders, world units; +- is a standard deviation".to_owned(), header: owned(&header), rows }
}

/// One row for each line of a cylinder.
pub fn residual_table(report: &Report) -> Table {
    let header = ["image", "view", "line", "side", "distance", "angle / degrees", "pixels", "agrees"];
    let row = |residual: &ResidualReport| {
        vec![
            residual.image.clone().unwrap_or_else(|| "-".to_owned()),
            residual.view.to_string(),
            residual.line.to_string(),
            residual.side.to_string(),
            format!("{:.4e}", residual.distance),
            format!("{:.6}", residual.angle.to_degrees()),
            residual.pixels.map_or("-".to_owned(), |pixels| format!("{pixels:.3}")),
            residual.inlier.map_or("-", |inlier| if inlier { "yes" } else { "no" }).to_owned(),
        ]
    };
    let name = report.label.as_ref().map_or(String::new(), |label| format!(" of {label}"));
    let caption = format!("Lines{name}: distance of the viewing plane from the surface, in space and in the image");
    Table { caption, header: owned(&header), rows: report.residuals.iter().map(row).collect() }
}

fn short(value: f64) -> String {
    number(value).trim().to_owned()
}

fn joined(values: &[f64]) -> String {
    values.iter().map(|value| short(*value)).collect::<Vec<_>>().join(", ")
}

fn owned(texts: &[&str]) -> Vec<String> {
    texts.iter().map(|text| (*text).to_owned()).collect()
}
