//! All templates that the ways to grow lead to, planned and in order.

use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;

use super::attempt::Attempt;
use super::candidate::Candidate;
use super::error::SearchError;
use super::explore::{Explored, Memory, explore};
use super::grow::Growth;
use super::monitor::{Monitor, Stage};
use super::options::SearchOptions;
use super::preference::Preference;
use super::starts::{Form, forms, growths, obstacle};
use crate::check::SolutionCount;
use crate::plan::schedule::{ScheduleError, schedule};
use crate::presolve::Presolve;
use crate::problem::Problem;
use crate::template::verify::verify;
use crate::template::{EliminationTemplate, RootMethod};

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
    algebra: &SolutionCount,
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
        (preference.key(&candidate.cost()), content, candidate.way)
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

/// Maps one item after the other in parallel until it is over. The first item is mapped in any case; what is not is
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
    let threads = (0..rayon::current_num_threads()).into_par_iter();
    let done: Vec<(usize, R)> = threads.flat_map_iter(|_| work()).collect();
    let mut results: Vec<Option<R>> = items.iter().map(|_| None).collect();
    done.into_iter().for_each(|(at, result)| results[at] = Some(result));
    results
}
