//! Several cylinders that share a direction or a radius, with all that makes them doubtful.
//!
//! Each cylinder starts from its best minimum of the distances in the images. After the joint
//! refinement what the cylinders share is known, and the other minima of each are looked for again
//! with that knowledge. If one is better, the refinement starts again from it.

use thiserror::Error;

use super::alternatives::PlausibleCylinders;
use super::estimate::{Estimate, EstimateError};
use super::evidence::PreparedLines;
use super::joint::{Directions, JointRefinement, Known, Model, Radii, refine_together};
use super::refine::{Loss, Measure, RefineError, Refinement};
use super::silhouette_cost::Observed;
use super::triangulate::{TriangulateError, triangulate, triangulate_along};
use crate::axis::direction::{Direction, DirectionError, estimate_shared_direction};
use crate::cross_section::circle::CircleError;
use crate::numerics::interrupt::{Interrupt, Interrupted};
use crate::observations::copies::IndependentLines;
use crate::observations::view::View;
use crate::space::cylinder::Cylinder;
use crate::space::silhouette_distance::{DistanceUnit, Metric};

/// Smaller distances are rounding errors, pixels or radians.
const EXACT: f64 = 1e-9;

/// Limit on the number of joint refinements. The second one is rarely needed.
const ATTEMPTS: usize = 3;

/// How several cylinders are estimated.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct JointMethod<'a> {
    /// Whether they have one direction.
    pub parallel: bool,
    /// Their radii and the loss of the distances in the images; `None` for least squares in the
    /// cross-section.
    pub refinement: Option<(Radii, Loss)>,
    /// Ends the estimate between cylinders and between the steps of joint refinements.
    pub interrupt: Interrupt<'a>,
}

impl<'a> JointMethod<'a> {
    /// The joint refinement: without one on the distances in the images, that of own radii.
    pub(super) fn model(&self) -> Model<'a> {
        let directions = if self.parallel { Directions::Shared } else { Directions::Own };
        let (radii, loss) = self.refinement.unwrap_or((Radii::Own, Loss::Quadratic));
        Model { directions, radii, loss, interrupt: self.interrupt }
    }
}

/// Cylinders that were estimated together.
#[derive(Clone, Debug, PartialEq)]
pub struct JointEstimate {
    /// The cylinders, in the order of the input.
    pub cylinders: Vec<Estimate>,
    /// The radius that they share.
    pub radius: Option<Measure>,
}

/// Why there are no cylinders.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum JointError {
    /// The lines of all cylinders together determine no direction.
    #[error(transparent)]
    Direction(#[from] DirectionError),
    /// A cylinder is not determined.
    #[error("cylinder {cylinder}: {error}")]
    Cylinder {
        /// Index of the cylinder.
        cylinder: usize,
        /// Reason.
        error: EstimateError,
    },
    /// The cylinders cannot be refined together.
    #[error(transparent)]
    Refine(RefineError),
    /// The method interrupts the estimate.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
}

impl From<RefineError> for JointError {
    fn from(error: RefineError) -> Self {
        match error {
            RefineError::Interrupted(error) => Self::Interrupted(error),
            error => Self::Refine(error),
        }
    }
}

/// Cylinders that share a direction or a radius, each given by views that contain only its own
/// lines. Copies of a line count as one line. The results have all warnings that a single cylinder
/// has ([`estimate`](super::estimate::estimate)).
///
/// # Errors
/// [`JointError`].
pub fn estimate_together(cylinders: &[Vec<View>], method: &JointMethod) -> Result<JointEstimate, JointError> {
    let direction = match method.parallel {
        true => Some(shared_direction(cylinders)?),
        false => None,
    };
    let metric = metric(cylinders);
    let radius = match method.refinement {
        Some((Radii::Known(radius), _)) => Some(radius),
        _ => None,
    };
    let mut starts = Vec::with_capacity(cylinders.len());
    for (cylinder, views) in cylinders.iter().enumerate() {
        method.interrupt.check()?;
        let failure = |error| JointError::Cylinder { cylinder, error };
        starts.push(Start::new(views, direction, radius, &metric).map_err(failure)?);
    }
    match method.refinement {
        Some(_) => refined(starts, &method.model(), metric.unit),
        None => Ok(JointEstimate { cylinders: starts.into_iter().map(Start::estimate).collect(), radius: None }),
    }
}

fn shared_direction(cylinders: &[Vec<View>]) -> Result<Direction, DirectionError> {
    let planes = |views: &Vec<View>| IndependentLines::of(views).views.iter().flat_map(View::planes).collect();
    let planes: Vec<_> = cylinders.iter().map(planes).collect();
    Ok(estimate_shared_direction(&planes)?.direction)
}

/// Cylinders that were refined each by itself, with one direction. `None` for a single one, and if
/// their lines say that they are not parallel, by the criterion of Schwarz ("Estimating the
/// dimension of a model", 1978): for `n` distances with the sums of squares `S` with own
/// directions and `S'` with one, of `q` parameters less,
///
/// ```text
///   n log(S' / S) > q log n
/// ```
pub(crate) fn parallel_from(
    own: &[Estimate],
    cylinders: &[Vec<View>],
    interrupt: Interrupt<'_>,
) -> Option<Vec<Estimate>> {
    if own.len() < 2 {
        return None;
    }
    let metric = metric(cylinders);
    let lines = cylinders.iter().map(|views| metric.measured(&IndependentLines::of(views)).ok());
    let lines: Vec<_> = lines.collect::<Option<_>>()?;
    let observed: Vec<_> = lines.iter().map(|lines| Observed::lines(lines)).collect();
    let start: Vec<_> = own.iter().map(|estimate| estimate.cylinder).collect();
    let model = Model { directions: Directions::Shared, radii: Radii::Own, loss: Loss::Quadratic, interrupt };
    let with_one = refine_together(&observed, &start, &model).ok()?;
    let with_own = own.iter().map(|estimate| estimate.refinement.as_ref().filter(|(_, unit)| *unit == metric.unit));
    let with_own: Vec<&Refinement> = with_own.map(|own| own.map(|(own, _)| own)).collect::<Option<_>>()?;
    let count = 2.0 * lines.iter().map(Vec::len).sum::<usize>() as f64;
    let squares = |refinements: &[&Refinement]| {
        let of_cylinder =
            |(refinement, lines): (&&Refinement, &Vec<_>)| refinement.rms.powi(2) * 2.0 * lines.len() as f64;
        refinements.iter().zip(&lines).map(of_cylinder).sum::<f64>() + count * EXACT * EXACT
    };
    let fewer = 2.0 * (own.len() - 1) as f64;
    let ratio = squares(&with_one.cylinders.iter().collect::<Vec<_>>()) / squares(&with_own);
    if count * ratio.ln() > fewer * count.ln() {
        return None;
    }
    let parts = own.iter().zip(cylinders).zip(with_one.cylinders);
    let estimates = parts
        .map(|((estimate, views), refinement)| estimate.clone().with_refinement(views, refinement, metric.unit).ok());
    estimates.collect()
}

/// Pixels only if all cameras have a calibration.
pub(super) fn metric(cylinders: &[Vec<View>]) -> Metric {
    let metrics = cylinders.iter().map(|views| Metric::of(views));
    let radians = metrics.into_iter().find(|metric| metric.unit == DistanceUnit::Radians);
    radians.unwrap_or_else(|| Metric::of(&[]))
}

/// A cylinder before the joint refinement.
struct Start<'a> {
    views: &'a [View],
    lines: PreparedLines,
    known: Known,
    estimate: Estimate,
    plausible: PlausibleCylinders,
}

impl<'a> Start<'a> {
    fn new(
        views: &'a [View],
        direction: Option<Direction>,
        radius: Option<f64>,
        metric: &Metric,
    ) -> Result<Self, EstimateError> {
        let result = match direction {
            Some(direction) => triangulate_along(views, direction),
            None => triangulate(views),
        };
        let least_squares = match result {
            Err(error) if !matches!(error, TriangulateError::Circle(CircleError::Ambiguous { .. })) => {
                return Err(error.into());
            }
            result => result,
        };
        let lines = PreparedLines::of(views, metric).map_err(RefineError::from)?;
        let known = Known { direction: direction.map(|direction| direction.direction), radius, side: None };
        let start = least_squares.as_ref().ok().map(|result| result.cylinder);
        let mut plausible = lines.evidence(known).plausible_cylinders(start.as_ref());
        let estimate = match (least_squares, plausible.cylinders.first()) {
            (Ok(result), _) => Estimate::of_least_squares(result, lines.count),
            (Err(_), Some(best)) => {
                plausible.found = Some(0);
                Estimate::of_cylinder(best.cylinder, views, lines.count)?
            }
            (Err(error), None) => return Err(error.into()),
        };
        Ok(Self { views, lines, known, estimate, plausible })
    }

    /// The best minimum in front of the cameras, from which the refinement starts.
    fn cylinder(&self) -> Cylinder {
        self.plausible.cylinders.first().map_or(self.estimate.cylinder, |best| best.cylinder)
    }

    fn estimate(self) -> Estimate {
        self.estimate.judged(self.views, &self.lines.evidence(self.known), self.plausible)
    }
}

/// The cylinders refined together.
fn refined(mut starts: Vec<Start<'_>>, model: &Model<'_>, unit: DistanceUnit) -> Result<JointEstimate, JointError> {
    let mut attempt = 1;
    let JointRefinement { cylinders, radius } = loop {
        let initial: Vec<_> = starts.iter().map(Start::cylinder).collect();
        let lines: Vec<_> = starts.iter().map(|start| Observed::lines(&start.lines.measured)).collect();
        let joint = refine_together(&lines, &initial, model)?;
        for (start, refinement) in starts.iter_mut().zip(&joint.cylinders) {
            model.interrupt.check()?;
            let Cylinder { direction, radius, .. } = refinement.cylinder;
            start.known = Known {
                direction: (model.directions == Directions::Shared).then_some(direction),
                radius: (model.radii != Radii::Own).then_some(radius),
                side: None,
            };
            start.plausible = start.lines.evidence(start.known).plausible_cylinders(Some(&refinement.cylinder));
        }
        let is_best = |start: &Start<'_>| start.plausible.found == Some(0) || start.plausible.cylinders.is_empty();
        if starts.iter().all(is_best) || attempt == ATTEMPTS {
            break joint;
        }
        attempt += 1;
    };
    let estimate = |(index, (start, refinement)): (usize, (Start<'_>, _))| {
        let failure = |error: RefineError| JointError::Cylinder { cylinder: index, error: error.into() };
        let estimate = start.estimate.with_refinement(start.views, refinement, unit).map_err(failure)?;
        Ok(estimate.judged(start.views, &start.lines.evidence(start.known), start.plausible))
    };
    let cylinders = starts.into_iter().zip(cylinders).enumerate().map(estimate).collect::<Result<_, JointError>>()?;
    Ok(JointEstimate { cylinders, radius })
}
