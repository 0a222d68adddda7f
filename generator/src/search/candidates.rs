//! All templates that the strategies lead to, planned and in order.

use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;

use super::cache::Cache;
use super::candidate::TemplateCandidate;
use super::error::SearchError;
use super::failed_strategy::FailedStrategy;
use super::formulation::formulations;
use super::monitor::{Monitor, Stage, is_set};
use super::options::SearchOptions;
use super::preference::Preference;
use super::reduce_strategy::{StrategyContext, StrategyTemplates, reduce_strategy};
use super::seed_sets::obstacle;
use super::strategy::{Strategy, strategies, traced_strategies};
use crate::check::SolutionCount;
use crate::generate::{determinant_chains, gives_its_solutions};
use crate::plan::schedule::{ScheduleError, schedule};
use crate::problem::Problem;
use crate::template::EliminationTemplate;
use crate::template::verify::verify;

/// What a search found.
#[derive(Clone, Debug)]
pub struct Found {
    /// The candidates in the order of the preference. There is at least one, and all are different.
    pub candidates: Vec<TemplateCandidate>,
    /// Number of strategies, those of other shards not counted.
    pub strategies: usize,
    /// How many of them the monitor did not let begin.
    pub untried: usize,
    /// Number of templates that the monitor did not let plan.
    pub unplanned: usize,
    /// Whether the monitor ended the search. The last strategies that began may then have been cut
    /// short.
    pub is_cut: bool,
}

/// A strategy with its position among all strategies of all shards.
struct Numbered<'a> {
    at: usize,
    strategy: Strategy<'a>,
}

/// All templates of a shard of the strategies. `count` is what [`crate::check::check`] tells of the
/// problem.
pub fn candidates(
    problem: &Problem,
    count: &SolutionCount,
    options: &SearchOptions,
    monitor: &dyn Monitor,
) -> Result<Found, SearchError> {
    let least = count.least_columns_until(problem, monitor.interruption());
    let Some(least) = least else { return Err(SearchError::interrupted(options)) };
    if least > options.max_columns {
        return Err(SearchError::TooFewColumns { max_columns: options.max_columns, least });
    }
    let formulations = formulations(problem, count, options, monitor)?;
    let all = strategies(&formulations).into_iter().enumerate();
    let strategies: Vec<Numbered<'_>> =
        all.filter(|(at, _)| options.shard.holds(*at)).map(|(at, strategy)| Numbered { at, strategy }).collect();
    let (solutions, ways) = (count.solutions, strategies.len());
    let message = format!("{solutions} solutions, at least {least} columns; growing shifts by {ways} strategies");
    monitor.begin(&message, ways);
    candidates_of(problem, count, &strategies, options, monitor)
}

/// Number of formulations whose trace is taken even if the search is over.
const TRACED_IN_ANY_CASE: usize = 2;

/// The templates by the trace of a Gröbner basis, for a problem for which [`candidates`] finds
/// none. `max_columns` and `shard` of the options do not matter.
///
/// A template exists if the equations have finitely many solutions even where factors that must not
/// vanish do. The formulations are tried one after another until one gives candidates. If the
/// monitor says that the search is over it cuts short how templates are reduced, and no more than
/// `TRACED_IN_ANY_CASE` formulations are tried. If it interrupts the search, none is.
pub fn traced_candidates(
    problem: &Problem,
    count: &SolutionCount,
    options: &SearchOptions,
    monitor: &dyn Monitor,
) -> Result<Found, SearchError> {
    let formulations = formulations(problem, count, options, monitor)?;
    let mut failed = Vec::new();
    for (at, strategy) in traced_strategies(&formulations).into_iter().enumerate() {
        if is_set(monitor.interruption()) || (at >= TRACED_IN_ANY_CASE && monitor.is_over(Stage::Searching)) {
            break;
        }
        monitor.say(&format!("{} solutions; the trace of a Gröbner basis", count.solutions));
        match candidates_of(problem, count, &[Numbered { at, strategy }], options, monitor) {
            Err(SearchError::NotFound { failed: more, .. }) => failed.extend(more),
            other => return other,
        }
    }
    let is_over = monitor.is_over(Stage::Searching);
    Err(SearchError::NotFound { max_columns: options.max_columns, failed, untried: 0, is_over })
}

/// All templates of some strategies.
fn candidates_of(
    problem: &Problem,
    count: &SolutionCount,
    strategies: &[Numbered<'_>],
    options: &SearchOptions,
    monitor: &dyn Monitor,
) -> Result<Found, SearchError> {
    let is_over = || monitor.is_over(Stage::Searching);
    let context = StrategyContext { options, cache: &Cache::default(), monitor };
    let reduce = |numbered: &Numbered<'_>| {
        let reduced = reduce_strategy(&numbered.strategy, &context);
        monitor.step();
        reduced
    };
    let reduced = map(strategies, reduce, &is_over);
    let untried = reduced.iter().filter(|reduced| reduced.is_none()).count();
    let mut work: Vec<(&Numbered<'_>, &EliminationTemplate)> = Vec::new();
    for (numbered, reduced) in strategies.iter().zip(&reduced) {
        work.extend(reduced.iter().flat_map(|reduced| &reduced.templates).map(|template| (numbered, template)));
    }
    // If planning ends early, only large templates are left out.
    work.sort_by_key(|(_, template)| (template.rows(), template.basis.len()));
    monitor.begin(&format!("planning {} templates", work.len()), work.len());
    let plan = |&(numbered, template): &(&Numbered<'_>, &EliminationTemplate)| {
        // What began before is given up between its steps.
        let planned = candidate(problem, numbered, template, count.different, &|| !is_set(monitor.interruption()));
        monitor.step();
        planned
    };
    let planned = map(&work, plan, &|| monitor.is_over(Stage::Planning));
    let unplanned = planned.iter().filter(|planned| planned.is_none()).count();
    let candidates = in_order(planned.into_iter().flatten().flatten().collect(), options.prefer);
    if candidates.is_empty() {
        let failed = failed_strategies(strategies, reduced, &problem.unknowns, monitor);
        return Err(SearchError::NotFound { max_columns: options.max_columns, failed, untried, is_over: is_over() });
    }
    monitor.say(&format!("{} different templates", candidates.len()));
    Ok(Found { candidates, strategies: strategies.len(), untried, unplanned, is_cut: is_over() })
}

/// Different candidates in the order of the preference.
///
/// Ties are broken by content, and then by the strategy that found the template. The order
/// therefore depends neither on how the search ran nor on how it was sharded.
pub fn in_order(mut candidates: Vec<TemplateCandidate>, preference: Preference) -> Vec<TemplateCandidate> {
    candidates.sort_by_cached_key(|candidate| {
        let content = format!("{:?} {:?}", candidate.presolve, candidate.template);
        (preference.key(&candidate.cost()), content, candidate.strategy)
    });
    candidates.dedup_by(|a, b| a.template == b.template && a.presolve == b.presolve);
    candidates
}

/// A template with its plan, for a solver that finds this number of solutions. `None` if the
/// template does not hold at the other prime, an unknown cannot be read, or a solution is lost, or
/// if it must not go on.
fn candidate(
    problem: &Problem,
    numbered: &Numbered<'_>,
    template: &EliminationTemplate,
    solutions: usize,
    goes_on: &dyn Fn() -> bool,
) -> Option<TemplateCandidate> {
    let step = || goes_on().then_some(());
    let Numbered { at, strategy } = numbered;
    let formulation = strategy.formulation;
    step()?;
    verify(template, formulation.check.field, &formulation.check.equations).ok()?;
    step()?;
    let zero_sets = formulation.zero_sets.clone();
    let plan = schedule(problem, &formulation.reduced, template, (solutions, &zero_sets));
    debug_assert!(!matches!(plan, Err(ScheduleError::Plan(_))), "{plan:?}");
    step()?;
    let mut plan = plan.ok().filter(|plan| gives_its_solutions(plan, &template.action, &formulation.reduced))?;
    step()?;
    plan.chains = determinant_chains(&plan, &formulation.reduced);
    let (growth, template) = (strategy.growth.to_string(), template.clone());
    Some(TemplateCandidate { presolve: formulation.presolve, strategy: *at, growth, template, plan, zero_sets })
}

/// The strategies that began, none of which found a template. If the search is interrupted nothing
/// is said of those that are left.
fn failed_strategies(
    strategies: &[Numbered<'_>],
    reduced: Vec<Option<StrategyTemplates>>,
    unknowns: &[String],
    monitor: &dyn Monitor,
) -> Vec<FailedStrategy> {
    let failed = |(numbered, reduced): (&Numbered<'_>, Option<StrategyTemplates>)| {
        let StrategyTemplates { tried, largest, unsolved, is_too_large, .. } = reduced?;
        let strategy = &numbered.strategy;
        if is_set(monitor.interruption()) {
            return None;
        }
        if is_too_large {
            return Some(FailedStrategy::too_large(strategy.describe(), tried, largest));
        }
        let obstacle = match unsolved {
            Some(matrix) => Some(obstacle(strategy.formulation, &matrix, monitor)?),
            None => None,
        };
        Some(FailedStrategy::new(strategy.describe(), tried, largest, obstacle.as_ref(), unknowns))
    };
    strategies.iter().zip(reduced).filter_map(failed).collect()
}

/// Maps items in parallel until it is over. Items begin in their order, and the first one begins in
/// any case. Results are in the order of the items; an item that did not begin has none.
fn map<T: Sync, R: Send>(
    items: &[T],
    f: impl Fn(&T) -> R + Sync + Send,
    is_over: &(dyn Fn() -> bool + Sync),
) -> Vec<Option<R>> {
    let next = AtomicUsize::new(0);
    // Each thread takes the next item that is left. Rayon's own parallel map would begin in the
    // middle of the list, and an early end would then skip items of all kinds.
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
