//! Cylinder triangulation: silhouette lines and cameras in, a cylinder out.
//!
//! Gummeson & Oskarsson, "Robust and Accurate Cylinder Triangulation". The folders are the pipeline
//! in order: no folder depends on a later one.

/// Damped least squares, RANSAC, random numbers.
mod numerics;

/// Files to views: cameras, silhouette lines and viewing planes, validated.
mod observations;

/// Viewing planes to the direction of the axis.
mod axis;

/// Viewing planes and direction to tangent lines, and these to the circle that they touch.
mod cross_section;

/// Circle and direction to the cylinder in space, its silhouettes and its residuals.
mod space;

/// Views to a cylinder, by all steps: least squares, refinement, RANSAC.
mod estimation;

/// Lines without labels to all cylinders of one direction or of several.
pub mod matching;

/// Photographs to line segments.
pub mod detection;

/// Photographs and cameras to the cylinders in them.
pub mod photos;

/// Cylinders to text, JSON, models and pictures.
mod output;

/// Photographs of scenes whose truth is known.
#[cfg(feature = "command")]
pub mod rendering;

/// Scenes whose truth is known.
#[cfg(feature = "command")]
pub mod simulation;

/// Progress bars on standard error.
#[cfg(feature = "command")]
mod progress;

/// The experiments of the paper, on simulated scenes.
#[cfg(feature = "command")]
pub mod experiment;

/// The command `cylinders`: arguments to exit status and text.
#[cfg(feature = "command")]
pub mod command;

pub use axis::direction::{self, Direction, DirectionError, SharedDirection};
pub use axis::robust_direction::{
    self, RobustDirection, common_direction, default_direction_options, estimate_direction_robustly,
};
pub use cross_section::circle::{self, Circle, CircleError, CircleFit};
pub use cross_section::closed_form::{self, ClosedForm, tangent_circles};
pub use cross_section::least_squares::{self, LeastSquares};
pub use cross_section::linear_conic::{self, LinearConic};
pub use cross_section::minimal::{self, Minimal, minimal_circles};
pub use cross_section::navab::{self, Navab};
pub use cross_section::rectify;
pub use cross_section::section::{self, Section, SectionError, SectionLine, SectionShape, SectionSolver};
pub use cross_section::sight::{self, Sight};
pub use estimation::alternatives::{self, Alternative, PlausibleCylinders};
pub use estimation::estimate::{
    Estimate, EstimateConsensus, EstimateError, Method, SurfacePoints, estimate, estimate_from, estimate_on_side,
};
pub use estimation::joint::{self, JointRefinement, Radii};
pub use estimation::joint_estimate::{JointError, JointEstimate, JointMethod, estimate_together};
pub use estimation::parallel::{self, ParallelError, ParallelTriangulation, triangulate_parallel};
pub use estimation::refine::{self, Deviation, Loss, Measure, RefineError, RefineOptions, Refinement, refine};
pub use estimation::robust::{self, RobustError, RobustOptions, RobustTriangulation, triangulate_robustly};
pub use estimation::surface_points::with_points;
pub use estimation::triangulate::{self, TriangulateError, Triangulation, triangulate, triangulate_along};
pub use estimation::warnings::{self, Warning};
pub use matching::{
    MatchError, MatchOptions, MatchedCylinder, Matching, Progress, References, match_candidate_with, match_cylinders,
    match_cylinders_with, match_directions, match_directions_with, match_with_wider_bound,
};
pub use numerics::interrupt::{Interrupt, Interrupted};
pub use numerics::random;
pub use numerics::ransac::{self, RansacOptions, RansacOptionsError};
pub use observations::bundler::{self, BundlerError, parse_bundler, read_bundler};
pub use observations::colmap::{self, ColmapError, read_colmap};
pub use observations::copies::{self, IndependentLines};
pub use observations::input::{self, InputError, parse_scene, read_scene};
pub use observations::scene::{self, CylinderLines, LineId, Scene};
pub use observations::segments::{self, PixelOrigin, SegmentError, Segments, parse_segments, read_segments};
pub use observations::transforms::{self, TransformsError, parse_transforms, read_transforms};
pub use observations::view::{self, Calibration, Camera, View, ViewError, ViewingPlane};
pub use observations::{distortion, photograph};
pub use output::{matching_report, ply, report};
#[cfg(feature = "command")]
pub use output::{page, picture, report_table};
pub use space::cylinder::{self, Cylinder, LineResidual, Side};
pub use space::extent;
pub use space::quadric::{self, silhouette_of_dual_quadric};
pub use space::silhouette_distance::{self, DistanceUnit, Metric, MetricError};
