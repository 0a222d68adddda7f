//! Cylinder triangulation: silhouette lines and cameras in, a cylinder out.
//!
//! Gummeson & Oskarsson, "Robust and Accurate Cylinder Triangulation". The list of modules is the pipeline.

/// Tangent lines to the least squares circle: normalisation, and the best of the stationary circles.
pub mod circle;
/// Three tangent lines to their incircle and excircles, in closed form.
pub mod closed_form;
/// COLMAP models, text and binary: cameras of photographs, and points.
pub mod colmap;
/// The command `cylinders`: arguments to exit status and text.
#[cfg(feature = "command")]
pub mod command;
/// Circle back to a cylinder in space; silhouettes and residuals.
pub mod cylinder;
/// Viewing planes to the direction of the axis; conditioned, or refused.
pub mod direction;
/// Lens distortion, and its inverse.
pub mod distortion;
/// A cylinder from any of the estimators.
pub mod estimate;
/// The experiments of the paper, on simulated scenes.
#[cfg(feature = "command")]
pub mod experiment;
/// Which part of a cylinder the views show.
pub mod extent;
/// Scene files: JSON to views.
pub mod input;
/// Tangent lines to all stationary circles, the global minimum first.
pub mod least_squares;
/// Damped least squares on a manifold of few dimensions.
mod levenberg_marquardt;
/// Tangent lines to a conic that need not be a circle.
pub mod linear_conic;
/// Lines of which nobody says what they show to all cylinders of one direction.
pub mod matching;
/// Matches as text and as JSON.
pub mod matching_report;
/// Three tangent lines to the circles that touch them, by the emitted solver.
pub mod minimal;
/// Pairs of tangent lines to a circle: axis first, then radius.
pub mod navab;
/// Tangent lines to coordinates of order one, in which they are solved.
mod normalise;
/// Colours of pictures and models.
mod palette;
/// Several cylinders with one direction.
pub mod parallel;
/// The camera behind the pixels of a photograph, with its distortion.
pub mod photograph;
/// Cross-sections, silhouettes and plots as SVG and PNG files.
#[cfg(feature = "command")]
pub mod picture;
/// Lines in space by four parameters.
mod plucker;
/// Cylinders, cameras, lines and points as a PLY file.
pub mod ply;
/// Progress bars on standard error.
#[cfg(feature = "command")]
mod progress;
/// The cylinder as quadric and dual quadric, and its outline from the dual.
pub mod quadric;
/// Seeded random numbers, for simulations.
pub mod random;
/// RANSAC for any model: samples, scores, local optimisation, termination.
pub mod ransac;
/// Viewing planes to tangent lines of the cross-section.
pub mod rectify;
/// A cylinder to the one whose silhouettes are nearest to the lines, with its covariance.
pub mod refine;
/// A result as text and as JSON.
pub mod report;
/// Lines, most of them wrong, to the cylinder on which the others agree.
pub mod robust;
/// Viewing planes, some of them wrong, to the direction of the axis.
pub mod robust_direction;
/// Views of one or several cylinders, with the points around them.
pub mod scene;
/// Tangent lines to conics: the trait of all methods.
pub mod section;
/// CSV files of line segments: end points to fitted lines.
pub mod segments;
/// Cameras in the cross-section: which circles are in front of them.
pub mod sight;
/// Signed, smooth distance of an image line from a silhouette.
pub mod silhouette_distance;
/// Scenes of which the truth is known.
#[cfg(feature = "command")]
pub mod simulation;
/// Tangent lines to all stationary circles, by the emitted solver.
mod stationary;
/// All of it: views to a cylinder with its residuals.
pub mod triangulate;
/// Cameras, silhouette lines and viewing planes; validated.
pub mod view;

pub use circle::{Circle, CircleError, CircleFit};
pub use closed_form::{ClosedForm, tangent_circles};
pub use colmap::{ColmapError, read_colmap};
pub use cylinder::{Cylinder, LineResidual, Side};
pub use direction::{Direction, DirectionError, SharedDirection};
pub use estimate::{Estimate, EstimateConsensus, EstimateError};
pub use input::{InputError, parse_scene, read_scene};
pub use least_squares::LeastSquares;
pub use linear_conic::LinearConic;
pub use matching::{
    MatchError, MatchOptions, MatchedCylinder, Matching, Progress, References, match_cylinders, match_cylinders_with,
};
pub use minimal::{Minimal, minimal_circles};
pub use navab::Navab;
pub use parallel::{ParallelError, ParallelTriangulation, triangulate_parallel};
pub use quadric::silhouette_of_dual_quadric;
pub use ransac::{RansacOptions, RansacOptionsError};
pub use refine::{Deviation, Loss, RefineError, RefineOptions, Refinement, refine};
pub use robust::{RobustError, RobustOptions, RobustTriangulation, triangulate_robustly};
pub use robust_direction::{RobustDirection, common_direction, default_direction_options, estimate_direction_robustly};
pub use scene::{CylinderLines, LineId, Scene};
pub use section::{Section, SectionError, SectionLine, SectionShape, SectionSolver};
pub use segments::{SegmentError, Segments, parse_segments, read_segments};
pub use sight::Sight;
pub use silhouette_distance::{DistanceUnit, Metric, MetricError};
pub use triangulate::{TriangulateError, Triangulation, triangulate, triangulate_along};
pub use view::{Calibration, Camera, View, ViewError, ViewingPlane};
