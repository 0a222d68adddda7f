//! No panic leaves the library.

use std::panic::{AssertUnwindSafe, catch_unwind};

use crate::code::Code;

#[cfg(not(panic = "unwind"))]
compile_error!("a C library that must not end its caller needs `panic = \"unwind\"` in its profile");

/// What the function returns, or [`Code::Panic`] if it panics.
pub(crate) fn guarded<T>(function: impl FnOnce() -> Result<T, Code>) -> Result<T, Code> {
    // Nothing that the function changes is seen after a panic: results are written from what it
    // returns.
    catch_unwind(AssertUnwindSafe(function)).unwrap_or_else(|payload| {
        // The destructor of what was thrown could panic, too, and throw something of that kind.
        if let Err(second) = catch_unwind(AssertUnwindSafe(|| drop(payload))) {
            std::mem::forget(second);
        }
        Err(Code::Panic)
    })
}
