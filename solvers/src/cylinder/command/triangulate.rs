//! `cylinders triangulate`: the cylinder of a scene.

use std::fmt;
use std::path::PathBuf;

use serde::Serialize;

use super::error::CommandError;
use super::files::write;
use super::output::Output;
use super::scene::SceneArguments;
use crate::cylinder::report::Report;
use crate::cylinder::{CylinderLines, Scene, triangulate};

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
    let output = Output::of(&reports(arguments, &scene)?);
    if let Some(path) = &arguments.out {
        write(path, output.json.as_bytes())?;
    }
    Ok(output)
}

fn reports(arguments: &Arguments, scene: &Scene) -> Result<Reports, CommandError> {
    let report = |lines: &CylinderLines| match triangulate(&lines.views) {
        Ok(result) => Ok(Report::new(lines, &result, &scene.points)),
        Err(error) => {
            let (scene, label) = (arguments.scene.path().to_owned(), lines.label.clone());
            Err(CommandError::Triangulate { scene, label, error })
        }
    };
    let mut reports = scene.cylinders().iter().map(report).collect::<Result<Vec<_>, _>>()?;
    match reports.pop() {
        Some(report) if !scene.has_labels() => Ok(Reports::Unlabelled(Box::new(report))),
        last => Ok(Reports::Labelled { cylinders: reports.into_iter().chain(last).collect() }),
    }
}
