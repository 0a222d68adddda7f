//! `cylinders triangulate`: the cylinder of a scene.

use std::fmt;
use std::path::PathBuf;

use serde::Serialize;

use super::drawings::{DrawingArguments, Drawn, Findings};
use super::error::CommandError;
use super::estimator::EstimatorArguments;
use super::files::write_all;
use super::images::ImageArguments;
use super::output::Output;
use super::scene::SceneArguments;
use crate::output::number::number;
use crate::page::Table;
use crate::report::Report;
use crate::report_table::{cylinder_table, residual_table};
use crate::{CylinderLines, Estimate, JointEstimate, Measure, Scene};

/// Triangulate the cylinders of a scene by constrained least squares, or robustly
#[derive(clap::Args, Debug)]
#[command(after_help = "Examples:
  cylinders triangulate cylinders/data/soda_can.json
  cylinders triangulate --colmap model --segments silhouettes.csv --json
  cylinders triangulate --robust --threshold 2 scene.json
  cylinders triangulate --parallel --shared-radius pillars.json

Lines with a label belong to the cylinder of that name; all others to one cylinder.
With labels the JSON is `{\"cylinders\": [..]}`, without them the object of the one cylinder.")]
pub(super) struct Arguments {
    #[command(flatten)]
    scene: SceneArguments,
    #[command(flatten)]
    estimator: EstimatorArguments,
    /// Also write the result to this file, as JSON
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    #[command(flatten)]
    drawings: DrawingArguments,
    #[command(flatten)]
    images: ImageArguments,
}

/// A single object for a scene without labels; otherwise a list, even with one label.
#[derive(Serialize)]
#[serde(untagged)]
pub(super) enum Reports {
    Unlabelled(Box<Report>),
    Labelled {
        /// Absent if they share none.
        #[serde(skip_serializing_if = "Option::is_none")]
        shared_radius: Option<SharedRadius>,
        cylinders: Vec<Report>,
    },
}

/// The radius that all cylinders share, world units.
#[derive(Clone, Copy, Serialize)]
pub(super) struct SharedRadius {
    radius: f64,
    radius_deviation: f64,
}

impl Reports {
    fn all(&self) -> &[Report] {
        match self {
            Self::Unlabelled(report) => std::slice::from_ref(report),
            Self::Labelled { cylinders, .. } => cylinders,
        }
    }

    /// The tables of the report: one of all cylinders, and one of the lines of each.
    pub(super) fn tables(&self) -> Vec<Table> {
        std::iter::once(cylinder_table(self.all())).chain(self.all().iter().map(residual_table)).collect()
    }

    /// The warnings of all cylinders, those of labelled ones with their label.
    pub(super) fn warnings(&self) -> Vec<String> {
        match self {
            Self::Unlabelled(report) => report.warnings.clone(),
            Self::Labelled { cylinders, .. } => {
                let label =
                    |report: &Report| report.label.as_ref().map_or(String::new(), |label| format!("`{label}`: "));
                let of_report = |report: &Report| -> Vec<_> {
                    report.warnings.iter().map(|warning| format!("{}{warning}", label(report))).collect()
                };
                cylinders.iter().flat_map(of_report).collect()
            }
        }
    }
}

impl fmt::Display for Reports {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unlabelled(report) => report.fmt(f),
            Self::Labelled { shared_radius, cylinders } => {
                if let Some(SharedRadius { radius, radius_deviation }) = shared_radius {
                    writeln!(f, "shared radius    {} +- {}\n", number(*radius), number(*radius_deviation).trim())?;
                }
                f.write_str(&cylinders.iter().map(Report::to_string).collect::<Vec<_>>().join("\n"))
            }
        }
    }
}

pub(super) fn run(arguments: &Arguments, command: &str) -> Result<Output, CommandError> {
    let scene = arguments.scene.read()?;
    let cylinders = scene.cylinders();
    let estimate = arguments.estimator.estimate(&arguments.scene, &cylinders, &scene.points)?;
    let reports = reports(&scene, &cylinders, &estimate);
    let output = Output::of(&reports).with_warnings(reports.warnings());
    // The pictures show the inliers only.
    let shown = |(lines, estimate): (CylinderLines, &Estimate)| match &estimate.consensus {
        Some(consensus) => (lines.selected(&consensus.inliers), estimate.cylinder),
        None => (lines, estimate.cylinder),
    };
    let found: Vec<_> = cylinders.into_iter().zip(&estimate.cylinders).map(shown).collect();
    let drawn = Drawn { scene: &scene, found: &found, folders: arguments.images.folders(&arguments.scene) };
    let findings =
        Findings { command: command.to_owned(), warnings: output.warnings.clone(), tables: reports.tables() };
    let mut files = arguments.drawings.draw(drawn, findings)?;
    files.extend(arguments.out.iter().map(|path| (path.clone(), output.json.clone().into_bytes())));
    write_all(arguments.drawings.folder().as_slice(), &files)?;
    Ok(output)
}

pub(super) fn reports(scene: &Scene, cylinders: &[CylinderLines], estimate: &JointEstimate) -> Reports {
    let report = |(lines, estimate)| Report::new(lines, estimate, &scene.points);
    let mut reports: Vec<_> = cylinders.iter().zip(&estimate.cylinders).map(report).collect();
    let shared_radius =
        estimate.radius.map(|Measure { value, deviation }| SharedRadius { radius: value, radius_deviation: deviation });
    match reports.pop() {
        Some(report) if !scene.has_labels() => Reports::Unlabelled(Box::new(report)),
        last => Reports::Labelled { shared_radius, cylinders: reports.into_iter().chain(last).collect() },
    }
}
