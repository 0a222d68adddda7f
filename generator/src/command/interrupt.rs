//! Ctrl-C for subcommands that end with an error and leave nothing behind.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};

/// Whether Ctrl-C was pressed.
static IS_INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// Begins to listen to Ctrl-C. Programs that run get it, too, and end.
pub(super) fn listen() {
    static LISTENS: OnceLock<bool> = OnceLock::new();
    // If no handler can be set, Ctrl-C ends the process as usual.
    LISTENS.get_or_init(|| ctrlc::set_handler(|| IS_INTERRUPTED.store(true, Ordering::Relaxed)).is_ok());
}

/// Whether Ctrl-C was pressed since the command listens.
pub(super) fn is_interrupted() -> bool {
    IS_INTERRUPTED.load(Ordering::Relaxed)
}
