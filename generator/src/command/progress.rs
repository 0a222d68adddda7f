//! Progress of long work, on standard error and only if that is a terminal.

use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

/// What goes on in words, with the time that it has taken.
const WORDS: &str = "{spinner} [{elapsed_precise}] {msg}";
/// How much of it is done, besides.
const WORDS_AND_STEPS: &str = "[{elapsed_precise}] {bar:20} {pos}/{len}  {msg}";
/// How much is done, and the time that is left.
const STEPS: &str = "[{elapsed_precise}] {wide_bar} {pos}/{len} ({eta} left)";

/// Shows what goes on in words.
pub(super) fn spinner() -> ProgressBar {
    styled(ProgressBar::new_spinner(), WORDS)
}

/// Counts up to `length`.
pub(super) fn bar(length: usize) -> ProgressBar {
    styled(ProgressBar::new(length as u64), STEPS)
}

fn styled(bar: ProgressBar, template: &str) -> ProgressBar {
    // The bar draws nothing if standard error is not a terminal.
    bar.set_style(style(template));
    bar.enable_steady_tick(Duration::from_millis(100));
    bar
}

fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar())
}

/// Shows by a spinner that another part of the work begins. Its `steps` are counted, if they are
/// known.
pub(super) fn begin(spinner: &ProgressBar, message: String, steps: Option<usize>) {
    spinner.set_style(style(if steps.is_some() { WORDS_AND_STEPS } else { WORDS }));
    spinner.set_length(steps.unwrap_or(0) as u64);
    spinner.set_position(0);
    spinner.set_message(message);
}
