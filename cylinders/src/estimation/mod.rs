//! All steps from views to a cylinder: by least squares, refined, or with RANSAC.

/// Which other cylinders explain the lines about as well.
pub mod alternatives;
/// A cylinder from any of the estimators.
pub(crate) mod estimate;
/// The influence of lines on the refinement.
mod loss;
/// Several cylinders with one direction.
pub mod parallel;
/// Lines in space by four parameters.
mod plucker;
/// A cylinder to the one whose silhouettes are nearest to the lines, with its covariance.
pub mod refine;
/// Why a cylinder cannot be refined.
mod refine_error;
/// Lines to the cylinder on which most agree if many lines are wrong.
pub mod robust;
/// Cylinders from samples of lines.
mod sampling;
/// Whether lines could agree by chance.
mod significance;
/// The cost of a cylinder and the uncertainty of its parameters.
mod silhouette_cost;
/// Views to a cylinder with its residuals.
pub mod triangulate;
/// What makes an estimate doubtful.
pub mod warnings;
