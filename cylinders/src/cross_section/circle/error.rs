//! Why the tangent lines do not determine a circle.

use thiserror::Error;

/// Why there is no circle.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum CircleError {
    /// All lines pass through one point: there are only two distinct lines, or the axis was marked
    /// instead of the silhouettes.
    #[error(
        "in the cross-section all lines meet in one point: there are fewer than three distinct tangents, or the lines are \
         not silhouettes"
    )]
    Concurrent,
    /// All lines are parallel.
    #[error("in the cross-section all lines are parallel")]
    Parallel,
    /// Several circles touch all lines exactly, as four do for three lines.
    #[error(
        "{circles} circles touch all lines of the cross-section exactly, as is the case for three lines; \
         pass a fourth silhouette line"
    )]
    Ambiguous {
        /// Number of circles.
        circles: usize,
    },
    /// A coordinate is NaN, infinite or out of range.
    #[error("the lines of the cross-section are out of range")]
    OutOfRange,
    /// No stationary point is a real circle.
    #[error("no stationary point of the least squares problem is a circle")]
    NoCircle,
    /// The emitted solver refused the data.
    #[error("the equations of the circle could not be solved: {0}")]
    Solver(#[from] eliminant::SolveError),
}
