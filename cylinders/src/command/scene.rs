//! The arguments that name the files of cameras and lines, shared by the subcommands that take a
//! scene.

use std::path::{Path, PathBuf};

use super::error::CommandError;
use super::page::folder_of;
use crate::{Scene, read_colmap, read_scene, read_segments};

/// A scene file, or a COLMAP model with segments.
#[derive(clap::Args, Debug)]
pub(super) struct SceneArguments {
    /// Scene: cameras and silhouette lines, JSON
    #[arg(required_unless_present = "colmap", conflicts_with = "colmap")]
    scene: Option<PathBuf>,
    /// Folder of a COLMAP model with the cameras: cameras, images and points3D, binary or text
    #[arg(long, value_name = "FOLDER", requires = "segments")]
    colmap: Option<PathBuf>,
    /// Line segments to add to the images: CSV with the columns image,x1,y1,x2,y2 and optionally
    /// cylinder,line
    #[arg(long, value_name = "CSV")]
    segments: Option<PathBuf>,
}

impl SceneArguments {
    /// The file that is named by messages about the whole scene.
    pub(super) fn path(&self) -> &Path {
        self.scene.as_ref().or(self.segments.as_ref()).map_or(Path::new(""), PathBuf::as_path)
    }

    /// The folders of the files that are read, in which photographs may be.
    pub(super) fn folders(&self) -> Vec<PathBuf> {
        let files = self.scene.iter().chain(&self.segments).map(|path| folder_of(path));
        files.chain(self.colmap.clone()).collect()
    }

    /// Reads the scene, or the model and its segments.
    pub(super) fn read(&self) -> Result<Scene, CommandError> {
        let segments = self.segments.as_deref().map(read_segments).transpose()?;
        match (&self.scene, &self.colmap, &segments) {
            (Some(scene), _, Some(segments)) => Ok(read_scene(scene)?.with_segments(segments)?),
            (Some(scene), _, None) => Ok(read_scene(scene)?),
            (None, Some(model), Some(segments)) => Ok(Scene::from_colmap(read_colmap(model)?, segments)?),
            // The parser of the command line rejects all other combinations.
            (None, ..) => Err(CommandError::NoScene),
        }
    }
}
