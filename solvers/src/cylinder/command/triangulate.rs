//! `cylinders triangulate`: the cylinder of a scene.

use std::fmt;
use std::path::PathBuf;

use serde::Serialize;

use super::drawings::DrawingArguments;
use super::error::CommandError;
use super::files::write;
use super::output::Output;
use super::scene::SceneArguments;
use crate::cylinder::report::Report;
use crate::cylinder::{CylinderLines, Scene, Triangulation, triangulate};

/// Triangulate the cylinders of a scene by constrained least squares
#[derive(clap::Args, Debug)]
#[command(after_help = "Examples:
  cylinders triangulate solvers/data/soda_can.json
  cylinders triangulate --colmap model --segments silhouettes.csv --json

Lines with a label belong to the cylinder of that name; all others to one cylinder.
With labels the JSON is `{\"cylinders\": [..]}`, without them the object of the one cylinder.")]
pub(super) struct Arguments {
    #[command(flatten)]
    scene: SceneArguments,
    /// Write the result to this file too, as JSON
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    #[command(flatten)]
    drawings: DrawingArguments,
}

/// One cylinder, as it is, for a scene without labels; otherwise a list, also where there is one label.
#[derive(Serialize)]
#[serde(untagged)]
enum Reports {
    Unlabelled(Box<Report>),
    Labelled { cylinders: Vec<Report> },
}

impl fmt::Display for Reports {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unlabelled(report) => report.fmt(f),
            Self::Labelled { cylinders } => {
                f.write_str(&cylinders.iter().map(Report::to_string).collect::<Vec<_>>().join("\n"))
            }
        }
    }
}

pub(super) fn run(arguments: &Arguments) -> Result<Output, CommandError> {
    let scene = arguments.scene.read()?;
    let results = triangulate_all(arguments, &scene)?;
    let output = Output::of(&reports(&scene, &results));
    let found: Vec<_> = results.into_iter().map(|(lines, result)| (lines, result.cylinder)).collect();
    if let Some(path) = &arguments.out {
        write(path, output.json.as_bytes())?;
    }
    arguments.drawings.write(&scene, &found)?;
    Ok(output)
}

fn triangulate_all(arguments: &Arguments, scene: &Scene) -> Result<Vec<(CylinderLines, Triangulation)>, CommandError> {
    let triangulate = |lines: CylinderLines| match triangulate(&lines.views) {
        Ok(result) => Ok((lines, result)),
        Err(error) => {
            let scene = arguments.scene.path().to_owned();
            Err(CommandError::Triangulate { scene, label: lines.label, error })
        }
    };
    scene.cylinders().into_iter().map(triangulate).collect()
}

fn reports(scene: &Scene, results: &[(CylinderLines, Triangulation)]) -> Reports {
    let mut reports: Vec<_> = results.iter().map(|(lines, result)| Report::new(lines, result, &scene.points)).collect();
    match reports.pop() {
        Some(report) if !scene.has_labels() => Reports::Unlabelled(Box::new(report)),
        last => Reports::Labelled { cylinders: reports.into_iter().chain(last).collect() },
    }
}
