//! Searches elimination templates: many ways to grow, act and reduce, judged by the planned work and, where it is measured, by stability.
//!
//! The result depends on the problem and the options only: neither on the number of threads nor on time.

use crate::explore::explore;
use crate::monitor::Monitor;
use crate::plan::{Plan, RootMethod};
use crate::preference::{Cost, Preference};
use crate::presolve::Presolve;
use crate::problem::Problem;
use crate::schedule::{ScheduleError, schedule};
use crate::starts::{Form, SEARCH_FIELD, forms, growths};
use crate::template::EliminationTemplate;
use crate::template::file::TemplateFile;
use crate::template::grow::Growth;
use crate::template::verify::verify;

/// Limits and seeds of a search.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SearchOptions {
    /// Seed of the instances and of the shuffled deletion orders.
    pub seed: u64,
    /// No template has more columns before it is reduced.
    pub max_columns: usize,
    /// How often each of the smallest templates is enlarged and reduced anew in a shuffled order.
    pub shuffles: u64,
    /// What is looked for first.
    pub prefer: Preference,
}

impl SearchOptions {
    /// The bounds of the search that a build script makes for a problem without a template file.
    pub fn for_a_build() -> Self {
        Self { max_columns: 150, shuffles: 0, ..Self::default() }
    }
}

impl Default for SearchOptions {
    fn default() -> Self {
        Self { seed: 1, max_columns: 600, shuffles: 12, prefer: Preference::default() }
    }
}

/// A template with how it was found and what it costs.
#[derive(Clone, Debug)]
pub struct Candidate {
    /// Which unknowns were eliminated before.
    pub presolve: Presolve,
    /// How its shifts were grown.
    pub growth: Growth,
    /// The template.
    pub template: EliminationTemplate,
    /// The solver.
    pub plan: Plan,
}

impl Candidate {
    /// In the order of the preference; ties by content, so that the order does not depend on how the search ran.
    fn rank(&self, preference: Preference) -> ([usize; 3], String) {
        (preference.key(&Cost::of(self)), format!("{:?}", self.template))
    }

    /// The file that records it.
    pub fn to_file(&self, problem: &Problem, options: &SearchOptions) -> TemplateFile {
        let mut provenance = vec![
            ("generator".to_owned(), env!("CARGO_PKG_VERSION").to_owned()),
            ("prefer".to_owned(), options.prefer.to_string()),
            ("growth".to_owned(), self.growth.to_string()),
            ("shuffles".to_owned(), options.shuffles.to_string()),
            ("seed".to_owned(), options.seed.to_string()),
            ("prime".to_owned(), SEARCH_FIELD.modulus().to_string()),
        ];
        provenance.push(("operations".to_owned(), self.plan.operations().total().to_string()));
        TemplateFile {
            problem: problem.name.clone(),
            fingerprint: problem.fingerprint(),
            solutions: self.plan.solutions,
            presolve: self.presolve,
            roots: self.plan.roots,
            template: self.template.clone(),
            provenance,
        }
    }
}

/// Why a search found nothing.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SearchError {
    /// Random data over Z_p could not be drawn with the support of the problem.
    #[error("no random instance has the support of the problem: a coefficient vanishes for most data")]
    NoInstance,
    /// No set of shifts within the limits solves.
    #[error(
        "no elimination template within {max_columns} columns: tried {tried} sets of shifts, the largest {rows} x {columns}"
    )]
    NotFound {
        /// The limit.
        max_columns: usize,
        /// Number of sets of shifts.
        tried: usize,
        /// Rows of the largest.
        rows: usize,
        /// Columns of the largest.
        columns: usize,
    },
}

/// All templates found, at least one, in the order of the preference. `solutions` is the number of solutions of the problem.
pub fn candidates(
    problem: &Problem,
    solutions: usize,
    options: &SearchOptions,
    monitor: &dyn Monitor,
) -> Result<Vec<Candidate>, SearchError> {
    let forms = forms(problem, options)?;
    let growths: Vec<(&Form, Growth)> =
        forms.iter().flat_map(|form| growths(form).into_iter().map(move |growth| (form, growth))).collect();
    monitor.say(&format!("{solutions} solutions; growing shifts in {} ways", growths.len()));
    let explored = map(&growths, |(form, growth)| explore(form, growth, solutions, options));
    let tried = explored.iter().map(|explored| explored.tried).sum();
    let largest = explored.iter().map(|explored| explored.largest).max().unwrap_or_default();
    let work: Vec<(&Form, &Growth, EliminationTemplate)> = growths
        .iter()
        .zip(explored)
        .flat_map(|((form, growth), explored)| explored.templates.into_iter().map(move |t| (*form, growth, t)))
        .collect();
    monitor.say(&format!("planning {} templates", work.len()));
    let plan = |(form, growth, template): &(&Form, &Growth, EliminationTemplate)| {
        candidate(problem, form, growth, template, solutions)
    };
    let mut found: Vec<Candidate> = map(&work, plan).into_iter().flatten().collect();
    found.sort_by_cached_key(|candidate| candidate.rank(options.prefer));
    found.dedup_by(|a, b| a.template == b.template && a.presolve == b.presolve);
    if found.is_empty() {
        let (columns, rows) = largest;
        return Err(SearchError::NotFound { max_columns: options.max_columns, tried, rows, columns });
    }
    monitor.say(&format!("{} different templates", found.len()));
    Ok(found)
}

/// `None` if the template does not hold at the other prime, or no unknown can be read.
fn candidate(
    problem: &Problem,
    form: &Form,
    growth: &Growth,
    template: &EliminationTemplate,
    solutions: usize,
) -> Option<Candidate> {
    verify(template, form.check.field, &form.check.equations).ok()?;
    let plan = schedule(problem, &form.reduced, template, solutions, RootMethod::Eigenvalues);
    debug_assert!(!matches!(plan, Err(ScheduleError::Plan(_))), "{plan:?}");
    Some(Candidate { presolve: form.presolve, growth: growth.clone(), template: template.clone(), plan: plan.ok()? })
}

/// Maps in parallel where the feature `search` is on; the order of the results is that of the items in any case.
fn map<T: Sync, R: Send>(items: &[T], f: impl Fn(&T) -> R + Sync + Send) -> Vec<R> {
    #[cfg(feature = "search")]
    {
        use rayon::prelude::*;
        items.par_iter().map(f).collect()
    }
    #[cfg(not(feature = "search"))]
    items.iter().map(f).collect()
}
