//! Results as text, JSON, models and pictures.

/// Matches as text and as JSON.
pub mod matching_report;
/// Colours of pictures and models.
mod palette;
/// Cross-sections, silhouettes and plots as SVG and PNG files.
#[cfg(feature = "command")]
pub mod picture;
/// Cylinders, cameras, lines and points as a PLY file.
pub mod ply;
/// A result as text and as JSON.
pub mod report;
