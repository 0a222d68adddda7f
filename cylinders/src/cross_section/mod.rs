//! Viewing planes to the cross-section of the cylinder: tangent lines, and the circle or conic that
//! they touch. One trait stands before all methods.

/// Tangent lines to the least squares circle: normalisation, and the best of the stationary
/// circles.
pub mod circle;
/// Three tangent lines to their incircle and excircles, in closed form.
pub mod closed_form;
/// Tangent lines to all stationary circles, the global minimum first.
pub mod least_squares;
/// Tangent lines to a conic that need not be a circle.
pub mod linear_conic;
/// Three tangent lines to the circles that touch them, by the emitted solver.
pub mod minimal;
/// Pairs of tangent lines to a circle: axis first, then radius.
pub mod navab;
/// Tangent lines to coordinates of order one, in which they are solved.
mod normalise;
/// Viewing planes to tangent lines of the cross-section.
pub mod rectify;
/// Tangent lines to conics: the trait of all methods.
pub mod section;
/// Cameras in the cross-section: which circles are in front of them.
pub mod sight;
/// Tangent lines to all stationary circles, by the emitted solver.
mod stationary;
