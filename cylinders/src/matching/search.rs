//! The search: pairs of silhouettes to circles, those that are the least likely by chance first.

use nalgebra::{Unit, Vector3};
#[cfg(feature = "parallel")]
use rayon::prelude::*;

use super::chance::Chance;
use super::edges::without_edges;
use super::error::MatchError;
use super::found::Matching;
use super::judge::Judge;
use super::model::Model;
use super::options::MatchOptions;
use super::pair::{Hypothesis, Pair, Workspace, pairs};
use super::plan::Plan;
use super::selection::lines;
use crate::numerics::interrupt::Interrupt;
use crate::observations::view::View;

/// Least number of matches: four circles touch three lines, and a fourth line decides.
const LEAST_SUPPORT: usize = 4;

/// Parts of the threshold at which hypotheses are compared, the widest first.
const LEVELS: [f64; 5] = [1.0, 0.5, 0.25, 0.125, 0.0625];

/// Hypotheses are compared at so many of these levels, the widest at which lines are sparse.
const SPARSE_LEVELS: usize = 2;

/// Largest expected number of circles by chance that a scene is allowed: false cylinders are then
/// rarer than those that are missed. More draw a warning where the number of cylinders is given.
pub(crate) const MOST_FALSE_ALARMS: f64 = 0.3;

/// The search is repeated with less required support if there are at most so many pairs.
const REPEATED_PAIRS: usize = 20_000;

/// Largest number of hypotheses of a level that are fitted, those with the most matches.
const CANDIDATES: usize = 1000;

/// The step by which the required support is lowered if too few models were found. It also lowers
/// the support that chance gives if no silhouette is hidden.
const SUPPORT_STEP: usize = 2;

/// Progress of a search.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Progress {
    /// The number of pairs of lines that are searched next. The search repeats them whenever it
    /// lowers the required support.
    Pairs(usize),
    /// A pair has been searched.
    Pair,
    /// A cylinder has been found.
    Cylinder,
}

/// Finds all cylinders of a direction among lines without labels, and the lines that are their
/// silhouettes.
///
/// Lines that are not along the direction and lines of edges that are fixed in space are ignored.
/// The cylinder that is the least likely by chance is taken first, and its lines match no other
/// cylinder.
///
/// # Errors
/// [`MatchError`].
pub fn match_cylinders(
    views: &[View],
    direction: &Unit<Vector3<f64>>,
    options: &MatchOptions,
) -> Result<Matching, MatchError> {
    match_cylinders_with(views, direction, options, &|_| {})
}

/// Like [`match_cylinders`], and reports its progress from all its threads.
///
/// # Errors
/// [`MatchError`].
pub fn match_cylinders_with(
    views: &[View],
    direction: &Unit<Vector3<f64>>,
    options: &MatchOptions,
    progress: &(dyn Fn(Progress) + Sync),
) -> Result<Matching, MatchError> {
    if let Some(least_support) = options.least_support.filter(|&least| least < LEAST_SUPPORT) {
        return Err(MatchError::LeastSupport { least_support });
    }
    let (left, edges) = without_edges(views, direction, options)?;
    let count = lines(views).len();
    let matching = match_lines(&left.views, direction, options, progress).map_err(|error| match error {
        MatchError::TooFewViews { .. } | MatchError::NoPair if edges > 0 => MatchError::Edges { edges, lines: count },
        MatchError::NoCylinder { least_support, .. } => MatchError::NoCylinder { least_support, lines: count },
        error => error,
    })?;
    Ok(left.matching_in_all(views, matching))
}

/// The cylinders among lines that are not of edges.
fn match_lines(
    views: &[View],
    direction: &Unit<Vector3<f64>>,
    options: &MatchOptions,
    progress: &(dyn Fn(Progress) + Sync),
) -> Result<Matching, MatchError> {
    let plan = Plan::new(views, direction, options)?;
    let pairs = pairs(&plan, options.references);
    if !pairs.iter().any(Pair::is_of_one_view) {
        return Err(MatchError::NoPair);
    }
    let mut plans: Vec<_> = LEVELS.map(|part| plan.narrowed(part)).into();
    let (found, least_support) = search(&mut plans, &pairs, options, progress);
    options.interrupt.check()?;

    let lines = lines(views).len();
    if found.is_empty() {
        return Err(MatchError::NoCylinder { least_support, lines });
    }
    // The lines of no cylinder are those of all views, edges included.
    let cylinder = |model: &Model| model.in_space(views, &plan, direction, lines);
    let cylinders = found.iter().map(cylinder).collect();
    Ok(Matching { directions: vec![*direction], cylinders, unmatched: Vec::new(), least_support })
}

/// Searches for models with less and less support. Returns them with the least support that was
/// required at the end. Less required support takes longer. The more models are taken, the fewer
/// matches chance gives.
fn search(
    plans: &mut [Plan],
    pairs: &[Pair],
    options: &MatchOptions,
    progress: &(dyn Fn(Progress) + Sync),
) -> (Vec<Model>, usize) {
    let count = options.count.unwrap_or(usize::MAX);
    // If the number of cylinders or of matches is given, chance does not stop the search.
    let floor = options.least_support.or(options.count.map(|_| LEAST_SUPPORT));
    let false_alarms = if floor.is_some() { f64::INFINITY } else { MOST_FALSE_ALARMS.ln() };
    let mut found: Vec<Model> = Vec::new();
    let mut least: Vec<usize> = vec![usize::MAX; plans.len()];
    let mut chance = Chance::of(&plans[0], pairs);
    while found.len() < count {
        chance = chance.updated(&plans[0], pairs);
        let (mut next, mut lowered) = (least.clone(), false);
        let of_levels = LEVELS.iter().enumerate();
        let sparse = of_levels.filter_map(|(level, &part)| Some((level, chance.least_support(part)?)));
        for (level, of_chance) in sparse.take(SPARSE_LEVELS) {
            let next = &mut next[level];
            let lower = match floor {
                Some(floor) => of_chance.min(next.saturating_sub(SUPPORT_STEP)).max(floor),
                None => of_chance.saturating_sub(SUPPORT_STEP).max(LEAST_SUPPORT),
            };
            lowered |= lower < *next;
            *next = lower.min(*next);
        }
        if !lowered {
            break;
        }
        least = next;
        let least_matches = options.least_support.unwrap_or(LEAST_SUPPORT);
        let demand =
            Demand { least: &least, least_matches, false_alarms, count, chance: &chance, interrupt: options.interrupt };
        extract(plans, pairs, &demand, progress, &mut found);
        if options.interrupt.is_set() || floor.is_none() && pairs.len() > REPEATED_PAIRS {
            break;
        }
    }
    // If lines are sparse at no level, more matches than there are silhouettes would be needed.
    let all = 2 * plans[0].views().len() + 1;
    (found, least.into_iter().filter(|&least| least < usize::MAX).min().unwrap_or(floor.unwrap_or(all)))
}

/// What the search requires of models.
#[derive(Clone, Copy, Debug)]
struct Demand<'a> {
    /// Least number of matches of a hypothesis at each level.
    least: &'a [usize],
    /// Least number of matches of a model.
    least_matches: usize,
    /// Natural logarithm of the largest number of false alarms.
    false_alarms: f64,
    /// Number of models at which the search ends.
    count: usize,
    /// What chance gives before models are taken.
    chance: &'a Chance,
    /// What ends it before.
    interrupt: Interrupt<'a>,
}

/// The model of the best hypothesis of a pair at a level.
struct Candidate {
    pair: usize,
    level: usize,
    model: Model,
}

/// Takes the models that are the least likely by chance one after the other. When the lines of a
/// model are taken away, the pairs of the models that had them are searched again.
fn extract(
    plans: &mut [Plan],
    pairs: &[Pair],
    demand: &Demand,
    progress: &(dyn Fn(Progress) + Sync),
    found: &mut Vec<Model>,
) {
    let mut judge = Judge::new(&plans[0], pairs, found, demand.chance);
    let mut candidates = Vec::new();
    for (level, &least) in demand.least.iter().enumerate().filter(|(_, least)| **least < usize::MAX) {
        progress(Progress::Pairs(pairs.len()));
        let plans = &*plans;
        let mut of_level = with_workspaces(pairs.len(), demand.interrupt, |workspace, pair| {
            let best = pairs[pair].best(&plans[level], least, workspace);
            progress(Progress::Pair);
            best.map(|best| (best, pair))
        });
        of_level.sort_by(|one, other| other.0.support.cmp(&one.0.support));
        of_level.truncate(CANDIDATES);
        candidates.extend(with_workspaces(of_level.len(), demand.interrupt, |_, index| {
            let (Hypothesis { circle, .. }, pair) = of_level[index];
            Some(Candidate { pair, level, model: judge.fitted(plans, level, &circle)? })
        }));
    }
    while found.len() < demand.count {
        candidates.retain(|candidate| candidate.model.matches.len() >= demand.least_matches);
        let least = |one: &&Candidate, other: &&Candidate| one.model.false_alarms.total_cmp(&other.model.false_alarms);
        let Some(best) = candidates.iter().min_by(least) else { break };
        if best.model.false_alarms > demand.false_alarms {
            break;
        }
        let model = best.model.clone();
        plans.iter_mut().for_each(|plan| plan.take(model.matches.iter().map(|line| line.line)));
        found.push(model);
        progress(Progress::Cylinder);
        let plans = &*plans;
        judge = judge.updated(&plans[0], pairs, found);
        candidates = with_workspaces(candidates.len(), demand.interrupt, |workspace, index| {
            let Candidate { pair, level, ref model } = candidates[index];
            let is_free =
                model.matches.iter().all(|line| plans[0].is_free(line.line)) && pairs[pair].is_free(&plans[0]);
            let model = if is_free {
                judge.judged(&plans[0], &model.fit)?
            } else {
                let best = pairs[pair].best(&plans[level], demand.least[level], workspace)?;
                judge.fitted(plans, level, &best.circle)?
            };
            Some(Candidate { pair, level, model })
        });
    }
}

/// What a function finds for each index below `count`, in order; nothing after an interruption.
fn with_workspaces<T: Send>(
    count: usize,
    interrupt: Interrupt<'_>,
    of_index: impl Fn(&mut Workspace, usize) -> Option<T> + Sync + Send,
) -> Vec<T> {
    let of_index = |workspace: &mut Workspace, index| {
        if interrupt.is_set() { None } else { of_index(workspace, index) }
    };
    #[cfg(feature = "parallel")]
    let found: Vec<_> = (0..count).into_par_iter().map_init(Workspace::default, of_index).collect();
    #[cfg(not(feature = "parallel"))]
    let found: Vec<_> = {
        let mut workspace = Workspace::default();
        (0..count).map(|index| of_index(&mut workspace, index)).collect()
    };
    found.into_iter().flatten().collect()
}
