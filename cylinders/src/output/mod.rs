//! Results as text, JSON, models and pictures.

/// Matches as text and as JSON.
pub mod matching_report;
/// Numbers in columns of a text.
pub(crate) mod number;
/// A result as one HTML page.
#[cfg(feature = "command")]
pub mod page;
/// Colours of pictures and models.
pub(crate) mod palette;
/// Cross-sections, silhouettes and plots as SVG and PNG files.
#[cfg(feature = "command")]
pub mod picture;
/// Cylinders, cameras, lines and points as a PLY file.
pub mod ply;
/// A result as plain numbers, for JSON.
pub mod report;
/// Results as tables of a page.
#[cfg(feature = "command")]
pub mod report_table;
/// A result as text.
mod report_text;
