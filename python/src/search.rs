//! A search that reports to Python, and ends with its time or by Ctrl-C.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use eliminant_generator::check::{SolutionCount, check_until};
use eliminant_generator::generate::plan;
use eliminant_generator::problem::Problem;
use eliminant_generator::search::choose::{Choice, Measuring, choose};
use eliminant_generator::search::fallback::{Chosen, Fallback};
use eliminant_generator::search::monitor::{Monitor, Stage};
use eliminant_generator::search::preference::Preference;
use eliminant_generator::search::{
    Found, MORE_COLUMNS, MOST_COLUMNS, SearchError, SearchOptions, candidates, traced_candidates,
};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::errors::ProblemError;
use crate::threads::interruptible;

/// The part of a budget that is for searching. The rest is for measuring.
const SEARCHING: f64 = 0.7;
/// The same where a template is made by the trace of a Gröbner basis, after growing found nothing.
const TRACING: f64 = 0.9;

/// What a search is asked for.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Settings {
    prefer: String,
    seed: u64,
    max_columns: Option<usize>,
    max_basis: Option<usize>,
    shuffles: u64,
    trials: usize,
    confirm: usize,
    trace: bool,
}

/// Ends a search and keeps what it says.
#[derive(Clone, Copy)]
struct Watch<'a> {
    start: Instant,
    budget: Option<Duration>,
    /// The part of the budget that is for searching.
    searching: f64,
    is_over: &'a AtomicBool,
    message: &'a Mutex<String>,
}

impl Monitor for Watch<'_> {
    fn say(&self, message: &str) {
        if let Ok(mut last) = self.message.lock() {
            message.clone_into(&mut last);
        }
    }

    fn is_over(&self, stage: Stage) -> bool {
        let part = match stage {
            Stage::Searching => self.searching,
            Stage::Planning | Stage::Measuring => 1.0,
        };
        self.is_over.load(Ordering::Relaxed)
            || self.budget.is_some_and(|budget| self.start.elapsed() >= budget.mul_f64(part))
    }

    fn interruption(&self) -> Option<&AtomicBool> {
        Some(self.is_over)
    }
}

/// Searches a template of a problem, as the command does. Returns its file, and whether the budget
/// left anything out. Between whiles `progress` is called with the last message and the seconds
/// since the start.
pub(crate) fn search(
    py: Python<'_>,
    problem: &Problem,
    settings: &Settings,
    budget: Option<f64>,
    progress: Option<Py<PyAny>>,
) -> PyResult<(String, bool)> {
    let wrong = |_| PyValueError::new_err("expected a budget of seconds above 0");
    let budget = budget.map(Duration::try_from_secs_f64).transpose().map_err(wrong)?;
    let options = settings.options()?;
    let (message, start) = (Mutex::new("counting solutions".to_owned()), Instant::now());
    let report = |py: Python<'_>| {
        let message = message.lock().map(|message| message.clone()).unwrap_or_default();
        let tell = |progress: &Py<PyAny>| progress.call1(py, (message, start.elapsed().as_secs_f64())).map(drop);
        progress.as_ref().map_or(Ok(()), tell)
    };
    let work = |is_over: &AtomicBool| {
        let watch = Watch { start, budget, searching: SEARCHING, is_over, message: &message };
        let count = check_until(problem, is_over).map_err(|messages| messages.to_string())?;
        settings.search(problem, &count, options, &watch)
    };
    interruptible(py, work, report)?.map_err(ProblemError::new_err)
}

/// What an attempt came to.
struct Outcome {
    choice: Choice,
    options: SearchOptions,
    is_cut: bool,
}

impl Chosen for Outcome {
    fn solves_well(&self) -> bool {
        self.choice.solves_well()
    }

    fn is_cut(&self) -> bool {
        self.is_cut
    }
}

impl Outcome {
    /// The file of the chosen template, which a build accepts, and whether anything was left out.
    fn file(&self, problem: &Problem) -> Result<(String, bool), String> {
        let file = self.choice.measured[self.choice.chosen].candidate.to_file(problem, &self.options);
        plan(problem, &file).map_err(|error| format!("error: {error}"))?;
        Ok((file.to_text(&problem.unknowns), self.is_cut))
    }
}

impl Settings {
    fn options(&self) -> PyResult<SearchOptions> {
        let prefer = match self.prefer.as_str() {
            "speed" => Preference::Speed,
            "stability" => Preference::Stability,
            "size" => Preference::Size,
            other => return Err(PyValueError::new_err(format!("`{other}`: expected speed, stability or size"))),
        };
        let default = SearchOptions::default();
        let max_columns = self.max_columns.unwrap_or(default.max_columns);
        if !(2..=MOST_COLUMNS).contains(&max_columns) {
            return Err(PyValueError::new_err(format!("expected from 2 to {MOST_COLUMNS} columns")));
        }
        if self.trace && self.max_columns.is_some() {
            return Err(PyValueError::new_err("the trace of a Gröbner basis has no limit on columns"));
        }
        if self.trials == 0 {
            return Err(PyValueError::new_err("expected at least one trial"));
        }
        let Self { seed, max_basis, shuffles, .. } = *self;
        Ok(SearchOptions { seed, max_columns, max_basis, shuffles, prefer, ..default })
    }

    /// Searches within the limit on columns. What follows where nothing that solves well is found
    /// ([`Fallback::after`]) does so unless a limit was given.
    fn search(
        &self,
        problem: &Problem,
        count: &SolutionCount,
        options: SearchOptions,
        watch: &Watch<'_>,
    ) -> Result<(String, bool), String> {
        let within = |max_columns: usize| {
            let options = SearchOptions { max_columns, ..options.clone() };
            candidates(problem, count, &options, watch).and_then(|found| self.chosen(&found, options, watch))
        };
        let traced = || {
            // After Ctrl-C nothing is kept.
            if watch.is_over.load(Ordering::Relaxed) {
                return Err(SearchError::NotFound { max_columns: 0, failed: Vec::new(), untried: 0, is_over: true });
            }
            let (of_trace, options) = (Watch { searching: TRACING, ..*watch }, options.clone());
            let found = traced_candidates(problem, count, &options, &of_trace)?;
            self.chosen(&found, options, watch)
        };
        let wider = || {
            watch.say(&format!("nothing good within {} columns; trying {MORE_COLUMNS}", options.max_columns));
            Ok(within(MORE_COLUMNS))
        };
        let has_limit = self.max_columns.is_some();
        let fallback = Fallback {
            wider: (!has_limit).then_some(&wider as _),
            traced: (!has_limit).then_some(&traced as _),
            keep: &|outcome: &mut Outcome| outcome.is_cut |= watch.is_over(Stage::Searching),
            is_over: &|| watch.is_over(Stage::Searching),
        };
        let found = match self.trace {
            true => traced(),
            false => fallback.after(within(options.max_columns)).and_then(|attempt| attempt),
        };
        let found = found.map_err(|error| text(&error))?;
        match watch.is_over.load(Ordering::Relaxed) {
            // Python raises its own error.
            true => Err("interrupted".to_owned()),
            false => found.file(problem),
        }
    }

    /// Measures and chooses.
    fn chosen(&self, found: &Found, options: SearchOptions, watch: &Watch<'_>) -> Result<Outcome, SearchError> {
        let measuring = Measuring { trials: self.trials, confirm: self.confirm, seed: self.seed };
        let choice = choose(&found.candidates, options.prefer, measuring, &|_| None, watch);
        let nothing = SearchError::NotFound {
            max_columns: options.max_columns,
            failed: Vec::new(),
            untried: found.untried,
            is_over: watch.is_over(Stage::Searching),
        };
        let choice = choice.ok_or(nothing)?;
        let is_cut = found.untried + found.unplanned > 0 || found.is_cut || choice.is_cut;
        Ok(Outcome { choice, options, is_cut })
    }
}

/// The text of an error with a way out.
fn text(error: &SearchError) -> String {
    match error {
        SearchError::NotFound { max_columns: limit @ ..MOST_COLUMNS, is_over: false, .. } => {
            let more = (3 * limit).min(MOST_COLUMNS);
            format!("error: {error}\nhelp: `max_columns={more}` looks further, and takes longer")
        }
        _ => format!("error: {error}"),
    }
}
