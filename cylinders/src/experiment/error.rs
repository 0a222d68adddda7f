//! Why an experiment was not finished.

use std::path::PathBuf;

use thiserror::Error;

use crate::input::InputError;
use crate::picture::PictureError;
use crate::view::ViewError;

/// Why an experiment was not finished.
#[derive(Debug, Error)]
pub enum ExperimentError {
    /// A picture cannot be drawn.
    #[error("{name}: {source}")]
    Picture {
        /// Name of its file.
        name: String,
        /// Reason.
        source: PictureError,
    },
    /// The simulated cameras are out of range.
    #[error(transparent)]
    View(#[from] ViewError),
    /// The scene cannot be read.
    #[error(transparent)]
    Input(#[from] InputError),
    /// The lines of the scene determine no cylinder.
    #[error("{}: {reason}", path.display())]
    Scene {
        /// The file.
        path: PathBuf,
        /// Reason.
        reason: String,
    },
    /// Simulated data determine no result.
    #[error("{0}")]
    Unsolved(String),
    /// A scene file was given to an experiment that simulates its own scenes.
    #[error("only the experiment `real` takes a scene file")]
    NoScene,
    /// A table cannot be written as CSV.
    #[error("{table}: {source}")]
    Csv {
        /// Name of the table.
        table: String,
        /// Reason.
        source: csv::Error,
    },
}
