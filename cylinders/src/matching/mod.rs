//! Matching without correspondences: lines of several images, of which nobody says what they show, to all cylinders of one
//! direction and their silhouettes (Gummeson & Oskarsson, "Robust and Accurate Cylinder Triangulation", the experiment on
//! unknown matches).
//!
//! ```text
//!   left and right silhouette in one image + one line of another image
//!     --> circle in front of the cameras --> support: lines of all images near its silhouettes --> best one
//!     --> least squares on its matches   --> cylinder; its lines are taken away, and again
//! ```
//!
//! The search is exhaustive and draws no random numbers. One model is scored in time linear in the number of lines `N`; all
//! models of one pair are bounded together in `O(N log N)` (`pair`), so that few of them need to be scored at all.

/// Support by chance, and the support that is more than that.
mod chance;
/// Which silhouettes of a circle others hide.
mod occlusion;
/// Pairs of silhouettes of one image: all circles that they and another line leave, and the best of them.
mod pair;
/// Cameras and lines in the cross-section; the lines near the silhouettes of a circle.
mod plan;

use std::collections::BinaryHeap;

use nalgebra::{Unit, Vector3};
#[cfg(feature = "parallel")]
use rayon::prelude::*;
use thiserror::Error;

use super::circle::{Circle, CircleFit, fit_circle};
use super::cylinder::{Cylinder, LineResidual};
use super::scene::LineId;
use super::silhouette_distance::DistanceUnit;
use super::view::View;
use chance::{Chance, FALSE_ALARMS};
use occlusion::hidden;
use pair::{Hypothesis, Pair, pairs};
use plan::{Plan, PlanMatch};

/// Default of the largest distance between a line and its silhouette: what an end point that is off by a pixel may reach.
const THRESHOLD_PIXELS: f64 = 3.0;

/// Default in radians: three pixels at a focal length of 3000.
const THRESHOLD_RADIANS: f64 = 1e-3;

/// Three lines leave four circles; the fourth decides.
const LEAST_SUPPORT: usize = 4;

/// By how much less support is asked for where too few models were found, and than chance gives on silhouettes none of which is
/// hidden.
const SUPPORT_STEP: usize = 2;

/// Limit on the repetitions of fit and choice of matches; they agree after two or three.
const REPETITIONS: usize = 10;

/// In which images pairs of silhouettes are taken.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum References {
    /// In the first image with two lines or more, as in the paper. A cylinder is found only if both its silhouettes were seen
    /// there.
    First,
    /// In every image: both silhouettes of a cylinder need to be seen in one of them, whichever it is.
    Every,
}

/// How cylinders are searched for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MatchOptions {
    /// Largest distance between a line and its silhouette in the cross-section: an angle at the camera centre, in radians or as
    /// the pixels that it covers in the middle of the image.
    pub threshold: f64,
    /// Unit of the threshold.
    pub unit: DistanceUnit,
    /// In which images pairs of silhouettes are taken.
    pub references: References,
    /// Largest number of cylinders; `None` for all that have the support.
    pub count: Option<usize>,
    /// Least number of matches of a cylinder, four or more. `None` for four where the number of cylinders is given, otherwise for
    /// what the lines left over would not reach by chance if they were in no order.
    pub least_support: Option<usize>,
}

/// A cylinder and its silhouettes among the lines.
#[derive(Clone, Debug, PartialEq)]
pub struct MatchedCylinder {
    /// Least squares cylinder of its matches.
    pub cylinder: Cylinder,
    /// Root mean square distance between matches and circle in the cross-section, world units.
    pub rms: f64,
    /// Its silhouettes, in the order of views and lines, at most one for each side in a view.
    pub matches: Vec<LineResidual>,
    /// Part of all lines that are not its silhouettes.
    pub outlier_rate: f64,
    /// Expected number of cylinders with matches as many and as near, if the lines that were left when it was found were in no order.
    pub false_alarms: f64,
}

/// All cylinders that were found.
#[derive(Clone, Debug, PartialEq)]
pub struct Matching {
    /// The cylinders, the best supported first.
    pub cylinders: Vec<MatchedCylinder>,
    /// Lines of no cylinder, in the order of views and lines.
    pub unmatched: Vec<LineId>,
    /// Least number of matches that was asked of a cylinder, at the end.
    pub least_support: usize,
}

/// Why nothing can be matched.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum MatchError {
    /// The threshold is not a positive number, or is no angle.
    #[error(
        "the threshold must be positive and less than a tenth of a radian (found {threshold} radians in views[{view}])"
    )]
    Threshold {
        /// Index of the view.
        view: usize,
        /// The threshold as an angle, radians.
        threshold: f64,
    },
    /// A threshold in pixels without a calibration.
    #[error("views[{view}]: a threshold in pixels needs the calibration of every camera; pass it, or one in radians")]
    NoCalibration {
        /// Index of the view.
        view: usize,
    },
    /// The least support asked for does not determine a circle.
    #[error("three lines leave four circles: the least number of matches must be four or more (found {least_support})")]
    LeastSupport {
        /// The value.
        least_support: usize,
    },
    /// Fewer than two views have lines along the axis.
    #[error("{views} view(s) have lines along the axis direction; matching needs at least two")]
    TooFewViews {
        /// Number of views with such lines.
        views: usize,
    },
    /// No image has two lines along the axis.
    #[error("no view has two lines along the axis direction: there is no pair of silhouettes to start from")]
    NoPair,
    /// Seen along the axis, all camera centres coincide: every size of cylinder fits.
    #[error(
        "all cameras stand at one place, or above each other along the axis: the distance to the cylinders is unknown"
    )]
    SingleViewpoint,
    /// No model has the support.
    #[error(
        "no cylinder has {least_support} of the {lines} lines near its silhouettes, and more than chance would give; pass more \
         views, a better calibration or direction, or another threshold"
    )]
    NoCylinder {
        /// Least number of matches that was asked of a cylinder.
        least_support: usize,
        /// Number of lines.
        lines: usize,
    },
}

impl MatchOptions {
    /// Pairs of every image and all cylinders. A threshold of 3 pixels where all cameras have a calibration, of 0.001 radians
    /// otherwise.
    pub fn of(views: &[View]) -> Self {
        let calibrated = views.iter().all(|view| view.camera().calibration().is_some());
        let (unit, threshold) = match calibrated {
            true => (DistanceUnit::Pixels, THRESHOLD_PIXELS),
            false => (DistanceUnit::Radians, THRESHOLD_RADIANS),
        };
        Self { threshold, unit, references: References::Every, count: None, least_support: None }
    }
}

/// How far a search has come.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Progress {
    /// So many pairs of lines are about to be searched, as again whenever less support is asked for.
    Pairs(usize),
    /// A pair has been searched.
    Pair,
    /// A cylinder has been found.
    Cylinder,
}

/// Finds all cylinders of a direction among lines without labels, and the lines that are their silhouettes.
///
/// Lines that are not along the direction are left aside. The one that is best supported is taken first (most matches, then the
/// least sum of their squared angles); its lines are matches of no other.
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

/// [`match_cylinders`] that says how far it has come, from all its threads.
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
    Ok(Matching { cylinders: found.iter().map(cylinder).collect(), unmatched: ids.collect(), least_support })
}

/// A circle of the cross-section with its matches.
struct Model {
    fit: CircleFit,
    matches: Vec<PlanMatch>,
    false_alarms: f64,
}

impl Model {
    fn in_space(&self, views: &[View], plan: &Plan, direction: &Unit<Vector3<f64>>, lines: usize) -> MatchedCylinder {
        let cylinder = Cylinder::from_circle(&self.fit.circle, plan.rectification(), *direction);
        let residual = |found: &PlanMatch| {
            let LineId { view, line } = plan.id(found.line);
            // No camera of a match is inside.
            let residuals = cylinder.residuals(view, &views[view])?;
            Some(LineResidual { side: found.side, ..residuals[line] })
        };
        MatchedCylinder {
            cylinder,
            rms: self.fit.rms,
            matches: self.matches.iter().filter_map(residual).collect(),
            outlier_rate: 1.0 - self.matches.len() as f64 / lines as f64,
            false_alarms: self.false_alarms,
        }
    }
}

/// Searches for models with ever less support, and returns them with the least support that was asked for at the end: the less
/// is asked, the longer it takes, and the more models are taken, the less is reached by chance.
fn search(
    plan: &mut Plan,
    pairs: &[Pair],
    options: &MatchOptions,
    progress: &(dyn Fn(Progress) + Sync),
) -> (Vec<Model>, usize) {
    let count = options.count.unwrap_or(usize::MAX);
    // Where the number of cylinders or of matches is known, chance is no reason to stop.
    let floor = options.least_support.or(options.count.map(|_| LEAST_SUPPORT));
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
        let demand = Demand { least_support: least, false_alarms, count };
        extract(plan, pairs, &demand, progress, &mut found);
    }
    (found, least)
}

/// What is asked of models.
#[derive(Clone, Copy, Debug)]
struct Demand {
    least_support: usize,
    /// Largest number of false alarms.
    false_alarms: f64,
    /// Number of models at which the search ends.
    count: usize,
}

/// Takes the best supported models one after the other. Without its lines a pair's best hypothesis can only lose support: what
/// was found before is a bound, and a pair is searched again only when it is the next by its bound.
fn extract(
    plan: &mut Plan,
    pairs: &[Pair],
    demand: &Demand,
    progress: &(dyn Fn(Progress) + Sync),
    found: &mut Vec<Model>,
) {
    progress(Progress::Pairs(pairs.len()));
    let search = |(index, pair): (usize, &Pair)| {
        let best = pair.best(plan, demand.least_support);
        progress(Progress::Pair);
        best.map(|best| (best, index))
    };
    #[cfg(feature = "parallel")]
    let best: Vec<_> = pairs.par_iter().enumerate().map(search).collect();
    #[cfg(not(feature = "parallel"))]
    let best: Vec<_> = pairs.iter().enumerate().map(search).collect();

    let mut round = found.len();
    let mut chance = Chance::of(plan, pairs);
    let mut queue: BinaryHeap<_> =
        best.into_iter().flatten().map(|(best, pair)| Candidate { best, pair, round }).collect();
    // What might be chance, until others are found: then there are fewer lines, and some of its silhouettes may be hidden.
    let mut doubtful = Vec::new();
    while found.len() < demand.count {
        let Some(candidate) = queue.pop() else { break };
        if candidate.round < round {
            let again = pairs[candidate.pair].best(plan, demand.least_support);
            queue.extend(again.map(|best| Candidate { best, round, ..candidate }));
            continue;
        }
        let Some(model) = fitted(plan, candidate.best.circle) else { continue };
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

/// Expected number of circles like this one by chance: on all silhouettes, or on those that the models found do not hide, whichever
/// is less, and twice that for the choice. Cylinders of finite length do not hide all that is behind them.
fn false_alarms(plan: &Plan, chance: &Chance, circle: &Circle, found: &[Model]) -> f64 {
    let circles: Vec<_> = found.iter().map(|model| model.fit.circle).collect();
    let (mut all, mut visible) = ((Vec::new(), 0), (Vec::new(), 0));
    for view in plan.views().iter().filter(|view| !view.lines.is_empty()) {
        let Some((silhouettes, hidden)) = plan.silhouettes(view, circle).zip(hidden(&view.centre, circle, &circles))
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

/// A pair's best hypothesis after so many models had been taken.
#[derive(Clone, Copy, Debug)]
struct Candidate {
    best: Hypothesis,
    pair: usize,
    round: usize,
}

impl Ord for Candidate {
    /// By support; where that is equal, the pair that comes first is the greater.
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

/// The circle that fits its matches best, fitted and matched in turn while the support increases. `None` where no circle can be
/// fitted to the matches at all.
fn fitted(plan: &Plan, circle: Circle) -> Option<Model> {
    let fit = |circle: &Circle| {
        let matches = plan.matches(circle);
        let lines: Vec<_> = matches.iter().map(|line| plan.tangent_line(line.line)).collect();
        Some(Model { fit: fit_circle(&lines, plan.extent()).ok()?, matches, false_alarms: f64::INFINITY })
    };
    let mut model = fit(&circle)?;
    for _ in 0..REPETITIONS {
        match fit(&model.fit.circle) {
            Some(next) if next.matches.len() >= model.matches.len() && next.matches != model.matches => model = next,
            _ => break,
        }
    }
    Some(model)
}
