//! Where photographs are, for the subcommands that draw over them.

use std::path::PathBuf;

use super::scene::SceneArguments;

/// The folder of the photographs.
#[derive(clap::Args, Debug)]
pub(super) struct ImageArguments {
    /// Folder of the photographs, for --report and --silhouettes; by default those of the scene,
    /// the segments and the model, and folders `images` beside them
    #[arg(long, value_name = "FOLDER")]
    images: Option<PathBuf>,
}

impl ImageArguments {
    /// The folders in which photographs may be.
    pub(super) fn folders(&self, scene: &SceneArguments) -> Vec<PathBuf> {
        match &self.images {
            Some(folder) => vec![folder.clone()],
            None => near(&scene.folders()),
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
