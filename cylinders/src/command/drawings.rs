//! The files that show a result, for every subcommand that finds cylinders in a scene.

use std::path::{Path, PathBuf};

use super::error::CommandError;
use super::files::File;
use crate::page::{Page, Table, photograph_overlay};
use crate::picture::{Format, Picture, PictureError, SectionPicture, SilhouettePicture};
use crate::ply::to_ply;
use crate::{Cylinder, CylinderLines, Scene};

/// Where to draw the result.
#[derive(clap::Args, Debug)]
pub(super) struct DrawingArguments {
    /// Write surfaces, viewing planes, cameras and points to this file, for a viewer of PLY files
    #[arg(long, value_name = "FILE")]
    ply: Option<PathBuf>,
    /// Draw the cross-section with cameras, tangent lines and circles, as .svg or .png; of a
    /// labelled cylinder to FILE-LABEL
    #[arg(long, value_name = "FILE", value_parser = picture_path)]
    section: Option<PathBuf>,
    /// Draw lines and silhouettes of each image, over its photograph if it is found, to an SVG file
    /// in this folder, which is made if it is not there
    #[arg(long, value_name = "FOLDER")]
    silhouettes: Option<PathBuf>,
    /// Write a report to this file: one HTML page with photographs, cross-sections, a view in space
    /// and tables
    #[arg(long, value_name = "FILE.html")]
    report: Option<PathBuf>,
}

/// A file name with the extension of a picture.
fn picture_path(text: &str) -> Result<PathBuf, PictureError> {
    let path = PathBuf::from(text);
    Format::of(&path).map(|_| path)
}

/// What is drawn.
pub(super) struct Drawn<'a> {
    pub(super) scene: &'a Scene,
    pub(super) found: &'a [(CylinderLines, Cylinder)],
    /// The folders in which photographs may be.
    pub(super) folders: Vec<PathBuf>,
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

impl DrawingArguments {
    /// The folder of the silhouettes.
    pub(super) fn folder(&self) -> Option<&Path> {
        self.silhouettes.as_deref()
    }

    /// Draws all files.
    pub(super) fn draw(&self, drawn: Drawn<'_>, findings: Findings) -> Result<Vec<File>, CommandError> {
        let Drawn { scene, found, folders } = drawn;
        let mut files = Vec::new();
        if let Some(path) = &self.ply {
            files.push((path.clone(), to_ply(scene, found)));
        }
        if let Some(path) = &self.section {
            for (lines, cylinder) in found {
                let path = labelled(path, lines.label.as_deref());
                files.push(rendered(path, &SectionPicture::of_cylinder(lines, cylinder))?);
            }
        }
        if let Some(folder) = &self.silhouettes {
            for view in (0..scene.views.len()).filter(|&view| !scene.views[view].lines().is_empty()) {
                let path = folder.join(view_file(scene, view));
                if let Some(overlay) = photograph_overlay(scene, found, view, &folders) {
                    files.push((path, overlay.into_bytes()));
                } else if let Some(picture) = SilhouettePicture::new(scene, found, view) {
                    files.push(rendered(path, &picture)?);
                }
            }
        }
        if let Some(path) = &self.report {
            let Findings { command, warnings, tables } = findings;
            let page = Page { scene, found, command, warnings, tables, folders };
            let page = page.to_html().map_err(|source| CommandError::Picture { path: path.clone(), source })?;
            files.push((path.clone(), page.into_bytes()));
        }
        Ok(files)
    }
}

/// The name of the picture of a view: its index and the name of its image.
fn view_file(scene: &Scene, view: usize) -> String {
    let image = scene.views[view].image().and_then(|image| Path::new(image).file_stem()?.to_str());
    image.map_or(format!("{view:03}.svg"), |image| format!("{view:03}-{}.svg", in_file_name(image)))
}

fn rendered(path: PathBuf, picture: &impl Picture) -> Result<File, CommandError> {
    match Format::of(&path).and_then(|format| format.render(picture)) {
        Ok(content) => Ok((path, content)),
        Err(source) => Err(CommandError::Picture { path, source }),
    }
}

/// `FILE-LABEL` before the extension.
fn labelled(path: &Path, label: Option<&str>) -> PathBuf {
    let (Some(label), Some(stem), Some(extension)) = (label, path.file_stem(), path.extension()) else {
        return path.to_owned();
    };
    let mut name = stem.to_owned();
    name.push(format!("-{}.", in_file_name(label)));
    name.push(extension);
    path.with_file_name(name)
}

/// The text, with every character replaced that a file name may not contain.
fn in_file_name(text: &str) -> String {
    text.chars()
        .map(|character| if character.is_alphanumeric() || "-_.".contains(character) { character } else { '_' })
        .collect()
}
