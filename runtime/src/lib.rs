//! The types that a solver made by `eliminant-generator` returns, and the kernels that it calls.
//!
//! A solver is a module with a function `solve`. It returns a list of [`Solutions`], whose largest
//! length is known, or a [`SolveError`] that says what went wrong. [`include_solver!`] includes a
//! module that a build script wrote.
//!
//! ```text
//!            emitted code                                          this crate
//!   data --> coefficients --> elimination --> spectrum --> solution --> solutions
//!                             fill, eliminate  eigenpairs   read, polish, compare
//! ```
//!
//! The kernels do not panic on data, bound every loop, and know no problem. They are generic over
//! sizes, and over where the numbers are kept: arrays of constant sizes on the stack for small
//! emitted solvers; matrices on the heap, in a [`Workspace`], for large ones; memory of run-time
//! sizes for the plans that the generator interprets. All give the same bits. Small solvers
//! allocate nothing, but for data at which a template is singular, and only with the feature
//! `alloc`. No solve takes more than 256 KiB of stack.
//!
//! Without the default feature `std` the crate is `no_std`; the feature `libm` then supplies the
//! square root, and the feature `alloc` the heap of large solvers and of solutions that are
//! followed from other data. The feature `serde` serialises [`Solutions`].
#![no_std]
#![forbid(unsafe_code)]
// `!(x > y)` is written where a NaN must take the branch, too.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

#[cfg(feature = "std")]
extern crate std;

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!("eliminant needs one of its features `std` (default) and `libm` for square roots");

#[cfg(feature = "alloc")]
mod dynamic_size;
mod error;
mod memory;
mod number;
mod size;
mod solutions;

/// Memory and options of solves.
mod workspace;

/// From the data to the action matrix: coefficients, template, elimination.
mod elimination;
/// From the action matrix to eigenpairs.
mod spectrum;

/// The trait that tells one solver from another.
mod solver_instance;

/// From an eigenpair to a solution: read off, polished on the original equations, compared with the
/// others.
mod solution;

/// Solutions of data at which a template stands for nothing, from data nearby.
mod continuation;

/// All stages for one instance, with a second attempt at twice the precision if solutions are
/// missing.
mod determinant;
mod driver;

/// Data that are derived from data before a solve.
mod derived;

/// Several instances side by side.
mod batch;

/// Units of data and unknowns in which a template is accurate.
mod scaling;

/// The points of the eigenpairs before the polish, for measurements.
mod unpolished;

#[doc(hidden)]
pub mod emitted;

pub use error::SolveError;
pub use num_complex::Complex;
pub use number::Scalar;
pub use solutions::{IntoIter, Solutions};
pub use workspace::{SecondAttempts, Workspace};

/// In the module of a solver that keeps its matrices on the heap: the runtime has one.
#[cfg(feature = "alloc")]
#[doc(hidden)]
#[macro_export]
macro_rules! needs_alloc {
    ($solver:literal) => {};
}

/// The same, where the runtime has none.
#[cfg(not(feature = "alloc"))]
#[doc(hidden)]
#[macro_export]
macro_rules! needs_alloc {
    ($solver:literal) => {
        compile_error!(concat!(
            "the solver `",
            $solver,
            "` keeps its matrices on the heap: turn on the feature `alloc` of `eliminant`, which `std` turns on, too"
        ));
    };
}

/// Includes the solver of that name, which the build script wrote. The file holds `pub mod NAME {
/// .. }`.
///
/// ```text
/// // lib.rs; a build script runs eliminant_generator::Generator on problems/five_point.rs:
/// eliminant::include_solver!("five_point");
/// let solutions = five_point::solve(&points)?;
/// ```
#[macro_export]
macro_rules! include_solver {
    ($name:literal) => {
        include!(concat!(env!("OUT_DIR"), "/", $name, ".rs"));
    };
}
