//! A cylinder from any of the estimators, with all that makes it doubtful, in one form for reports.

use serde::Serialize;
use thiserror::Error;

use super::alternatives::PlausibleCylinders;
use super::evidence::{Evidence, PreparedLines};
use super::joint::Known;
use super::refine::{Loss, RefineError, RefineOptions, Refinement, refine};
use super::robust::{RobustError, RobustOptions, RobustTriangulation, triangulate_robustly};
use super::triangulate::{TriangulateError, Triangulation, triangulate};
use super::warnings::{Warning, bad_fit, camera_warnings, fit_warnings, thin};
use crate::axis::direction::Direction;
use crate::cross_section::circle::{CircleError, CircleFit};
use crate::observations::scene::LineId;
use crate::observations::view::View;
use crate::space::cylinder::{Cylinder, LineResidual, Side};
use crate::space::silhouette_distance::{DistanceUnit, Metric};

/// Largest expected number of cylinders by chance that draws no warning.
const FALSE_ALARMS: f64 = 1.0;

/// How a cylinder is estimated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method<'a> {
    /// Constrained least squares.
    LeastSquares,
    /// The same, refined on the distances in the images.
    Refined,
    /// RANSAC, refined.
    Robust(RobustOptions<'a>),
}

/// A cylinder and the results of its estimators.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// The cylinder.
    pub cylinder: Cylinder,
    /// One residual for each line, in the order of views and lines.
    pub residuals: Vec<LineResidual>,
    /// Number of lines of which none is a copy of another.
    pub independent_lines: usize,
    /// Direction and circle of least squares on all lines, if the estimate is theirs or started
    /// from them.
    pub least_squares: Option<(Direction, CircleFit)>,
    /// The refinement and the unit of its distances, if the cylinder was refined.
    pub refinement: Option<(Refinement, DistanceUnit)>,
    /// What RANSAC chose, if it was used.
    pub consensus: Option<EstimateConsensus>,
    /// What points of the scene told, if they were asked.
    pub surface_points: Option<SurfacePoints>,
    /// All cylinders that explain the lines about as well; of cylinders that share a direction or a
    /// radius, all that have them, too. `None` if they were not looked for.
    pub plausible: Option<PlausibleCylinders>,
    /// What makes the estimate doubtful.
    pub warnings: Vec<Warning>,
}

/// What RANSAC chose.
#[derive(Clone, Debug, PartialEq)]
pub struct EstimateConsensus {
    /// The lines that agree with the cylinder.
    pub inliers: Vec<LineId>,
    /// Number of independent lines that agree.
    pub independent: usize,
    /// Number of samples drawn.
    pub samples: usize,
    /// Largest root mean square distance of an inlier, unit of the refinement.
    pub threshold: f64,
    /// Expected number of cylinders on which as many lines agree by chance (an upper bound).
    pub false_alarms: f64,
}

/// What the points of the scene told of a cylinder.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct SurfacePoints {
    /// The number of points on the surface: the sum of the probabilities that they are. 0 if there
    /// are too few, or they do not gather at the surface.
    pub count: f64,
    /// The standard deviation of their distances from the surface, world units.
    pub deviation: f64,
}

/// Why there is no cylinder.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum EstimateError {
    /// Least squares found no cylinder.
    #[error(transparent)]
    Triangulate(#[from] TriangulateError),
    /// No cylinder in front of the cameras has all lines on the given side.
    #[error("no cylinder in front of the cameras has all lines on its {side} side")]
    NoneOnSide {
        /// The side.
        side: Side,
    },
    /// RANSAC found no cylinder.
    #[error(transparent)]
    Robust(#[from] RobustError),
    /// The cylinder could not be refined.
    #[error(transparent)]
    Refine(#[from] RefineError),
}

/// A cylinder from its silhouette lines, with the other cylinders that explain them about as well,
/// and with warnings. Copies of a line count as one line.
///
/// If several cylinders touch all lines exactly, as for three lines, the result is the one that is
/// listed first, and a warning.
///
/// # Errors
/// [`EstimateError`].
pub fn estimate(views: &[View], method: &Method) -> Result<Estimate, EstimateError> {
    if let Method::Robust(options) = method {
        let result = triangulate_robustly(views, options)?;
        return Ok(Estimate::from_robust(result, options.metric.unit, views));
    }
    let metric = Metric::of(views);
    let least_squares = match triangulate(views) {
        Ok(result) => Ok(result),
        Err(error @ TriangulateError::Circle(CircleError::Ambiguous { .. })) => Err(error),
        Err(error) => return Err(error.into()),
    };
    let lines = PreparedLines::of(views, &metric).map_err(RefineError::from)?;
    let evidence = lines.evidence(Known::default());
    let start = least_squares.as_ref().ok().map(|result| result.cylinder);
    let mut plausible = evidence.plausible_cylinders(start.as_ref());
    let best = plausible.cylinders.first().map(|best| best.cylinder);

    let mut estimate = match (least_squares, best) {
        (Ok(result), _) => Estimate::of_least_squares(result, lines.count),
        (Err(_), Some(best)) => {
            plausible.found = Some(0);
            Estimate::of_cylinder(best, views, lines.count)?
        }
        (Err(error), None) => return Err(error.into()),
    };
    if *method == Method::Refined {
        // The refinement starts from the best minimum, which need not be that of the cross-section.
        let start = best.unwrap_or(estimate.cylinder);
        estimate = estimate.refined(views, &start, &RefineOptions { metric, loss: Loss::Quadratic })?;
        plausible.found = best.map(|_| 0);
    }
    Ok(estimate.judged(views, &evidence, plausible))
}

/// The best cylinder that has all lines on one side, if the axis, with its largest entry positive,
/// points up: for one line in each image, which may touch a circle on either side. Refined, with
/// the other such cylinders that explain the lines about as well, and with warnings.
///
/// # Errors
/// [`EstimateError`].
pub fn estimate_on_side(views: &[View], side: Side) -> Result<Estimate, EstimateError> {
    let metric = Metric::of(views);
    let lines = PreparedLines::of(views, &metric).map_err(RefineError::from)?;
    if lines.count < 3 {
        return Err(TriangulateError::TooFewLines { lines: lines.count }.into());
    }
    let evidence = lines.evidence(Known { side: Some(side), ..Known::default() });
    let plausible = evidence.plausible_cylinders(None);
    let Some(best) = plausible.cylinders.first().map(|best| best.cylinder) else {
        return Err(EstimateError::NoneOnSide { side });
    };
    let options = RefineOptions { metric, loss: Loss::Quadratic };
    let estimate = Estimate::of_cylinder(best, views, lines.count)?.refined(views, &best, &options)?;
    Ok(estimate.judged(views, &evidence, PlausibleCylinders { found: Some(0), ..plausible }))
}

/// A cylinder that is known roughly, refined on all of its lines, with the other cylinders that
/// explain them about as well, and with warnings. Copies of a line count as one line.
///
/// # Errors
/// [`RefineError`].
pub fn estimate_from(views: &[View], initial: &Cylinder) -> Result<Estimate, RefineError> {
    let metric = Metric::of(views);
    let lines = PreparedLines::of(views, &metric)?;
    let evidence = lines.evidence(Known::default());
    let options = RefineOptions { metric, loss: Loss::Quadratic };
    let estimate = Estimate::of_cylinder(*initial, views, lines.count)?.refined(views, initial, &options)?;
    let plausible = evidence.plausible_cylinders(Some(&estimate.cylinder));
    Ok(estimate.judged(views, &evidence, plausible))
}

impl Estimate {
    pub(super) fn of_least_squares(result: Triangulation, independent_lines: usize) -> Self {
        let Triangulation { cylinder, direction, fit, residuals } = result;
        Self {
            cylinder,
            residuals,
            independent_lines,
            least_squares: Some((direction, fit)),
            refinement: None,
            consensus: None,
            surface_points: None,
            plausible: None,
            warnings: Vec::new(),
        }
    }

    pub(super) fn of_cylinder(
        cylinder: Cylinder,
        views: &[View],
        independent_lines: usize,
    ) -> Result<Self, RefineError> {
        Ok(Self {
            cylinder,
            residuals: residuals(&cylinder, views)?,
            independent_lines,
            least_squares: None,
            refinement: None,
            consensus: None,
            surface_points: None,
            plausible: None,
            warnings: Vec::new(),
        })
    }

    /// The result of RANSAC, with distances in this unit.
    fn from_robust(result: RobustTriangulation, unit: DistanceUnit, views: &[View]) -> Self {
        let RobustTriangulation { refinement, inliers, residuals, samples, .. } = result;
        let RobustTriangulation {
            threshold,
            independent: [lines, agreeing, distinct],
            false_alarms,
            plausible,
            rival,
            ..
        } = result;
        let mut warnings = camera_warnings(views);
        warnings.extend(thin(&refinement.cylinder, views));
        // The rival is the last of the list.
        let cylinders = plausible.cylinders.len() - usize::from(rival.is_some());
        if cylinders > usize::from(plausible.found.is_some()) {
            warnings.push(Warning::Ambiguous { cylinders });
        }
        warnings.extend(rival.map(|rival| Warning::Rival { agreeing: [agreeing, rival] }));
        if distinct < 4 {
            warnings.push(Warning::ThreeLines);
        }
        if false_alarms > FALSE_ALARMS {
            warnings.push(Warning::Chance { false_alarms });
        }
        warnings.extend(bad_fit(refinement.noise, unit, have_ends(views)));
        Self {
            cylinder: refinement.cylinder,
            residuals,
            independent_lines: lines,
            least_squares: None,
            refinement: Some((refinement, unit)),
            consensus: Some(EstimateConsensus { inliers, independent: agreeing, samples, threshold, false_alarms }),
            surface_points: None,
            plausible: Some(plausible),
            warnings,
        }
    }

    /// The views with the lines that agree with the cylinder: after RANSAC not all.
    pub(super) fn agreeing(&self, views: &[View]) -> Vec<View> {
        let Some(consensus) = &self.consensus else { return views.to_vec() };
        let agrees = |view, line: &usize| consensus.inliers.contains(&LineId { view, line: *line });
        let of_view = |(index, view): (usize, &View)| {
            view.selected(&(0..view.lines().len()).filter(|line| agrees(index, line)).collect::<Vec<_>>())
        };
        views.iter().enumerate().map(of_view).collect()
    }

    /// The estimate refined on all lines.
    fn refined(self, views: &[View], start: &Cylinder, options: &RefineOptions) -> Result<Self, RefineError> {
        self.with_refinement(views, refine(views, start, options)?, options.metric.unit)
    }

    /// The estimate with the cylinder of a refinement.
    pub(super) fn with_refinement(
        self,
        views: &[View],
        refinement: Refinement,
        unit: DistanceUnit,
    ) -> Result<Self, RefineError> {
        let cylinder = refinement.cylinder;
        let residuals = residuals(&cylinder, views)?;
        Ok(Self { cylinder, residuals, refinement: Some((refinement, unit)), ..self })
    }

    /// The estimate with the plausible cylinders and all warnings.
    pub(super) fn judged(mut self, views: &[View], evidence: &Evidence<'_>, plausible: PlausibleCylinders) -> Self {
        self.warnings.extend(camera_warnings(views));
        self.warnings.extend(thin(&self.cylinder, views));
        self.warnings.extend(fit_warnings(evidence, &self.cylinder, &plausible));
        self.plausible = Some(plausible);
        self
    }
}

/// Whether all lines have end points.
fn have_ends(views: &[View]) -> bool {
    views.iter().flat_map(View::ends).all(Option::is_some)
}

/// The residuals of all lines.
fn residuals(cylinder: &Cylinder, views: &[View]) -> Result<Vec<LineResidual>, RefineError> {
    let mut residuals = Vec::new();
    for (view, content) in views.iter().enumerate() {
        residuals.extend(cylinder.residuals(view, content).ok_or(RefineError::CameraInside { view })?);
    }
    Ok(residuals)
}
