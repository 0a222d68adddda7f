//! A search that reports to Python, and ends with its time or by Ctrl-C.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use eliminant_generator::check::{SolutionCount, check_until};
use eliminant_generator::generate::plan;
use eliminant_generator::problem::Problem;
use eliminant_generator::search::choose::{Choice, Measuring, Verdict, choose};
use eliminant_generator::search::monitor::{Monitor, Stage};
use eliminant_generator::search::preference::Preference;
use eliminant_generator::search::{Found, MOST_COLUMNS, SearchError, SearchOptions, candidates};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::errors::ProblemError;
use crate::threads::interruptible;

/// The limit on the number of columns of a second try.
const MORE_COLUMNS: usize = 1500;
/// The part of a budget that is for searching. The rest is for measuring.
const SEARCHING: f64 = 0.7;

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
}

/// Ends a search and keeps what it says.
struct Watch<'a> {
    start: Instant,
    budget: Option<Duration>,
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
            Stage::Searching => SEARCHING,
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
/// left anything out. `progress` is called with a message and the seconds since the start.
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
    let mut told = String::new();
    let report = |py: Python<'_>| {
        let now = message.lock().map(|message| message.clone()).unwrap_or_default();
        if let Some(progress) = &progress
            && now != told
        {
            told.clone_from(&now);
            progress.call1(py, (now, start.elapsed().as_secs_f64()))?;
        }
        Ok(())
    };
    let work = |is_over: &AtomicBool| {
        let watch = Watch { start, budget, is_over, message: &message };
        let count = check_until(problem, is_over).map_err(|messages| messages.to_string())?;
        let outcome = settings.within_limits(problem, &count, options, &watch)?;
        match is_over.load(Ordering::Relaxed) {
            // Python raises its own error.
            true => Err("interrupted".to_owned()),
            false => outcome.file(problem),
        }
    };
    interruptible(py, work, report)?.map_err(ProblemError::new_err)
}

/// What a search within a limit on columns came to.
struct Outcome {
    found: Found,
    choice: Choice,
    options: SearchOptions,
}

impl Outcome {
    fn solves_well(&self) -> bool {
        self.choice.measured[self.choice.chosen].verdict != Verdict::Rejected
    }

    /// The file of the chosen template, which a build accepts, and whether anything was left out.
    fn file(&self, problem: &Problem) -> Result<(String, bool), String> {
        let file = self.choice.measured[self.choice.chosen].candidate.to_file(problem, &self.options);
        plan(problem, &file).map_err(|error| format!("error: {error}"))?;
        let is_cut = self.found.untried + self.found.unplanned > 0 || self.found.is_cut || self.choice.is_cut;
        Ok((file.to_text(&problem.unknowns), is_cut))
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
        if self.trials == 0 {
            return Err(PyValueError::new_err("expected at least one trial"));
        }
        let Self { seed, max_basis, shuffles, .. } = *self;
        Ok(SearchOptions { seed, max_columns, max_basis, shuffles, prefer, ..default })
    }

    /// Searches within the limit on columns, and, if nothing that solves well is found, the time is
    /// not over and no limit was given, within a wider one.
    fn within_limits(
        &self,
        problem: &Problem,
        count: &SolutionCount,
        options: SearchOptions,
        watch: &Watch<'_>,
    ) -> Result<Outcome, String> {
        let first = self.within(problem, count, options.clone(), watch);
        let is_good = first.as_ref().is_ok_and(Outcome::solves_well);
        if is_good || self.max_columns.is_some() || watch.is_over(Stage::Searching) {
            return first.map_err(|error| text(&error));
        }
        watch.say(&format!("nothing good within {} columns; trying {MORE_COLUMNS}", options.max_columns));
        let second = self.within(problem, count, SearchOptions { max_columns: MORE_COLUMNS, ..options }, watch);
        match first {
            Ok(first) if !second.as_ref().is_ok_and(Outcome::solves_well) => Ok(first),
            _ => second.map_err(|error| text(&error)),
        }
    }

    fn within(
        &self,
        problem: &Problem,
        count: &SolutionCount,
        options: SearchOptions,
        watch: &Watch<'_>,
    ) -> Result<Outcome, SearchError> {
        let found = candidates(problem, count, &options, watch)?;
        let measuring = Measuring { trials: self.trials, confirm: self.confirm, seed: self.seed };
        let choice = choose(&found.candidates, options.prefer, measuring, &|_| None, watch);
        let nothing = SearchError::NotFound {
            max_columns: options.max_columns,
            failed: Vec::new(),
            untried: found.untried,
            is_over: watch.is_over(Stage::Searching),
        };
        choice.map(|choice| Outcome { found, choice, options }).ok_or(nothing)
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
