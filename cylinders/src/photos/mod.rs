//! Photographs and their cameras to the cylinders in them, without correspondences.
//!
//! ```text
//!   photograph --> distortion removed --> segments --> pieces joined, short ones left out
//!     --> directions on which many lines agree --> matching along each
//!     --> the directions with evidence for cylinders
//!   if there is none: pairs of lines with an even part of the image between them --> such pairs of
//!     two images that are the silhouettes of one cylinder
//! ```

/// Files of photographs to grey images.
#[cfg(feature = "photographs")]
pub mod decode;
/// Photographs to candidates of silhouettes.
mod lines;
/// Cylinders from the ribbons of two images.
mod pairs;
/// Pairs of lines with an even part of the image between them.
mod ribbons;
/// Directions and matches.
mod search;
/// Marked lines to the edges near them.
mod snap;

pub use lines::{LineOptions, PhotoError, Seen, candidate_lines, seen, undistorted_image};
pub use ribbons::Ribbon;
pub use search::{PhotoMatching, PhotoOptions, find_cylinders, find_in_photographs};
pub use snap::snapped;
