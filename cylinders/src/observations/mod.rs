//! What is observed: cameras and image lines, and the files from which they are read.

/// Bundler's cameras.
pub mod bundler;
/// COLMAP models, text and binary: cameras of photographs, and points.
pub mod colmap;
/// Copies of a line to one line.
pub mod copies;
/// Lens distortion, and its inverse.
pub mod distortion;
/// Scene files: JSON to views.
pub mod input;
/// The camera behind the pixels of a photograph, with its distortion.
pub mod photograph;
/// Views of one or several cylinders, with the points around them.
pub mod scene;
/// CSV files of line segments: end points to fitted lines.
pub mod segments;
/// Cameras of instant-ngp and nerfstudio.
pub mod transforms;
/// Cameras, silhouette lines and viewing planes; validated.
pub mod view;
