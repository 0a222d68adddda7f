//! Writes a C library around solvers: `extern "C"` functions, a C header and a C++ header.
//!
//! ```no_run
//! // build.rs
//! fn main() -> Result<(), eliminant_capi_generator::LibraryError> {
//!     eliminant_capi_generator::Library::new("own").problems("problems").run()
//! }
//! ```
//!
//! All three are written from one list, the [`Interface`]s of the problems, so that they agree.
//! cbindgen reads source, not what a build script writes, and would need a nightly compiler to
//! expand it; it would not know shapes, lengths and sources either.
#![warn(missing_docs)]

/// Problem to the functions and rows of its C interface.
mod interface;
mod names;

/// The C header.
mod header;

/// The C++ header.
mod cpp;

/// The `extern "C"` functions.
mod functions;

/// A folder of problems to a library in `OUT_DIR`: the API of build scripts.
mod library;

pub use cpp::cpp_header;
pub use header::header;
pub use interface::{Field, Interface, MEASURES, Mean, Parameter, Row};
pub use library::{Library, LibraryError, interfaces};
