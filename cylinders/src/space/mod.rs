//! The cylinder in space, and how it appears in images.

/// Circle back to a cylinder in space; silhouettes and residuals.
pub mod cylinder;
/// Which part of a cylinder the views show.
pub mod extent;
/// The cylinder as quadric and dual quadric, and its outline from the dual.
pub mod quadric;
/// Signed, smooth distance of an image line from a silhouette.
pub mod silhouette_distance;
