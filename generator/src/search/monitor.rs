//! How a search tells what it does, and how it is told to end.

/// The stages of a search, in order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stage {
    /// Templates are searched.
    Searching,
    /// Templates are planned, and measured on real instances.
    Measuring,
}

/// Listens to a search and decides how long it goes on.
pub trait Monitor: Sync {
    /// Hears what goes on, in words.
    fn say(&self, message: &str);

    /// Whether this stage must end now with what it has. Asked between steps of the work, from many threads; once true it stays true.
    fn is_over(&self, stage: Stage) -> bool;
}

/// Nobody listens, and the search goes on to its end.
#[derive(Clone, Copy, Debug)]
pub struct Unmonitored;

impl Monitor for Unmonitored {
    fn say(&self, _: &str) {}

    fn is_over(&self, _: Stage) -> bool {
        false
    }
}
