//! Photographs and their cameras to the cylinders in them, without correspondences.
//!
//! ```text
//!   photograph --> distortion removed --> segments --> pieces joined, short ones left out
//!     --> directions on which many lines agree --> matching along each
//!     --> the directions with evidence for cylinders
//! ```

/// Files of photographs to grey images.
#[cfg(feature = "photographs")]
pub mod decode;
/// Edges in space, which are no silhouettes.
mod edges;
/// Photographs to candidates of silhouettes.
mod lines;
/// Directions and matches.
mod search;
/// Marked lines to the edges near them.
mod snap;

pub use lines::{LineOptions, PhotoError, candidate_lines, detected_lines, undistorted_image, undistorted_segments};
pub use search::{PhotoMatching, PhotoOptions, find_cylinders};
pub use snap::snapped;
