//! What the C functions around solvers share, which `eliminant-capi-generator` writes.
//!
//! ```text
//!  pointers, lengths --> Input, checked --> arrays --> solver --> rows --> buffers of the caller
//!                          |                             | panic
//!                          +-----------------------------+--> Code, a number
//! ```
//!
//! All unsafe code of a library is here and in the functions that call it. Buffers are read before
//! a solve and written after it, through raw pointers. Nothing is allocated.
#![warn(missing_docs)]

mod buffer;
mod code;
mod numbers;

/// No panic leaves the library.
mod guard;

/// One instance.
mod single;

/// Many instances.
mod batch;

/// One value.
mod value;

/// Options of a solve.
mod options;

/// Files of a library's headers.
mod headers;

pub use batch::{Batch, BatchOutput, solve_batch};
pub use buffer::Input;
pub use code::{Code, error_text};
pub use headers::write_headers;
pub use numbers::{Numbers, row};
pub use options::workspace;
pub use single::{Output, solve};
pub use value::value;
