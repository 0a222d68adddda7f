//! Watches a search: shows what it does, and ends it when its time is up or Ctrl-C is pressed.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use indicatif::ProgressBar;

use super::progress::spinner;
use crate::search::monitor::{Monitor, Stage};

/// How often Ctrl-C was pressed since the last search began.
static INTERRUPTS: AtomicUsize = AtomicUsize::new(0);
/// The exit status of a process that Ctrl-C ended.
const INTERRUPTED: i32 = 130;
/// The part of a budget that is for searching. The rest is for measuring.
const SEARCHING: f64 = 0.7;
/// The same where a template is made by the trace of a Gröbner basis, after growing found nothing.
const TRACING: f64 = 0.9;
/// After Ctrl-C the best candidates so far are still measured, for this time at most.
const LAST_MEASUREMENTS: Duration = Duration::from_secs(10);

/// Why a search stopped early.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum End {
    /// `--budget`.
    Budget,
    /// Ctrl-C.
    Interrupt,
    /// Shards of the search stopped early, and were merged.
    Shards,
}

impl End {
    /// The name in reports and files.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Budget => "budget",
            Self::Interrupt => "interrupt",
            Self::Shards => "shards",
        }
    }
}

/// The monitor of `eliminant search`.
pub(super) struct Watch {
    spinner: ProgressBar,
    start: Instant,
    budget: Option<Duration>,
    /// When Ctrl-C was first seen.
    interrupted: OnceLock<Instant>,
}

impl Watch {
    /// Begins to listen to Ctrl-C. The first one ends the search, which keeps the best found so
    /// far. The second one ends the process, and no file is touched.
    pub(super) fn new(budget: Option<Duration>) -> Self {
        static LISTENS: OnceLock<bool> = OnceLock::new();
        // If no handler can be set, Ctrl-C ends the process as usual.
        LISTENS.get_or_init(|| {
            let interrupt = || {
                if INTERRUPTS.fetch_add(1, Ordering::SeqCst) > 0 {
                    std::process::exit(INTERRUPTED);
                }
            };
            ctrlc::set_handler(interrupt).is_ok()
        });
        INTERRUPTS.store(0, Ordering::SeqCst);
        Self { spinner: spinner(), start: Instant::now(), budget, interrupted: OnceLock::new() }
    }

    /// Clears the display.
    pub(super) fn finish(&self) {
        self.spinner.finish_and_clear();
    }

    /// Seconds since the search began.
    pub(super) fn seconds(&self) -> f64 {
        self.start.elapsed().as_secs_f64()
    }

    /// What has ended the search, or would end it if it were still going on.
    pub(super) fn end(&self) -> Option<End> {
        if self.interrupted_at().is_some() {
            return Some(End::Interrupt);
        }
        self.is_over(Stage::Searching).then_some(End::Budget)
    }

    fn interrupted_at(&self) -> Option<Instant> {
        (INTERRUPTS.load(Ordering::SeqCst) > 0).then(|| *self.interrupted.get_or_init(Instant::now))
    }
}

impl Monitor for Watch {
    fn say(&self, message: &str) {
        self.spinner.set_message(match self.interrupted_at() {
            Some(_) => format!("ending (Ctrl-C again to give up): {message}"),
            None => message.to_owned(),
        });
    }

    fn is_over(&self, stage: Stage) -> bool {
        self.is_over_at(stage, SEARCHING)
    }
}

/// The monitor of a template by the trace of a Gröbner basis. What is left of the budget is for
/// making it smaller.
pub(super) struct OfTrace<'a>(pub(super) &'a Watch);

impl Monitor for OfTrace<'_> {
    fn say(&self, message: &str) {
        self.0.say(message);
    }

    fn is_over(&self, stage: Stage) -> bool {
        self.0.is_over_at(stage, TRACING)
    }
}

impl Watch {
    /// Whether a stage is over if the search ends after a part of the budget.
    fn is_over_at(&self, stage: Stage, searching: f64) -> bool {
        let part = match stage {
            Stage::Searching => searching,
            Stage::Measuring => 1.0,
        };
        let interrupted = self.interrupted_at().is_some_and(|at| match stage {
            Stage::Searching => true,
            Stage::Measuring => at.elapsed() >= LAST_MEASUREMENTS,
        });
        interrupted || self.budget.is_some_and(|budget| self.start.elapsed() >= budget.mul_f64(part))
    }
}
