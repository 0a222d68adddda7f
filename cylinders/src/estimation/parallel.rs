//! Several parallel cylinders: one direction from the lines of all of them, then each cylinder by
//! itself.

use thiserror::Error;

use super::triangulate::{TriangulateError, Triangulation, triangulate_along};
use crate::axis::direction::{DirectionError, SharedDirection, estimate_shared_direction};
use crate::observations::view::View;

/// Triangulated parallel cylinders.
#[derive(Clone, Debug, PartialEq)]
pub struct ParallelTriangulation {
    /// Their direction.
    pub direction: SharedDirection,
    /// The cylinders, in the order of the input.
    pub cylinders: Vec<Triangulation>,
}

/// Why there are no parallel cylinders.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum ParallelError {
    /// The lines of all cylinders together determine no direction.
    #[error(transparent)]
    Direction(#[from] DirectionError),
    /// A cylinder cannot be triangulated.
    #[error("cylinder {cylinder}: {error}")]
    Cylinder {
        /// Index of the cylinder.
        cylinder: usize,
        /// Reason.
        error: TriangulateError,
    },
}

/// Triangulates parallel cylinders, each given by views that contain only its own lines.
///
/// # Errors
/// [`ParallelError`].
pub fn triangulate_parallel(cylinders: &[Vec<View>]) -> Result<ParallelTriangulation, ParallelError> {
    let planes: Vec<_> = cylinders.iter().map(|views| views.iter().flat_map(View::planes).collect()).collect();
    let direction = estimate_shared_direction(&planes)?;
    let triangulate = |(cylinder, views): (usize, &Vec<View>)| {
        triangulate_along(views, direction.direction).map_err(|error| ParallelError::Cylinder { cylinder, error })
    };
    let cylinders = cylinders.iter().enumerate().map(triangulate).collect::<Result<_, _>>()?;
    Ok(ParallelTriangulation { direction, cylinders })
}
