//! The report of a result, for every subcommand that finds cylinders in a scene.

use std::path::PathBuf;

use super::error::CommandError;
use super::files::File;
use super::scene::SceneArguments;
use crate::page::{Page, Table};
use crate::{Cylinder, CylinderLines, Scene};

/// The report.
#[derive(clap::Args, Debug)]
pub(super) struct PageArguments {
    /// Write a report to this file: one HTML page with photographs, cross-sections, a view in space
    /// and tables
    #[arg(long, value_name = "FILE.html")]
    report: Option<PathBuf>,
    /// Folder of the photographs; by default those of the scene, the segments and the model, and
    /// folders `images` beside them
    #[arg(long, value_name = "FOLDER", requires = "report")]
    images: Option<PathBuf>,
}

/// What the report says beside the cylinders.
pub(super) struct Findings {
    /// The command line.
    pub(super) command: String,
    /// What makes the result doubtful.
    pub(super) warnings: Vec<String>,
    /// Numbers.
    pub(super) tables: Vec<Table>,
}

impl PageArguments {
    /// The file of the report, if there should be one.
    pub(super) fn file(
        &self,
        arguments: &SceneArguments,
        scene: &Scene,
        found: &[(CylinderLines, Cylinder)],
        findings: Findings,
    ) -> Result<Option<File>, CommandError> {
        let Some(path) = &self.report else { return Ok(None) };
        let Findings { command, warnings, tables } = findings;
        let folders = match &self.images {
            Some(folder) => vec![folder.clone()],
            None => near(&arguments.folders()),
        };
        match (Page { scene, found, command, warnings, tables, folders }).to_html() {
            Ok(page) => Ok(Some((path.clone(), page.into_bytes()))),
            Err(source) => Err(CommandError::Picture { path: path.clone(), source }),
        }
    }
}

/// The folders, those above them, and the folders `images` in each: COLMAP's models are in a folder
/// such as `sparse/0` beside `images`.
fn near(folders: &[PathBuf]) -> Vec<PathBuf> {
    let above = |folder: &PathBuf| [folder.clone(), folder.join(".."), folder.join("../..")];
    let inputs = folders.iter().cloned();
    inputs.chain(folders.iter().flat_map(above).map(|folder| folder.join("images"))).collect()
}
