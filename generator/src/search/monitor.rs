//! How a search reports what it does, and how it is told to end.
//!
//! There are two ways to end. A search whose stage is over keeps what it has found: the step that
//! goes on comes to its end, and templates are planned and measured, which may take minutes for
//! large ones. Where the search is interrupted, every step is given up within a second.

use std::sync::atomic::{AtomicBool, Ordering};

/// The stages of a search, in order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stage {
    /// Shifts are grown and reduced to templates.
    Searching,
    /// Templates are planned.
    Planning,
    /// Templates are measured on real instances.
    Measuring,
}

/// Listens to a search and decides how long it goes on.
pub trait Monitor: Sync {
    /// Hears what the search does now, in words.
    fn say(&self, message: &str);

    /// Hears of work that consists of so many steps of about one length.
    fn begin(&self, message: &str, steps: usize) {
        let _ = steps;
        self.say(message);
    }

    /// Hears that one of the steps is done. The search tells from many threads.
    fn step(&self) {}

    /// Whether this stage must end now with what it has. The search asks between steps of its work,
    /// from many threads. Once the answer is true it stays true.
    fn is_over(&self, stage: Stage) -> bool;

    /// A flag that is set where the search must return within a second, whatever it loses: only
    /// templates that are planned by then are kept. Once set it stays set, and all stages are over.
    fn interruption(&self) -> Option<&AtomicBool> {
        None
    }
}

/// Whether a flag is there and set.
pub(crate) fn is_set(flag: Option<&AtomicBool>) -> bool {
    flag.is_some_and(|flag| flag.load(Ordering::Relaxed))
}

/// A monitor that hears nothing and lets the search go on to its end.
#[derive(Clone, Copy, Debug)]
pub struct Unmonitored;

impl Monitor for Unmonitored {
    fn say(&self, _: &str) {}

    fn is_over(&self, _: Stage) -> bool {
        false
    }
}
