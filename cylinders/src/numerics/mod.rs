//! Numerical methods that know nothing of cylinders.

/// How another thread ends long work early.
pub(crate) mod interrupt;
/// Damped least squares on a manifold of few dimensions.
pub(crate) mod levenberg_marquardt;
/// Seeded random numbers, for simulations.
pub mod random;
/// RANSAC for any model: samples, scores, local optimisation, termination.
pub mod ransac;
