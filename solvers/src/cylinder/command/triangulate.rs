//! `cylinders triangulate`: the cylinder of a scene.

use std::path::PathBuf;

use super::error::CommandError;
use super::files::write;
use super::output::Output;
use crate::cylinder::report::Report;
use crate::cylinder::{read_scene, triangulate};

/// Triangulate the cylinder of a scene by constrained least squares
#[derive(clap::Args, Debug)]
#[command(after_help = "Example:
  cylinders triangulate solvers/data/soda_can.json")]
pub(super) struct Arguments {
    /// Scene: cameras and silhouette lines, JSON
    scene: PathBuf,
    /// Write the result to this file too, as JSON
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

pub(super) fn run(arguments: &Arguments) -> Result<Output, CommandError> {
    let scene = read_scene(&arguments.scene)?;
    let result = triangulate(&scene.views)
        .map_err(|error| CommandError::Triangulate { scene: arguments.scene.clone(), error })?;
    let output = Output::of(&Report::new(&result, &scene.points));
    if let Some(path) = &arguments.out {
        write(path, output.json.as_bytes())?;
    }
    Ok(output)
}
