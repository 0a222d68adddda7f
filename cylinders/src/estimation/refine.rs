//! The optional last step: minimises the distances between the given lines and the silhouettes over
//! all parameters of the cylinder at once, and estimates their uncertainty.
//!
//! ```text
//!   minimise  sum_i rho(|e_i|^2 / 2)   over the axis (4 parameters) and the radius
//! ```
//!
//! with the distances `e_i` of two points of each line and the loss `rho`, by Levenberg-Marquardt
//! with the weights `rho'` (iteratively reweighted). The unit of the coordinates is the mean
//! distance of the cameras from the axis, and their origin is on the part of it that the lines see.

use nalgebra::{Matrix5, Point3, Vector3, Vector5};

pub use super::loss::Loss;
pub use super::refine_error::RefineError;
use super::silhouette_cost::{Frame, Observed, SilhouetteCost, across};
use super::triangulate::is_single_viewpoint;
use super::uncertainty::{Block, Uncertainty};
use crate::numerics::levenberg_marquardt::minimise;
use crate::observations::copies::IndependentLines;
use crate::observations::view::View;
use crate::space::cylinder::Cylinder;
use crate::space::silhouette_distance::{MeasuredLine, Metric};

/// Limit on the steps of Levenberg-Marquardt.
pub(super) const STEPS: usize = 200;

/// The radius counts as zero if it is at most this, relative to the mean distance of the cameras
/// from the axis. It is far below what an image can show.
pub(super) const NO_RADIUS: f64 = 1e-9;

/// Two estimates of one cylinder hardly differ by more than this number of standard deviations of
/// either.
const NEAR: f64 = 5.0;

/// The cost that is minimised.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RefineOptions {
    /// How distances are measured.
    pub metric: Metric,
    /// The loss of the distances.
    pub loss: Loss,
}

/// A refined cylinder and its uncertainty.
#[derive(Clone, Debug, PartialEq)]
pub struct Refinement {
    /// The cylinder.
    pub cylinder: Cylinder,
    /// The point of the axis to which the uncertainty of its position refers. It is in the middle
    /// of the part that the lines see; world frame.
    pub reference: Point3<f64>,
    /// Unit vectors `f1`, `f2` across the axis.
    pub across: [Vector3<f64>; 2],
    /// Covariance of the local parameters
    ///
    /// ```text
    ///   (f1^T dw, f2^T dw, f1^T dA, f2^T dA, dr)
    /// ```
    ///
    /// with the direction `w` (radians), the point `A` of the axis at the reference and the radius
    /// `r`, in world units: `sigma^2 (J^T W J)^-1` with the variance `sigma^2` of a distance
    /// estimated from the residuals. This holds to first order. If the loss is not quadratic, the
    /// weights are held fixed, so the covariance is too small by the share of good lines whose
    /// weight is reduced.
    pub covariance: Matrix5<f64>,
    /// Standard deviations that follow from the covariance.
    pub deviation: Deviation,
    /// Root mean square distance of the support points, in the unit of the metric.
    pub rms: f64,
    /// Estimated standard deviation of the distance of a support point, in the unit of the metric:
    /// the root of the sum of squares over the degrees of freedom. It is larger than `rms`, because
    /// the cylinder adapts to the noise.
    pub noise: f64,
    /// Degrees of freedom of that estimate: twice the number of independent lines, minus five. If
    /// the loss is not quadratic, lines count with their weights.
    pub degrees_of_freedom: f64,
    /// Steps taken.
    pub iterations: usize,
}

impl Refinement {
    /// Whether another cylinder is the same within a few standard deviations.
    pub(crate) fn is_near(&self, other: &Cylinder) -> bool {
        let Deviation { direction, position, radius } = self.deviation;
        let apart = self.cylinder.vector_to_axis(&self.reference) - other.vector_to_axis(&self.reference);
        (self.cylinder.radius - other.radius).abs() <= NEAR * radius
            && apart.norm() <= NEAR * position
            && self.cylinder.direction.cross(&other.direction).norm() <= NEAR * direction
    }
}

/// Standard deviations of a cylinder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviation {
    /// Root mean square angle between estimated and true direction, radians.
    pub direction: f64,
    /// Root mean square distance between estimated and true axis at the reference, world units.
    pub position: f64,
    /// Standard deviation of the radius, world units.
    pub radius: f64,
}

/// A number and its standard deviation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measure {
    /// The number.
    pub value: f64,
    /// Its standard deviation.
    pub deviation: f64,
}

/// Refines a cylinder on the lines of all views. Copies of a line count as one line
/// ([`IndependentLines`]). The direction of the result has a canonical sign: its entry of largest
/// magnitude is positive.
///
/// # Errors
/// [`RefineError`].
pub fn refine(views: &[View], initial: &Cylinder, options: &RefineOptions) -> Result<Refinement, RefineError> {
    let lines = IndependentLines::of(views);
    if lines.given() >= 3 && is_single_viewpoint(views) {
        return Err(RefineError::NotDetermined);
    }
    refine_lines(&options.metric.measured(&lines)?, initial, options.loss)
}

/// Refines a cylinder on the given lines.
pub(crate) fn refine_lines(lines: &[MeasuredLine], initial: &Cylinder, loss: Loss) -> Result<Refinement, RefineError> {
    let Optimised { cylinder, iterations, converged } = optimise(lines, initial, loss, STEPS)?;
    if !converged {
        return Err(RefineError::NotConverged { iterations });
    }
    // The covariance refers to the direction with its final sign.
    let cylinder = cylinder.with_canonical_sign();
    // The frame is that of the result, because its position refers to the part of its own axis that
    // the lines see.
    let frame = Frame::of(&cylinder, lines)?;
    let (cost, local) = (SilhouetteCost::new(Observed::lines(lines), &frame, loss), frame.local(&cylinder));
    let block = Block { cost: &cost, cylinder: &local, places: [0, 1, 2, 3, 4].map(Some) };
    let uncertainty = Uncertainty::of(std::slice::from_ref(&block), 5)?;
    Ok(Refinement::new((&cylinder, &frame), lines, &block, &uncertainty, iterations))
}

impl Refinement {
    /// The numbers of a cylinder at the optimum in its frame.
    pub(super) fn new(
        (cylinder, frame): (&Cylinder, &Frame),
        lines: &[MeasuredLine],
        block: &Block<'_>,
        uncertainty: &Uncertainty,
        iterations: usize,
    ) -> Self {
        // Positions and radius to world units.
        let unit = frame.unit;
        let scale = Matrix5::from_diagonal(&Vector5::new(1.0, 1.0, unit, unit, unit));
        let covariance = scale * block.part(&uncertainty.covariance) * scale;
        let deviation = |from: usize, to: usize| (from..to).map(|index| covariance[(index, index)]).sum::<f64>().sqrt();
        let square: f64 =
            lines.iter().filter_map(|line| line.distance(cylinder)).map(|distance| distance.mean_square()).sum();
        Self {
            cylinder: *cylinder,
            reference: frame.origin + cylinder.vector_to_axis(&frame.origin),
            across: across(&cylinder.direction),
            covariance,
            deviation: Deviation { direction: deviation(0, 2), position: deviation(2, 4), radius: deviation(4, 5) },
            rms: (square / lines.len() as f64).sqrt(),
            noise: uncertainty.noise,
            degrees_of_freedom: uncertainty.degrees_of_freedom,
            iterations,
        }
    }
}

/// The state in which Levenberg-Marquardt ended.
pub(crate) struct Optimised {
    pub(crate) cylinder: Cylinder,
    pub(crate) iterations: usize,
    pub(crate) converged: bool,
}

/// Whether the refinement can start.
pub(super) fn check(lines: &[MeasuredLine], initial: &Cylinder, loss: Loss) -> Result<(), RefineError> {
    loss.check()?;
    if lines.len() < 3 {
        return Err(RefineError::TooFewLines { lines: lines.len() });
    }
    let Cylinder { axis_point, direction, radius } = initial;
    let finite = axis_point.iter().chain(direction.iter()).chain([radius]).all(|entry| entry.is_finite());
    match finite && *radius > 0.0 {
        true => Ok(()),
        false => Err(RefineError::NotACylinder),
    }
}

/// The optimum, or the cylinder that is reached after `limit` steps.
pub(crate) fn optimise(
    lines: &[MeasuredLine],
    initial: &Cylinder,
    loss: Loss,
    limit: usize,
) -> Result<Optimised, RefineError> {
    check(lines, initial, loss)?;
    let frame = Frame::of(initial, lines)?;
    let cost = SilhouetteCost::new(Observed::lines(lines), &frame, loss);
    let optimum = minimise(&cost, frame.local(initial), limit)?;
    if optimum.state.radius <= NO_RADIUS {
        return Err(RefineError::NoRadius);
    }
    let cylinder = frame.world(&optimum.state);
    Ok(Optimised { cylinder, iterations: optimum.iterations, converged: optimum.converged })
}
