//! The search: pairs of silhouettes to circles, the best supported first.

use std::collections::BinaryHeap;

use nalgebra::{Unit, Vector3};
#[cfg(feature = "parallel")]
use rayon::prelude::*;

use super::chance::{Chance, FALSE_ALARMS};
use super::error::MatchError;
use super::found::Matching;
use super::model::{Model, fitted};
use super::occlusion::hidden;
use super::options::MatchOptions;
use super::pair::{Hypothesis, Pair, Workspace, pairs};
use super::plan::Plan;
use crate::cross_section::circle::Circle;
use crate::observations::scene::LineId;
use crate::observations::view::View;

/// Least number of matches: four circles touch three lines, and a fourth line decides.
const LEAST_SUPPORT: usize = 4;

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
/// Lines that are not along the direction are ignored. The best supported cylinder is taken first
/// (most matches, then the least sum of their squared angles), and its lines match no other
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
    let mut plan = Plan::new(views, direction, options)?;
    let pairs = pairs(&plan, options.references);
    if pairs.is_empty() {
        return Err(MatchError::NoPair);
    }
    let (found, least_support) = search(&mut plan, &pairs, options, progress);

    let lines = views.iter().map(|view| view.lines().len()).sum();
    if found.is_empty() {
        return Err(MatchError::NoCylinder { least_support, lines });
    }
    let mut unmatched: Vec<_> = views.iter().map(|view| vec![true; view.lines().len()]).collect();
    for line in found.iter().flat_map(|model| &model.matches) {
        let LineId { view, line } = plan.id(line.line);
        unmatched[view][line] = false;
    }
    let cylinder = |model: &Model| model.in_space(views, &plan, direction, lines);
    let ids = unmatched.iter().enumerate().flat_map(|(view, lines)| {
        lines.iter().enumerate().filter(|(_, unmatched)| **unmatched).map(move |(line, _)| LineId { view, line })
    });
    let cylinders = found.iter().map(cylinder).collect();
    Ok(Matching { directions: vec![*direction], cylinders, unmatched: ids.collect(), least_support })
}

/// Searches for models with less and less support. Returns them with the least support that was
/// required at the end. Less required support takes longer. The more models are taken, the fewer
/// matches chance gives.
fn search(
    plan: &mut Plan,
    pairs: &[Pair],
    options: &MatchOptions,
    progress: &(dyn Fn(Progress) + Sync),
) -> (Vec<Model>, usize) {
    let count = options.count.unwrap_or(usize::MAX);
    // If the number of cylinders or of matches is given, chance does not stop the search.
    let floor = options.least_support.or(options.count.map(|_| LEAST_SUPPORT));
    let least_matches = options.least_support.unwrap_or(LEAST_SUPPORT);
    let false_alarms = if floor.is_some() { f64::INFINITY } else { FALSE_ALARMS };
    let mut found: Vec<Model> = Vec::new();
    let mut least = usize::MAX;
    while found.len() < count {
        let chance = Chance::of(plan, pairs).least_support();
        let next = match floor {
            Some(floor) => chance.min(least - SUPPORT_STEP).max(floor),
            None => (chance - SUPPORT_STEP).max(LEAST_SUPPORT),
        };
        if next >= least {
            break;
        }
        least = next;
        let demand = Demand { least_support: least, least_matches, false_alarms, count };
        extract(plan, pairs, &demand, progress, &mut found);
    }
    (found, least)
}

/// What the search requires of models.
#[derive(Clone, Copy, Debug)]
struct Demand {
    least_support: usize,
    /// Least number of lines that are near the silhouettes in the image, too.
    least_matches: usize,
    /// Largest number of false alarms.
    false_alarms: f64,
    /// Number of models at which the search ends.
    count: usize,
}

/// Takes the best supported models one after the other. When lines are taken away, the best
/// hypothesis of a pair can only lose support, so its previous support is a bound. A pair is
/// searched again only when its bound is the largest.
fn extract(
    plan: &mut Plan,
    pairs: &[Pair],
    demand: &Demand,
    progress: &(dyn Fn(Progress) + Sync),
    found: &mut Vec<Model>,
) {
    progress(Progress::Pairs(pairs.len()));
    let search = |workspace: &mut Workspace, (index, pair): (usize, &Pair)| {
        let best = pair.best(plan, demand.least_support, workspace);
        progress(Progress::Pair);
        best.map(|best| (best, index))
    };
    #[cfg(feature = "parallel")]
    let best: Vec<_> = pairs.par_iter().enumerate().map_init(Workspace::default, search).collect();
    #[cfg(not(feature = "parallel"))]
    let best: Vec<_> = {
        let mut workspace = Workspace::default();
        pairs.iter().enumerate().map(|pair| search(&mut workspace, pair)).collect()
    };

    let mut round = found.len();
    let mut chance = Chance::of(plan, pairs);
    let mut queue: BinaryHeap<_> =
        best.into_iter().flatten().map(|(best, pair)| Candidate { best, pair, round }).collect();
    // Candidates that might be chance. They are tried again when another model is found: then there
    // are fewer lines, and some of their silhouettes may be hidden.
    let mut doubtful = Vec::new();
    let mut workspace = Workspace::default();
    while found.len() < demand.count {
        let Some(candidate) = queue.pop() else { break };
        if candidate.round < round {
            let again = pairs[candidate.pair].best(plan, demand.least_support, &mut workspace);
            queue.extend(again.map(|best| Candidate { best, round, ..candidate }));
            continue;
        }
        let enough = |model: &Model| model.matches.len() >= demand.least_matches;
        let Some(model) = fitted(plan, candidate.best.circle).filter(enough) else { continue };
        let false_alarms = false_alarms(plan, &chance, &model.fit.circle, found);
        if false_alarms > demand.false_alarms {
            doubtful.push(candidate);
            continue;
        }
        plan.take(model.matches.iter().map(|line| line.line));
        found.push(Model { false_alarms, ..model });
        progress(Progress::Cylinder);
        (round, chance) = (found.len(), Chance::of(plan, pairs));
        queue.extend(doubtful.drain(..));
    }
}

/// Expected number of circles like this one by chance. It is counted on all silhouettes and on
/// those that the models found do not hide, because cylinders of finite length do not hide
/// everything behind them. The smaller number counts, doubled for the choice between the two.
fn false_alarms(plan: &Plan, chance: &Chance, circle: &Circle, found: &[Model]) -> f64 {
    let circles: Vec<_> = found.iter().map(|model| model.fit.circle).collect();
    let (mut all, mut visible) = ((Vec::new(), 0), (Vec::new(), 0));
    for view in plan.views().iter().filter(|view| !view.lines.is_empty()) {
        let Some((silhouettes, hidden)) =
            plan.matched_silhouettes(view, circle).zip(hidden(&view.centre, circle, &circles))
        else {
            continue;
        };
        for (silhouette, hidden) in silhouettes.into_iter().zip(hidden) {
            let distance = silhouette.map(|(_, cost)| cost.sqrt());
            for (distances, count) in [Some(&mut all), Some(&mut visible).filter(|_| !hidden)].into_iter().flatten() {
                distances.extend(distance);
                *count += 1;
            }
        }
    }
    2.0 * [all, visible]
        .map(|(distances, count)| chance.false_alarms(distances, count))
        .into_iter()
        .fold(f64::INFINITY, f64::min)
}

/// The best hypothesis of a pair, and the number of models that had been taken when it was found.
#[derive(Clone, Copy, Debug)]
struct Candidate {
    best: Hypothesis,
    pair: usize,
    round: usize,
}

impl Ord for Candidate {
    /// Compares by support. If the support is equal, the earlier pair is the greater.
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.best.support.cmp(&other.best.support).then(other.pair.cmp(&self.pair))
    }
}

impl PartialOrd for Candidate {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Candidate {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Candidate {}
