//! The circle of the cross-section, and the least squares circle of tangent lines.

/// Why there is no circle.
mod error;
/// Tangent lines to the least squares circle.
mod fit;

use nalgebra::Point2;

pub use error::CircleError;
pub use fit::{CircleFit, fit_circle, fit_circle_in_front};

/// A circle of the cross-section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    /// Centre, world units.
    pub centre: Point2<f64>,
    /// Radius, world units.
    pub radius: f64,
}
