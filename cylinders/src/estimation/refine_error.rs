//! Why a cylinder cannot be refined.

use thiserror::Error;

use crate::numerics::interrupt::Interrupted;
use crate::space::silhouette_distance::MetricError;

/// Why there is no refined cylinder.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum RefineError {
    /// There are too few lines: each gives two numbers, and a cylinder has five parameters.
    #[error("{lines} silhouette line(s) given, copies counted once; a cylinder needs at least three")]
    TooFewLines {
        /// Number of independent lines.
        lines: usize,
    },
    /// The initial cylinder has a coordinate that is not finite, or a radius that is not positive.
    #[error("the cylinder to refine has a coordinate that is not finite, or a radius that is not positive")]
    NotACylinder,
    /// Distances cannot be measured.
    #[error(transparent)]
    Metric(#[from] MetricError),
    /// The scale of the loss is not a positive number.
    #[error("the scale of the loss must be a positive number (found {scale})")]
    LossScale {
        /// The value.
        scale: f64,
    },
    /// The radius would become zero: the lines are images of the axis, or do not belong to one
    /// cylinder.
    #[error("the lines fit best with a radius of zero: they are not silhouettes of one cylinder")]
    NoRadius,
    /// The initial cylinder, or the cylinder of least cost, contains a camera.
    #[error(
        "the cylinder that fits the lines best contains the camera of views[{view}]: the lines do not fit together"
    )]
    CameraInside {
        /// Index of the view.
        view: usize,
    },
    /// The lines do not determine a combination of the parameters.
    #[error("the lines do not determine the cylinder: their views are too similar; add a view from another place")]
    NotDetermined,
    /// The limit on the steps was reached, or numbers are out of range.
    #[error("the refinement did not converge in {iterations} steps")]
    NotConverged {
        /// Number of steps.
        iterations: usize,
    },
    /// The refinement of several cylinders was interrupted.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
}
