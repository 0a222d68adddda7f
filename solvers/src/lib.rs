//! Solvers of polynomial problems, most of them minimal problems of computer vision, emitted by
//! `eliminant-generator`.
//!
//! Each problem of `eliminant-templates` is a feature of the same name, off by default, and a
//! module of the same name here:
//!
//! ```toml
//! [dependencies]
//! eliminant-solvers = { version = "0.1", features = ["relpose_5pt"] }
//! ```
//!
//! The features `absolute-pose`, `relative-pose`, `circle`, `triangulation`, `radial-distortion`,
//! `focal-length`, `generalized-camera`, `least-squares` and `ranging` enable families of problems,
//! and `all` enables all of them. Only what is enabled is emitted and compiled. The documentation
//! of a module states its problem: data, unknowns, source.
//!
//! Solvers do not panic. Small ones allocate nothing, but for data at which a template is singular;
//! large ones keep their matrices on the heap, so that no solve takes more than 256 KiB of stack,
//! not even in a debug build. The documentation of each module says which it is. `solve_in` takes a
//! `Workspace`, whose memory serves solve after solve.
//!
//! Without the standard library, `default-features = false` and the feature `libm` give solvers a
//! square root. Large solvers then also need the feature `alloc`; without it they are a compile
//! error that says so. Without it, small ones allocate nothing at all, and data at which a template
//! is singular are an error.
#![no_std]
#![forbid(unsafe_code)]

eliminant::include_solver!("solvers");

/// The example in README.md.
#[cfg(all(doctest, feature = "two_conics"))]
#[doc = include_str!("../README.md")]
struct Readme;
