//! Solvers of minimal problems as a C library.
//!
//! Each problem of `eliminant-templates` is a feature of the same name, off by default, as are the
//! families of `eliminant-solvers`. For each that is enabled the library has C functions, which
//! `include/eliminant.h` declares for all problems and documents. `capi/README.md` says how it is
//! built and installed.
//!
//! Rust programs use `eliminant-solvers`. What this crate has for Rust serves its tests and its
//! program `headers`.

eliminant::include_solver!("eliminant");
