//! Viewing planes to the direction of the axis.

/// Viewing planes to the direction of the axis; conditioned, or refused.
pub mod direction;
/// Viewing planes, some of them wrong, to the direction of the axis.
pub mod robust_direction;
