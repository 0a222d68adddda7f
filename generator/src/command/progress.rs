//! Progress of long work, on standard error and only if that is a terminal.

use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

/// Shows what goes on in words, with the time that it has taken.
pub(super) fn spinner() -> ProgressBar {
    styled(ProgressBar::new_spinner(), "{spinner} [{elapsed_precise}] {msg}")
}

/// Counts up to `length`.
pub(super) fn bar(length: usize) -> ProgressBar {
    styled(ProgressBar::new(length as u64), "[{elapsed_precise}] {wide_bar} {pos}/{len} ({eta} left)")
}

fn styled(bar: ProgressBar, template: &str) -> ProgressBar {
    // The bar draws nothing if standard error is not a terminal.
    bar.set_style(ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar.enable_steady_tick(Duration::from_millis(100));
    bar
}
