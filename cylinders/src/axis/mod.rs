//! Viewing planes to the direction of the axis.

/// Viewing planes to the direction of the axis; conditioned, or refused.
pub mod direction;
/// Viewing planes to the direction of the axis if some planes are wrong.
pub mod robust_direction;
