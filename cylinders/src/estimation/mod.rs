//! All steps from views to a cylinder: by least squares, refined, or with RANSAC.

/// Which other cylinders explain the lines about as well.
pub mod alternatives;
/// A cylinder from any of the estimators.
pub(crate) mod estimate;
/// The lines of a cylinder as evidence for it.
mod evidence;
/// Several cylinders with a direction or a radius in common, refined together.
pub mod joint;
/// Cylinders with a direction or a radius in common from views, with what makes them doubtful.
pub(crate) mod joint_estimate;
/// The influence of lines on the refinement.
pub(crate) mod loss;
/// Several cylinders with one direction.
pub mod parallel;
/// A cylinder to the one whose silhouettes are nearest to the lines, with its covariance.
pub mod refine;
/// Why a cylinder cannot be refined.
pub(crate) mod refine_error;
/// Lines to the cylinder on which most agree if many lines are wrong.
pub mod robust;
/// Cylinders from samples of lines.
mod sampling;
/// Whether lines could agree by chance.
mod significance;
/// The cost of a cylinder and its derivatives.
mod silhouette_cost;
/// Points of the scene near the surface as evidence beside the lines.
pub(crate) mod surface_points;
/// Views to a cylinder with its residuals.
pub mod triangulate;
/// The covariance of refined cylinders.
mod uncertainty;
/// What makes an estimate doubtful.
pub mod warnings;
