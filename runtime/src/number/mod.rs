//! The numbers that all kernels compute with: real and complex, of usual and of twice the precision.

pub(crate) mod double_double;
pub(crate) mod float;
pub(crate) mod scalar;

pub use scalar::{Over, Real, Scalar};
