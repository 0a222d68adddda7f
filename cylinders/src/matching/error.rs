//! Why nothing can be matched.

use thiserror::Error;

use crate::numerics::interrupt::Interrupted;

/// Why nothing can be matched.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum MatchError {
    /// The threshold is not positive, or too large for an angle.
    #[error(
        "the threshold must be positive and less than a tenth of a radian (found {threshold} radians in views[{view}])"
    )]
    Threshold {
        /// Index of the view.
        view: usize,
        /// The threshold as an angle, radians.
        threshold: f64,
    },
    /// A threshold in pixels without a calibration.
    #[error("views[{view}]: a threshold in pixels needs the calibration of every camera; pass it, or one in radians")]
    NoCalibration {
        /// Index of the view.
        view: usize,
    },
    /// The requested least support does not determine a circle.
    #[error("the least number of matches must be four or more (found {least_support}): four circles touch three lines")]
    LeastSupport {
        /// The value.
        least_support: usize,
    },
    /// Fewer than two views have lines along the axis.
    #[error("{views} view(s) have lines along the axis direction; matching needs at least two")]
    TooFewViews {
        /// Number of views with such lines.
        views: usize,
    },
    /// No image has two lines along the axis.
    #[error("no view has two lines along the axis direction: there is no pair of silhouettes to start from")]
    NoPair,
    /// Without the lines of edges, too few are left.
    #[error("{edges} of the {lines} lines are of edges that are fixed in space, not of cylinders; too few are left")]
    Edges {
        /// Number of lines of edges.
        edges: usize,
        /// Number of lines.
        lines: usize,
    },
    /// Seen along the axis, all camera centres coincide: a cylinder of any size fits.
    #[error(
        "all cameras stand at one place, or above each other along the axis: the distance to the cylinders is unknown"
    )]
    SingleViewpoint,
    /// No model has the required support.
    #[error(
        "no cylinder has {least_support} of the {lines} lines near its silhouettes and more than chance gives; pass more \
         views, a better calibration or direction, or another threshold"
    )]
    NoCylinder {
        /// Least number of matches that was required of a cylinder.
        least_support: usize,
        /// Number of lines.
        lines: usize,
    },
    /// The options interrupt the search.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
}
