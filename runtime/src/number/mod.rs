//! The numbers of all kernels: real and complex, of usual precision and of twice that.

pub(crate) mod arithmetic;
pub(crate) mod double_double;
pub(crate) mod float;
pub(crate) mod scalar;
pub(crate) mod sums;

pub use arithmetic::Arithmetic;
pub use scalar::{Over, Real, Scalar};
