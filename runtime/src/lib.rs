//! What a solver made by `eliminant-generator` returns, and the kernels that it calls.
//!
//! A solver is a module with a function `solve`. It returns up to a known number of [`Solutions`], or a [`SolveError`]
//! that says why there are none. [`include_solver!`] includes a module that a build script wrote.
//!
//! ```text
//!            emitted code                                          this crate
//!   data --> coefficients --> elimination --> spectrum --> solution --> solutions
//!                             fill, eliminate  eigenpairs   read, polish, compare
//! ```
//!
//! Nothing here allocates, panics on data, loops without a bound or knows a problem. The kernels are generic over how
//! many numbers there are and where they are kept: arrays of constant sizes for emitted solvers, memory of run-time sizes
//! for the plans that the generator interprets. Both give the same bits.
//!
//! Without the default feature `std` the crate is `no_std`; feature `libm` then supplies the square root. Feature `serde`
//! serialises [`Solutions`]. Feature `alloc` adds the sizes that are known at run time.
#![no_std]
#![forbid(unsafe_code)]
// `!(x > y)` where a NaN must take the branch, too.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

#[cfg(feature = "alloc")]
extern crate alloc;
#[cfg(feature = "std")]
extern crate std;

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!("eliminant needs one of its features `std` (default) and `libm` for square roots");

mod error;
mod number;
mod size;
mod solutions;

/// Data to action matrix: coefficients, template, elimination.
mod elimination;
/// Action matrix to eigenpairs.
mod spectrum;

/// What differs between solvers.
mod solver_instance;

/// Eigenpair to solution: read off, polished on the original equations, distinct from the others.
mod solution;

/// All of it for one instance, with a second attempt at twice the precision if solutions are missing.
mod driver;

/// The points of the eigenpairs before the polish, for measurements.
mod unpolished;

#[doc(hidden)]
pub mod emitted;

pub use error::SolveError;
pub use num_complex::Complex;
pub use number::Scalar;
pub use solutions::{IntoIter, Solutions};

/// Includes the solver of that name, which the build script wrote: the emitted file holds `pub mod NAME { .. }`.
///
/// ```text
/// // lib.rs, with problems/five_point.rs and a build script that runs eliminant_generator::Generator:
/// eliminant::include_solver!("five_point");
/// let solutions = five_point::solve(&points)?;
/// ```
#[macro_export]
macro_rules! include_solver {
    ($name:literal) => {
        include!(concat!(env!("OUT_DIR"), "/", $name, ".rs"));
    };
}
