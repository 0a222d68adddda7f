//! How a search reports what it does, and how it is told to end.

/// The stages of a search, in order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stage {
    /// Shifts are grown and reduced to templates.
    Searching,
    /// Templates are planned, and measured on real instances.
    Measuring,
}

/// Listens to a search and decides how long it goes on.
pub trait Monitor: Sync {
    /// Hears what the search does now, in words.
    fn say(&self, message: &str);

    /// Whether this stage must end now with what it has. The search asks between steps of its work,
    /// from many threads. Once the answer is true it stays true.
    fn is_over(&self, stage: Stage) -> bool;
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
