//! Watches a search: shows what it does, and ends it when its time is up or Ctrl-C is pressed.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, OnceLock, PoisonError};
use std::thread::sleep;
use std::time::{Duration, Instant};

use indicatif::ProgressBar;

use super::progress::{begin, spinner};
use crate::search::monitor::{Monitor, Stage, is_set};

/// Whether Ctrl-C was pressed since the last search began. The search is over then.
static IS_OVER: AtomicBool = AtomicBool::new(false);
/// Whether the time for what follows a search is up, too.
static IS_INTERRUPTED: AtomicBool = AtomicBool::new(false);
/// Whether the search came to its end. The lock is held while a file is written.
static IS_CONCLUDED: Mutex<bool> = Mutex::new(false);
/// What is said if the time is up.
const TOO_LATE: &str = "error: Ctrl-C ended the search; nothing could be verified and written within two seconds\n";
/// The exit status of a process that Ctrl-C ended.
const INTERRUPTED: i32 = 130;
/// The part of a budget that is for searching. The rest is for measuring.
const SEARCHING: f64 = 0.7;
/// The same where a template is made by the trace of a Gröbner basis, after growing found nothing.
const TRACING: f64 = 0.9;
/// After Ctrl-C templates that were found are still planned, for this time at most.
const LAST_PLANS: Duration = Duration::from_millis(500);
/// After Ctrl-C the best candidates so far are still measured, until this time. Then all steps are
/// given up.
const LAST_MEASUREMENTS: Duration = Duration::from_secs(1);
/// The time from then on in which the chosen template is verified and written. The process ends
/// after it.
const LAST_STEPS: Duration = Duration::from_millis(900);

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
    /// Begins to listen to Ctrl-C. The first one ends the search, which keeps the best found so far
    /// if it can be planned, measured and written within two seconds. Else, and at the second one,
    /// the process ends, and no file is touched.
    pub(super) fn new(budget: Option<Duration>) -> Self {
        static LISTENS: OnceLock<bool> = OnceLock::new();
        // If no handler can be set, Ctrl-C ends the process as usual.
        LISTENS.get_or_init(|| {
            let interrupt = || match IS_OVER.swap(true, Ordering::SeqCst) {
                true => give_up(|_| true, ""),
                // The handler returns, so that it hears the second Ctrl-C.
                false => drop(std::thread::spawn(|| {
                    sleep(LAST_MEASUREMENTS);
                    IS_INTERRUPTED.store(true, Ordering::SeqCst);
                    sleep(LAST_STEPS);
                    give_up(|is_concluded| !is_concluded, TOO_LATE);
                })),
            };
            ctrlc::set_handler(interrupt).is_ok()
        });
        [&IS_OVER, &IS_INTERRUPTED].into_iter().for_each(|flag| flag.store(false, Ordering::SeqCst));
        *concluded() = false;
        Self { spinner: spinner(), start: Instant::now(), budget, interrupted: OnceLock::new() }
    }

    /// Clears the display.
    pub(super) fn finish(&self) {
        self.spinner.finish_and_clear();
    }

    /// Writes what the search came to. Ctrl-C waits for its end.
    pub(super) fn conclude<T>(&self, write: impl FnOnce() -> T) -> T {
        let mut is_concluded = concluded();
        let written = write();
        *is_concluded = true;
        written
    }

    /// Set where Ctrl-C was pressed.
    pub(super) fn ctrl_c(&self) -> &AtomicBool {
        &IS_OVER
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
        is_set(Some(&IS_OVER)).then(|| *self.interrupted.get_or_init(Instant::now))
    }
}

impl Drop for Watch {
    /// What is left is to tell what the search came to.
    fn drop(&mut self) {
        *concluded() = true;
        self.finish();
    }
}

fn concluded() -> std::sync::MutexGuard<'static, bool> {
    IS_CONCLUDED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Ends the process, depending on whether the search came to its end. No file is being written
/// then.
fn give_up(must_end: fn(bool) -> bool, message: &str) {
    let is_concluded = concluded();
    if must_end(*is_concluded) {
        eprint!("{message}");
        std::process::exit(INTERRUPTED);
    }
}

impl Monitor for Watch {
    fn say(&self, message: &str) {
        begin(&self.spinner, self.shown(message), None);
    }

    fn begin(&self, message: &str, steps: usize) {
        begin(&self.spinner, self.shown(message), Some(steps));
    }

    fn step(&self) {
        self.spinner.inc(1);
    }

    fn is_over(&self, stage: Stage) -> bool {
        self.is_over_at(stage, SEARCHING)
    }

    fn interruption(&self) -> Option<&AtomicBool> {
        Some(&IS_INTERRUPTED)
    }
}

/// The monitor of a template by the trace of a Gröbner basis. What is left of the budget is for
/// making it smaller.
pub(super) struct OfTrace<'a>(pub(super) &'a Watch);

impl Monitor for OfTrace<'_> {
    fn say(&self, message: &str) {
        self.0.say(message);
    }

    fn begin(&self, message: &str, steps: usize) {
        self.0.begin(message, steps);
    }

    fn step(&self) {
        self.0.step();
    }

    fn is_over(&self, stage: Stage) -> bool {
        self.0.is_over_at(stage, TRACING)
    }

    fn interruption(&self) -> Option<&AtomicBool> {
        self.0.interruption()
    }
}

impl Watch {
    fn shown(&self, message: &str) -> String {
        match self.interrupted_at() {
            Some(_) => format!("ending (Ctrl-C again to give up): {message}"),
            None => message.to_owned(),
        }
    }

    /// Whether a stage is over if the search ends after a part of the budget.
    fn is_over_at(&self, stage: Stage, searching: f64) -> bool {
        let part = match stage {
            Stage::Searching => searching,
            Stage::Planning | Stage::Measuring => 1.0,
        };
        let interrupted = self.interrupted_at().is_some_and(|at| match stage {
            Stage::Searching => true,
            Stage::Planning => at.elapsed() >= LAST_PLANS,
            Stage::Measuring => false,
        });
        interrupted
            || is_set(self.interruption())
            || self.budget.is_some_and(|budget| self.start.elapsed() >= budget.mul_f64(part))
    }
}
