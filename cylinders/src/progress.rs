//! Progress bars, if standard error is a terminal.

use indicatif::{ProgressBar, ProgressStyle};

/// A bar of this length, followed by a message.
pub(super) fn progress_bar(length: usize) -> ProgressBar {
    let style = ProgressStyle::with_template("{wide_bar} {pos}/{len} {eta} {msg}");
    ProgressBar::new(length as u64).with_style(style.unwrap_or(ProgressStyle::default_bar()))
}
