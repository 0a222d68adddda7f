//! Why a subcommand failed, with the file at fault.

use std::io;
use std::path::PathBuf;

use thiserror::Error;

use crate::experiment::ExperimentError;
use crate::photos::PhotoError;
use crate::photos::decode::DecodeError;
use crate::picture::PictureError;
use crate::{BundlerError, ColmapError, EstimateError, InputError, MatchError, SegmentError, TransformsError};

/// Why a subcommand failed. The data or a file is at fault in every case.
#[derive(Debug, Error)]
pub(super) enum CommandError {
    /// The scene cannot be read.
    #[error(transparent)]
    Input(#[from] InputError),
    /// The segments cannot be read, or do not belong to the images.
    #[error(transparent)]
    Segments(#[from] SegmentError),
    /// The model cannot be read.
    #[error(transparent)]
    Colmap(#[from] ColmapError),
    /// The cameras of Bundler cannot be read.
    #[error(transparent)]
    Bundler(#[from] BundlerError),
    /// The cameras of `transforms.json` cannot be read.
    #[error(transparent)]
    Transforms(#[from] TransformsError),
    /// Neither a scene nor a model with segments was given.
    #[error("there is no scene")]
    NoScene,
    /// The scene has no points, though they were asked.
    #[error("{}: the scene has no points, which `--points` would take as evidence", scene.display())]
    NoPoints { scene: PathBuf },
    /// The lines determine no cylinder.
    #[error("{}: {}{error}", scene.display(), label.as_ref().map_or(String::new(), |label| format!("cylinder `{label}`: ")))]
    Estimate { scene: PathBuf, label: Option<String>, error: EstimateError },
    /// The lines cannot be matched.
    #[error("{}: {error}", scene.display())]
    Match { scene: PathBuf, error: MatchError },
    /// A view does not name its photograph.
    #[error("views[{view}]: there is no `image`, the name of the photograph")]
    NoImageName { view: usize },
    /// A photograph cannot be read.
    #[error("cannot read `{}`: {source}", path.display())]
    Read { path: PathBuf, source: io::Error },
    /// A file is not a photograph.
    #[error("{}: {source}", path.display())]
    Photograph { path: PathBuf, source: DecodeError },
    /// A photograph gives no lines.
    #[error(transparent)]
    Photo(#[from] PhotoError),
    /// A picture cannot be drawn.
    #[error("{}: {source}", path.display())]
    Picture { path: PathBuf, source: PictureError },
    /// An experiment was not finished.
    #[error(transparent)]
    Experiment(#[from] ExperimentError),
    /// A file cannot be written.
    #[error("cannot write `{}`: {source}", path.display())]
    Write { path: PathBuf, source: io::Error },
}
