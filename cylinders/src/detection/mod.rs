//! Line segments in a photograph: the line segment detector LSD after von Gioi, Jakubowicz, Morel
//! and Randall, "LSD: a Line Segment Detector" (Image Processing On Line 2, 2012), written anew.
//!
//! ```text
//!   image --> smoothed, 0.8 of the size --> direction of the level line at each pixel
//!     --> regions of equal direction --> rectangles, dense --> rectangles that are no chance
//!     --> ends at the edge between pixels (an addition to LSD)
//! ```

/// The detector.
mod detect;
/// Grey images.
mod grey;
/// The image at 0.8 of its size; its level lines.
mod level_lines;
/// Rectangles around regions.
mod rectangle;
/// Connected pixels of one direction.
mod region;
/// How unlikely a rectangle is by chance.
mod significance;
/// The place of an edge between pixels.
mod subpixel;

pub(crate) use detect::segments;
pub use detect::{DetectedSegment, detect_segments};
pub use grey::{GreyError, GreyImage};
