//! The cylinder on which most lines agree if many of them are not its silhouettes: RANSAC around
//! the minimal solver, then refinement, with the scale of the noise estimated.
//!
//! ```text
//!   RANSAC --> lines within t --> refinement --> noise sigma --> lines within k sigma, <= t_max
//!     t = 3 pixels, then 12 and 48           ^___________________________|
//!     if chance explains the agreement          until the lines are the same
//! ```
//!
//! A line agrees with a cylinder if its distance from the silhouette is within the threshold and
//! the point of contact lies in front of the camera. This test chooses among the four circles. The
//! threshold follows the noise: with a fixed one of 3 pixels a third of the good lines would be
//! lost at a noise of 3 pixels, and the deviations would be too small. The factor `k` is 2.6 for
//! many lines, and larger for few, from which the noise is less certain.

use nalgebra::{Unit, Vector3};
use thiserror::Error;

use super::alternatives::{Alternative, PLAUSIBLE, PlausibleCylinders, triples, usual_noise};
use super::evidence::{Evidence, distinct_planes};
use super::joint::Known;
use super::refine::{Loss, RefineError, Refinement, refine_lines};
use super::sampling::CylinderEstimator;
use super::significance::log_false_alarms;
use super::triangulate::{identified_planes, is_single_viewpoint};
use crate::numerics::interrupt::Interrupted;
use crate::numerics::ransac::{Estimator, RansacOptions, RansacOptionsError, ransac, samples_needed};
use crate::observations::copies::IndependentLines;
use crate::observations::scene::LineId;
use crate::observations::view::{View, ViewingPlane};
use crate::space::cylinder::{Cylinder, LineResidual};
use crate::space::silhouette_distance::{DistanceUnit, Metric, MetricError};

/// Threshold of the first search, pixels: an end point that is off by a pixel may reach it.
const THRESHOLD_PIXELS: f64 = 3.0;

/// The same threshold in radians: three pixels at a focal length of 3000.
const THRESHOLD_RADIANS: f64 = 1e-3;

/// Thresholds of the searches, in units of that threshold.
const LEVELS: [f64; 3] = [1.0, 4.0, 16.0];

/// Default of the largest threshold, in units of that threshold.
const LARGEST: f64 = 16.0;

/// A search with a larger threshold is made if chance would give more agreements than this.
const CONVINCING: f64 = 1e-3;

/// Part of the good lines that the threshold excludes.
const EXCLUDED: f64 = 1e-3;

/// A line that does not agree counts in comparisons as one at this distance, in units of the noise.
const DEVIATIONS: f64 = 3.0;

/// Number of lines that the usual noise is worth in the estimate of the noise. With few lines the
/// estimate may otherwise be far too small by chance.
const PRIOR_LINES: f64 = 2.0;

/// The usual noise for that purpose, in units of the first threshold: a pixel.
const PRIOR_NOISE: f64 = 1.0 / 3.0;

/// Limit on the repetitions of refinement and choice of inliers. They mostly agree after three.
const REPETITIONS: usize = 20;

/// Another cylinder is a rival if this part of the number of inliers agrees on it.
const RIVAL: f64 = 0.75;

/// Largest sine of the angle between the axis and a viewing plane along it. It is far above the
/// uncertainty of a short line.
const ALONG: f64 = 0.05;

/// Few lines do not show that the part of lines along the axis is smaller.
const LEAST_ALONG: f64 = 0.25;

/// Limit on the attempts to find more inliers within twice the threshold.
const WIDENINGS: usize = 3;

/// Samples of all lines are compared with the estimate if there are at most so many lines.
const FEW_LINES: usize = 8;

/// Options of the robust estimation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RobustOptions<'a> {
    /// How distances between lines and silhouettes are measured.
    pub metric: Metric,
    /// Options of RANSAC. The threshold is the largest root mean square distance that an inlier may
    /// have, in the unit of the metric; where the noise is small, less is allowed.
    pub ransac: RansacOptions<'a>,
    /// Direction of the axis, if it is known. Only the final refinement changes it.
    pub direction: Option<Unit<Vector3<f64>>>,
}

/// A cylinder and the lines that agree with it.
#[derive(Clone, Debug, PartialEq)]
pub struct RobustTriangulation {
    /// The cylinder, refined on the inliers, and its uncertainty.
    pub refinement: Refinement,
    /// The lines that agree with it, in the order of views and lines.
    pub inliers: Vec<LineId>,
    /// One residual for each line, in the order of views and lines.
    pub residuals: Vec<LineResidual>,
    /// Number of samples drawn.
    pub samples: usize,
    /// Largest root mean square distance of an inlier: a good line of the estimated noise exceeds
    /// it once in a thousand; at most the threshold of the options. Unit of the metric.
    pub threshold: f64,
    /// Number of independent lines, of those that agree, and of those that agree and are clearly
    /// distinct. Copies of a line count once.
    pub independent: [usize; 3],
    /// Expected number of cylinders on which as many lines agree by chance (an upper bound).
    pub false_alarms: f64,
    /// All cylinders that explain the lines about as well, this one included, and after them the
    /// rival.
    pub plausible: PlausibleCylinders,
    /// Number of independent lines, none of them an inlier, that agree on another cylinder, if they
    /// are nearly as many. `None` if there is no such rival.
    pub rival: Option<usize>,
}

/// Why no cylinder was found.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum RobustError {
    /// There are too few lines: a fourth one is needed to choose among the cylinders that touch
    /// three.
    #[error(
        "{lines} line(s) given, copies counted once; a robust estimate samples three of them and needs others to agree: pass at least four \
         lines from two views, better two silhouettes from each of three views; without wrong lines, use plain \
         triangulation"
    )]
    TooFewLines {
        /// Number of independent lines.
        lines: usize,
    },
    /// All cameras stand at one place.
    #[error("all cameras stand at one place: the distance to the cylinder is unknown")]
    SingleViewpoint,
    /// An option of RANSAC is out of range.
    #[error(transparent)]
    Options(#[from] RansacOptionsError),
    /// Distances cannot be measured.
    #[error(transparent)]
    Metric(#[from] MetricError),
    /// The options interrupt RANSAC.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
    /// No cylinder has four inliers.
    #[error(
        "{inliers} of {lines} lines agree on a cylinder, but four are needed ({samples} samples): pass more silhouette \
         lines, from more views, or a larger threshold or number of samples"
    )]
    NoConsensus {
        /// Number of lines that agree with the best cylinder.
        inliers: usize,
        /// Number of lines.
        lines: usize,
        /// Number of samples drawn.
        samples: usize,
    },
    /// The inliers do not determine a cylinder.
    #[error("{inliers} of {lines} lines agree on a cylinder, which cannot be refined: {error}")]
    Refine {
        /// Number of lines that agree.
        inliers: usize,
        /// Number of lines.
        lines: usize,
        /// Reason.
        error: RefineError,
    },
    /// The cylinder contains a camera that saw no inlier.
    #[error("the cylinder on which most lines agree contains the camera of views[{view}]")]
    CameraInside {
        /// Index of the view.
        view: usize,
    },
}

impl RobustOptions<'_> {
    /// Pixels and a largest threshold of 48 if all cameras have a calibration, radians and 0.016
    /// otherwise.
    pub fn of(views: &[View]) -> Self {
        let metric = Metric::of(views);
        let threshold = LARGEST * first_threshold(metric.unit);
        Self { metric, ransac: RansacOptions::with_threshold(threshold), direction: None }
    }
}

fn first_threshold(unit: DistanceUnit) -> f64 {
    match unit {
        DistanceUnit::Pixels => THRESHOLD_PIXELS,
        DistanceUnit::Radians => THRESHOLD_RADIANS,
    }
}

/// The cylinder on which most lines agree, whatever the other lines are. Copies of a line count as
/// one line ([`IndependentLines`]).
///
/// # Errors
/// [`RobustError`].
pub fn triangulate_robustly(views: &[View], options: &RobustOptions) -> Result<RobustTriangulation, RobustError> {
    options.ransac.check()?;
    let independent = IndependentLines::of(views);
    let lines = independent.count();
    if independent.given() >= 3 && is_single_viewpoint(views) {
        return Err(RobustError::SingleViewpoint);
    }
    if lines < 4 {
        return Err(RobustError::TooFewLines { lines });
    }
    let measured = options.metric.measured(&independent)?;
    let planes = identified_planes(&independent);
    let estimator = CylinderEstimator { planes, measured, direction: options.direction, square_threshold: 0.0 };
    let mut search = Search { estimator, options, focal: focal_length(views, options.metric.unit), samples: 0 };
    let agreement = search.agreement()?;
    let distinct = search.distinct(&agreement, &independent);
    let mut plausible = search.plausible(&agreement, &distinct);
    let rival = search.rival(&agreement);
    // What was interrupted found no rival.
    options.ransac.interrupt.check()?;
    let false_alarms = search.false_alarms(&agreement);
    plausible.cylinders.extend(rival.iter().map(|rival| search.alternative(rival, &agreement)));
    let rival = rival.map(|rival| rival.inliers.len());

    let Agreement { refinement, inliers, threshold, .. } = agreement;
    let mut residuals = Vec::with_capacity(independent.given());
    for (view, content) in views.iter().enumerate().filter(|(_, content)| !content.lines().is_empty()) {
        let inside = RobustError::CameraInside { view };
        residuals.extend(refinement.cylinder.residuals(view, content).ok_or(inside)?);
    }
    let mut agreeing: Vec<_> = inliers.iter().flat_map(|&index| independent.copies[index].iter().copied()).collect();
    agreeing.sort_by_key(|id| (id.view, id.line));
    Ok(RobustTriangulation {
        refinement,
        inliers: agreeing,
        residuals,
        samples: search.samples,
        threshold,
        independent: [lines, inliers.len(), distinct.len()],
        false_alarms,
        plausible,
        rival,
    })
}

/// Mean focal length in the unit of distances.
fn focal_length(views: &[View], unit: DistanceUnit) -> f64 {
    let focal = |view: &View| {
        let k = view.camera().calibration()?.matrix();
        Some((k[(0, 0)] * k[(1, 1)]).abs().sqrt())
    };
    let known: Vec<_> = views.iter().filter_map(focal).collect();
    match unit {
        DistanceUnit::Pixels if !known.is_empty() => known.iter().sum::<f64>() / known.len() as f64,
        _ => 1.0,
    }
}

/// A cylinder and the independent lines that agree with it.
struct Agreement {
    refinement: Refinement,
    /// Indices of independent lines, ascending.
    inliers: Vec<usize>,
    threshold: f64,
    log_false_alarms: f64,
}

struct Search<'a> {
    estimator: CylinderEstimator,
    options: &'a RobustOptions<'a>,
    focal: f64,
    /// Number of samples drawn so far.
    samples: usize,
}

impl Search<'_> {
    /// The agreement of the search with the least threshold that chance does not explain; otherwise
    /// the one that chance explains least.
    fn agreement(&mut self) -> Result<Agreement, RobustError> {
        let largest = self.options.ransac.threshold;
        let first = first_threshold(self.options.metric.unit);
        let (mut best, mut failure): (Option<Agreement>, _) = (None, None);
        for level in LEVELS {
            let threshold = (level * first).min(largest);
            match self.agreement_within(threshold) {
                Ok(found) => {
                    // A wider search may find more by chance alone.
                    let is_admitted = level <= 1.0 || found.log_false_alarms < 0.0;
                    if is_admitted && best.as_ref().is_none_or(|best| found.log_false_alarms < best.log_false_alarms) {
                        best = Some(found);
                    }
                }
                Err(error @ RobustError::Interrupted(_)) => return Err(error),
                Err(error) => failure = failure.or(Some(error)),
            }
            let is_convincing = best.as_ref().is_some_and(|best| best.log_false_alarms < CONVINCING.ln());
            if is_convincing || threshold >= largest {
                break;
            }
        }
        best.ok_or_else(|| match failure {
            Some(RobustError::NoConsensus { inliers, lines, .. }) => {
                RobustError::NoConsensus { inliers, lines, samples: self.samples }
            }
            Some(error) => error,
            None => self.no_consensus(0),
        })
    }

    fn no_consensus(&self, inliers: usize) -> RobustError {
        RobustError::NoConsensus { inliers, lines: self.estimator.count(), samples: self.samples }
    }

    /// RANSAC at a threshold; then refinement and choice of inliers in turn.
    fn agreement_within(&mut self, threshold: f64) -> Result<Agreement, RobustError> {
        self.estimator.square_threshold = threshold * threshold;
        let options = RansacOptions { threshold, ..self.options.ransac };
        let consensus = ransac(&self.estimator, &options)?;
        self.samples += consensus.as_ref().map_or(options.max_samples, |consensus| consensus.samples);
        let consensus = consensus.ok_or_else(|| self.no_consensus(0))?;
        if consensus.inliers.len() < 4 {
            return Err(self.no_consensus(consensus.inliers.len()));
        }
        let refinement = self.refined(&consensus.inliers, &consensus.model)?;
        let mut best = self.settled(refinement, consensus.inliers);
        // A set of good lines that happen to be near may keep the others out.
        for _ in 0..WIDENINGS {
            let wide = self.estimator.within(&best.refinement.cylinder, 2.0 * best.threshold);
            if wide.len() == best.inliers.len() {
                break;
            }
            let Ok(refinement) = self.refined(&wide, &best.refinement.cylinder) else { break };
            let wide = self.settled(refinement, wide);
            if wide.log_false_alarms >= best.log_false_alarms {
                break;
            }
            best = wide;
        }
        Ok(best)
    }

    /// Refinement and choice of inliers in turn, until they agree.
    fn settled(&self, mut refinement: Refinement, mut inliers: Vec<usize>) -> Agreement {
        let mut threshold = self.threshold(&refinement);
        for _ in 0..REPETITIONS {
            let agreeing = self.estimator.within(&refinement.cylinder, threshold);
            if agreeing == inliers || agreeing.len() < 4 || self.options.ransac.interrupt.is_set() {
                break;
            }
            // A larger set of lines may fit no cylinder; then the smaller one is kept.
            let Ok(next) = self.refined(&agreeing, &refinement.cylinder) else { break };
            (refinement, inliers) = (next, agreeing);
            threshold = self.threshold(&refinement);
        }
        let log_false_alarms = log_false_alarms(inliers.len(), self.estimator.count(), threshold / self.focal);
        Agreement { refinement, inliers, threshold, log_false_alarms }
    }

    /// Expected number of cylinders like this one by chance, for a reader: unlike in the search,
    /// only lines along the axis are taken to agree by chance.
    fn false_alarms(&self, found: &Agreement) -> f64 {
        let part = self.part_along(&found.refinement.cylinder, &found.inliers);
        log_false_alarms(found.inliers.len(), self.estimator.count(), part * found.threshold / self.focal).exp()
    }

    /// The part of the lines that do not agree whose planes are along the axis, at least a quarter;
    /// one line is added to both numbers.
    fn part_along(&self, cylinder: &Cylinder, inliers: &[usize]) -> f64 {
        let (mut along, mut all) = (1.0, 1.0);
        for (index, (_, plane)) in self.estimator.planes.iter().enumerate() {
            if inliers.binary_search(&index).is_err() {
                all += 1.0;
                along += if plane.normal.dot(&cylinder.direction).abs() <= ALONG { 1.0 } else { 0.0 };
            }
        }
        f64::max(along / all, LEAST_ALONG)
    }

    fn refined(&self, inliers: &[usize], start: &Cylinder) -> Result<Refinement, RobustError> {
        let lines = self.estimator.count();
        let failure = |error| RobustError::Refine { inliers: inliers.len(), lines, error };
        refine_lines(&self.estimator.measured(inliers), start, Loss::Quadratic).map_err(failure)
    }

    /// The distance that a good line exceeds with the probability `alpha`, at most the threshold of
    /// the options: its mean square over the estimated variance has the F distribution with 2 and
    /// `nu` degrees of freedom, hence
    ///
    /// ```text
    ///     t^2 = sigma^2 (alpha^(-2 / nu) - 1) nu / 2
    /// ```
    fn threshold(&self, refinement: &Refinement) -> f64 {
        let usual = PRIOR_NOISE * first_threshold(self.options.metric.unit);
        let freedom = refinement.degrees_of_freedom + 2.0 * PRIOR_LINES;
        let squares = refinement.noise.powi(2) * refinement.degrees_of_freedom + 2.0 * PRIOR_LINES * usual * usual;
        let square = squares / 2.0 * (EXCLUDED.powf(-2.0 / freedom) - 1.0);
        square.sqrt().min(self.options.ransac.threshold)
    }

    /// The planes of the clearly distinct lines that agree.
    fn distinct(&self, found: &Agreement, independent: &IndependentLines) -> Vec<(LineId, ViewingPlane)> {
        let mut starts = vec![0];
        for view in &independent.views {
            starts.push(starts[starts.len() - 1] + view.lines().len());
        }
        // Inliers are ascending.
        let place = |start: usize| found.inliers.partition_point(|&index| index < start);
        let agreeing = |view: usize| -> Vec<usize> {
            let of_view = &found.inliers[place(starts[view])..place(starts[view + 1])];
            of_view.iter().map(|index| index - starts[view]).collect()
        };
        let views = independent.views.iter().enumerate().map(|(index, view)| view.selected(&agreeing(index))).collect();
        distinct_planes(&IndependentLines { views, copies: Vec::new() })
    }

    /// The cylinders that explain the lines about as well as the one that was found. All of them
    /// explain its inliers, or as many others.
    fn plausible(&self, found: &Agreement, distinct: &[(LineId, ViewingPlane)]) -> PlausibleCylinders {
        let planes: Vec<_> = found.inliers.iter().map(|&index| self.estimator.planes[index]).collect();
        let measured = self.estimator.measured(&found.inliers);
        let unit = self.options.metric.unit;
        let evidence = Evidence { planes: &planes, measured: &measured, distinct, unit, known: Known::default() };
        let mut plausible = evidence.plausible_cylinders(Some(&found.refinement.cylinder));
        if self.estimator.count() <= FEW_LINES && self.estimator.count() > found.inliers.len() {
            let least = self.truncated_cost(&found.refinement.cylinder, found);
            let mut models = Vec::new();
            for sample in triples(self.estimator.count()) {
                self.estimator.add_models(&sample, &mut models);
                for model in models.drain(..) {
                    let others = self.estimator.within(&model, found.threshold);
                    let Ok(refined) = self.refined(&others, &model) else { continue };
                    let plausibility = (0.5 * (least - self.truncated_cost(&refined.cylinder, found))).exp();
                    let is_known =
                        plausible.cylinders.iter().any(|known| evidence.is_same(&known.cylinder, &refined.cylinder))
                            || found.refinement.is_near(&refined.cylinder)
                            || refined.is_near(&found.refinement.cylinder);
                    if others.len() >= 4 && plausibility >= PLAUSIBLE && !is_known {
                        plausible.cylinders.push(Alternative {
                            cylinder: refined.cylinder,
                            rms: refined.rms,
                            plausibility,
                        });
                    }
                }
            }
            let own = plausible.found.map(|found| plausible.cylinders[found]);
            plausible.cylinders.sort_by(|one, other| other.plausibility.total_cmp(&one.plausibility));
            plausible.found = plausible.cylinders.iter().position(|known| Some(*known) == own);
        }
        plausible
    }

    /// Another cylinder on which nearly as many of the other lines agree. Enough samples are drawn
    /// to find it with the required confidence.
    fn rival(&self, found: &Agreement) -> Option<Agreement> {
        let rest: Vec<_> =
            (0..self.estimator.count()).filter(|index| found.inliers.binary_search(index).is_err()).collect();
        let least = ((RIVAL * found.inliers.len() as f64).ceil() as usize).max(4);
        if rest.len() < least {
            return None;
        }
        let samples = samples_needed(least, rest.len(), CylinderEstimator::SAMPLE, &self.options.ransac);
        let options =
            RobustOptions { ransac: RansacOptions { max_samples: samples, ..self.options.ransac }, ..*self.options };
        let estimator = CylinderEstimator {
            planes: rest.iter().map(|&index| self.estimator.planes[index]).collect(),
            measured: self.estimator.measured(&rest),
            ..self.estimator
        };
        let mut search = Search { estimator, options: &options, focal: self.focal, samples: 0 };
        let threshold = found.threshold.max(first_threshold(options.metric.unit)).min(options.ransac.threshold);
        let rival = search.agreement_within(threshold).ok()?;
        let is_rival = rival.inliers.len() >= least && rival.log_false_alarms < CONVINCING.ln();
        let is_other = !found.refinement.is_near(&rival.refinement.cylinder);
        (is_rival && is_other).then_some(rival)
    }

    /// A rival in the form of the plausible cylinders.
    fn alternative(&self, rival: &Agreement, found: &Agreement) -> Alternative {
        let Refinement { cylinder, rms, .. } = rival.refinement;
        let costs = [&found.refinement.cylinder, &cylinder].map(|cylinder| self.truncated_cost(cylinder, found));
        Alternative { cylinder, rms, plausibility: (0.5 * (costs[0] - costs[1])).exp() }
    }

    /// The sum of squares of all lines in units of the noise, each line limited by the threshold.
    fn truncated_cost(&self, cylinder: &Cylinder, found: &Agreement) -> f64 {
        let noise = found.refinement.noise.max(usual_noise(self.options.metric.unit));
        let squares = self.estimator.squares(cylinder).into_iter();
        squares.map(|square| 2.0 * (square / (noise * noise)).min(DEVIATIONS * DEVIATIONS)).sum()
    }
}
