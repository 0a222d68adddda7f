//! How another thread ends long work early.

use std::ptr;
use std::sync::atomic::{AtomicBool, Ordering};

use thiserror::Error;

/// A flag that long work reads between its steps. Once it is set it must stay set: what the work
/// did after that is not told from what it did before, and its result is an error.
#[derive(Clone, Copy, Debug, Default)]
pub struct Interrupt<'a>(Option<&'a AtomicBool>);

/// The work was ended early by its [`Interrupt`].
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[error("interrupted")]
pub struct Interrupted;

impl<'a> Interrupt<'a> {
    /// Work ends at its next step after the flag is set.
    pub fn by(flag: &'a AtomicBool) -> Self {
        Self(Some(flag))
    }

    /// Work goes on to its end.
    pub const fn never() -> Self {
        Self(None)
    }

    /// Whether the flag is set.
    pub fn is_set(self) -> bool {
        self.0.is_some_and(|flag| flag.load(Ordering::Relaxed))
    }

    /// Nothing as long as the flag is not set.
    ///
    /// # Errors
    /// [`Interrupted`] afterwards.
    pub fn check(self) -> Result<(), Interrupted> {
        if self.is_set() { Err(Interrupted) } else { Ok(()) }
    }
}

/// Equal if both never interrupt, or by the same flag.
impl PartialEq for Interrupt<'_> {
    fn eq(&self, other: &Self) -> bool {
        self.0.map(ptr::from_ref) == other.0.map(ptr::from_ref)
    }
}
