//! Searches elimination templates: many ways to grow, act and reduce, judged by the planned work and, where it is measured, by stability.
//!
//! The result depends on the problem and the options only: not on the number of threads, and not on time unless the monitor ends the search early. Work is done in an
//! order that depends on the problem and the options only, so that what is left out then is the end of it.

use std::sync::atomic::{AtomicUsize, Ordering};

use crate::attempt::{Attempt, Attempts};
use crate::check::Algebra;
use crate::explore::{Explored, Memory, explore};
use crate::monitor::{Monitor, Stage};
use crate::plan::{Plan, RootMethod};
use crate::preference::{Cost, Preference};
use crate::presolve::Presolve;
use crate::problem::Problem;
use crate::schedule::{ScheduleError, schedule};
use crate::share::Share;
use crate::starts::{Form, SEARCH_FIELD, forms, growths, obstacle};
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
    /// No template has a larger basis, where a smaller one can hold all solutions.
    pub max_basis: Option<usize>,
    /// How often each of the smallest templates is enlarged and reduced anew in a shuffled order.
    pub shuffles: u64,
    /// What is looked for first.
    pub prefer: Preference,
    /// Which of the ways to grow are tried.
    pub share: Share,
}

impl SearchOptions {
    /// The bounds of the search that a build script makes for a problem without a template file.
    pub fn for_a_build() -> Self {
        Self { max_columns: 150, shuffles: 0, ..Self::default() }
    }
}

impl Default for SearchOptions {
    fn default() -> Self {
        Self {
            seed: 1,
            max_columns: 600,
            max_basis: None,
            shuffles: 12,
            prefer: Preference::default(),
            share: Share::ALL,
        }
    }
}

/// A template with how it was found and what it costs.
#[derive(Clone, Debug)]
pub struct Candidate {
    /// Which unknowns were eliminated before.
    pub presolve: Presolve,
    /// Position of the way in which its shifts were grown among all ways to grow.
    pub way: usize,
    /// The way in words.
    pub growth: String,
    /// The template.
    pub template: EliminationTemplate,
    /// The solver.
    pub plan: Plan,
}

impl Candidate {
    /// The file that records it.
    pub fn to_file(&self, problem: &Problem, options: &SearchOptions) -> TemplateFile {
        let mut provenance = vec![
            ("generator".to_owned(), env!("CARGO_PKG_VERSION").to_owned()),
            ("prefer".to_owned(), options.prefer.to_string()),
            ("growth".to_owned(), self.growth.clone()),
            ("max_columns".to_owned(), options.max_columns.to_string()),
            ("shuffles".to_owned(), options.shuffles.to_string()),
            ("seed".to_owned(), options.seed.to_string()),
            ("prime".to_owned(), SEARCH_FIELD.modulus().to_string()),
        ];
        provenance.extend(options.max_basis.map(|most| ("max_basis".to_owned(), most.to_string())));
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

/// What a search found.
#[derive(Clone, Debug)]
pub struct Found {
    /// At least one, all different, in the order of the preference.
    pub candidates: Vec<Candidate>,
    /// Ways to grow sets of shifts, those of other shares not counted.
    pub ways: usize,
    /// How many of them the monitor did not let begin.
    pub untried: usize,
    /// Templates that the monitor did not let plan.
    pub unplanned: usize,
    /// Whether the monitor ended the search: what was tried last may have been cut short.
    pub is_cut: bool,
}

/// Why a search found nothing.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SearchError {
    /// Random data over Z_p could not be drawn with the support of the problem.
    #[error("no random instance has the support of the problem: a coefficient vanishes for most data")]
    NoInstance,
    /// No set of shifts within the limits solves.
    #[error("no elimination template within {max_columns} columns{}: {}", ended(*.untried, *.is_over), Attempts(attempts))]
    NotFound {
        /// The limit.
        max_columns: usize,
        /// The ways to grow that were tried.
        attempts: Vec<Attempt>,
        /// How many others there are.
        untried: usize,
        /// Whether the monitor ended the search.
        is_over: bool,
    },
}

fn ended(untried: usize, is_over: bool) -> String {
    match is_over {
        true => format!(", and the search ended early, with {untried} ways to grow not tried"),
        false => String::new(),
    }
}

/// A way to grow sets of shifts.
struct Way<'a> {
    form: &'a Form,
    growth: Growth,
}

impl Way<'_> {
    fn describe(&self) -> String {
        let combined = if self.form.presolve.combines() { "equations combined, " } else { "" };
        let presolve = match self.form.presolve {
            Presolve::None => "",
            Presolve::Constant | Presolve::Combined => "after presolve with constant coefficients, ",
            Presolve::Linear | Presolve::CombinedLinear => "after presolve, ",
            Presolve::Square | Presolve::CombinedSquare => "after presolve and division by squares, ",
        };
        let symmetry = if self.form.symmetry.is_none() { "" } else { "up to sign, " };
        format!("{combined}{presolve}{symmetry}{}", self.growth)
    }
}

/// All ways to grow, what is quick and general first.
fn ways(forms: &[Form]) -> Vec<Way<'_>> {
    let of = |form| growths(form).into_iter().map(move |growth| Way { form, growth });
    let mut ways: Vec<Way<'_>> = forms.iter().flat_map(of).collect();
    ways.sort_by_key(|way| match &way.growth {
        Growth::Degree(weights) if weights.iter().all(|&weight| weight == 1) => 0,
        Growth::Degree(_) => 2,
        _ => 1,
    });
    ways
}

/// All templates of a share of the ways to grow; `algebra` is what [`crate::check::check`] tells of the problem.
pub fn candidates(
    problem: &Problem,
    algebra: &Algebra,
    options: &SearchOptions,
    monitor: &dyn Monitor,
) -> Result<Found, SearchError> {
    // The origin takes no row.
    let solutions = algebra.solutions - algebra.at_origin;
    let forms = forms(problem, options)?;
    let ways: Vec<(usize, Way<'_>)> =
        ways(&forms).into_iter().enumerate().filter(|(at, _)| options.share.holds(*at)).collect();
    monitor.say(&format!("{} solutions; growing shifts in {} ways", algebra.solutions, ways.len()));
    let is_over = || monitor.is_over(Stage::Searching);
    let memory = Memory::default();
    let explored =
        map(&ways, |(_, way)| explore(way.form, &way.growth, solutions, options, &memory, monitor), &is_over);
    let untried = explored.iter().filter(|explored| explored.is_none()).count();
    let mut work: Vec<(usize, &Way<'_>, &EliminationTemplate)> = Vec::new();
    for ((at, way), explored) in ways.iter().zip(&explored) {
        work.extend(explored.iter().flat_map(|explored| &explored.templates).map(|template| (*at, way, template)));
    }
    work.sort_by_key(|(_, _, template)| (template.rows(), template.basis.len()));
    monitor.say(&format!("planning {} templates", work.len()));
    let plan = |&(at, way, template): &(usize, &Way<'_>, &EliminationTemplate)| {
        candidate(problem, way, at, template, algebra.different)
    };
    let planned = map(&work, plan, &|| monitor.is_over(Stage::Measuring));
    let unplanned = planned.iter().filter(|planned| planned.is_none()).count();
    let candidates = in_order(planned.into_iter().flatten().flatten().collect(), options.prefer);
    if candidates.is_empty() {
        let attempt = |((_, way), explored): (&(usize, Way<'_>), Option<Explored>)| {
            let explored = explored?;
            let obstacle = explored.unsolved.map(|matrix| obstacle(way.form, &matrix, solutions));
            Some(Attempt::new(way.describe(), explored.tried, explored.largest, obstacle.as_ref(), &problem.unknowns))
        };
        let attempts = ways.iter().zip(explored).filter_map(attempt).collect();
        return Err(SearchError::NotFound { max_columns: options.max_columns, attempts, untried, is_over: is_over() });
    }
    monitor.say(&format!("{} different templates", candidates.len()));
    Ok(Found { candidates, ways: ways.len(), untried, unplanned, is_cut: is_over() })
}

/// Different candidates in the order of the preference. Ties are broken by content and by the way that they were found, so that the order depends
/// neither on how the search ran nor on how it was shared.
pub fn in_order(mut candidates: Vec<Candidate>, preference: Preference) -> Vec<Candidate> {
    candidates.sort_by_cached_key(|candidate| {
        let content = format!("{:?} {:?}", candidate.presolve, candidate.template);
        (preference.key(&Cost::of(candidate)), content, candidate.way)
    });
    candidates.dedup_by(|a, b| a.template == b.template && a.presolve == b.presolve);
    candidates
}

/// A solver that finds so many solutions; `None` if the template does not hold at the other prime, or no unknown can be read.
fn candidate(
    problem: &Problem,
    way: &Way<'_>,
    at: usize,
    template: &EliminationTemplate,
    solutions: usize,
) -> Option<Candidate> {
    let form = way.form;
    verify(template, form.check.field, &form.check.equations).ok()?;
    let plan = schedule(problem, &form.reduced, template, solutions, RootMethod::Eigenvalues);
    debug_assert!(!matches!(plan, Err(ScheduleError::Plan(_))), "{plan:?}");
    let (growth, template) = (way.growth.to_string(), template.clone());
    Some(Candidate { presolve: form.presolve, way: at, growth, template, plan: plan.ok()? })
}

/// Maps one item after the other until it is over, in parallel where the feature `search` is on. The first item is mapped in any case; what is not is
/// `None`. The order of the results is that of the items.
fn map<T: Sync, R: Send>(
    items: &[T],
    f: impl Fn(&T) -> R + Sync + Send,
    is_over: &(dyn Fn() -> bool + Sync),
) -> Vec<Option<R>> {
    let next = AtomicUsize::new(0);
    // Each thread takes the next item that is left, so that items begin in their order.
    let work = || -> Vec<(usize, R)> {
        let mut mine = Vec::new();
        loop {
            let at = next.fetch_add(1, Ordering::Relaxed);
            match items.get(at) {
                Some(item) if at == 0 || !is_over() => mine.push((at, f(item))),
                _ => return mine,
            }
        }
    };
    #[cfg(feature = "search")]
    let done: Vec<(usize, R)> = {
        use rayon::prelude::*;
        (0..rayon::current_num_threads()).into_par_iter().flat_map_iter(|_| work()).collect()
    };
    #[cfg(not(feature = "search"))]
    let done = work();
    let mut results: Vec<Option<R>> = items.iter().map(|_| None).collect();
    done.into_iter().for_each(|(at, result)| results[at] = Some(result));
    results
}
