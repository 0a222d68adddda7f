//! Polynomial problems with the elimination templates found for them, as data for build scripts.
//!
//! Each problem is a pair of files in [`FOLDER`]: `NAME.rs` states it, in the problem language of
//! `eliminant-generator`, and `NAME.template.toml` is its elimination template. A build script
//! emits the solvers of some of them:
//!
//! ```text
//! fn main() -> Result<(), eliminant_generator::BuildError> {
//!     eliminant_generator::Generator::new()
//!         .problems(eliminant_templates::FOLDER)
//!         .only(["relpose_5pt", "two_conics"])
//!         .run()
//! }
//! ```
//!
//! This crate has no dependencies. The crate `eliminant-solvers` does the same for every problem
//! that is enabled by a feature: take that one unless a solver is to be emitted with options of its
//! own.
#![no_std]

/// The folder with the files `NAME.rs` and `NAME.template.toml`, as an absolute path on the machine
/// that compiles.
///
/// It is where cargo keeps the source of this package: build scripts can read it, installed
/// programs cannot.
pub const FOLDER: &str = env!("CARGO_MANIFEST_DIR");
