//! How many things of a number of things are done, as Python hears it.

use std::sync::atomic::{AtomicUsize, Ordering};

use pyo3::prelude::*;

/// A count that all threads add to.
pub(crate) struct Tally {
    done: AtomicUsize,
    total: AtomicUsize,
    progress: Option<Py<PyAny>>,
}

impl Tally {
    /// Nothing is done yet. `progress` is called with what is done and with the total.
    pub(crate) fn new(progress: Option<Py<PyAny>>, total: usize) -> Self {
        Self { done: AtomicUsize::new(0), total: AtomicUsize::new(total), progress }
    }

    /// There is so much to do.
    pub(crate) fn expect(&self, total: usize) {
        self.total.store(total, Ordering::Relaxed);
    }

    /// So many more are done.
    pub(crate) fn add(&self, more: usize) {
        self.done.fetch_add(more, Ordering::Relaxed);
    }

    /// Tells Python how far it is.
    ///
    /// # Errors
    /// That of the callable.
    pub(crate) fn tell(&self, py: Python<'_>) -> PyResult<()> {
        let Some(progress) = &self.progress else { return Ok(()) };
        let [done, total] = [&self.done, &self.total].map(|count| count.load(Ordering::Relaxed));
        progress.call1(py, (done, total)).map(drop)
    }
}
