//! What stops a subcommand, each with the file at fault.

use std::io;
use std::path::PathBuf;

use thiserror::Error;

use crate::cylinder::{InputError, TriangulateError};

/// Why a subcommand failed. All of these are the fault of the data or of a file.
#[derive(Debug, Error)]
pub(super) enum CommandError {
    /// The scene cannot be read.
    #[error(transparent)]
    Input(#[from] InputError),
    /// The lines determine no cylinder.
    #[error("{}: {error}", scene.display())]
    Triangulate { scene: PathBuf, error: TriangulateError },
    /// No folder, no permission, no space.
    #[error("cannot write `{}`: {source}", path.display())]
    Write { path: PathBuf, source: io::Error },
}
