//! The direction of the axis if many planes are not tangent to the cylinder: RANSAC on pairs of
//! planes.
//!
//! Two tangent planes that are not parallel share one direction, `w ~ n1 x n2`. Cylinders with
//! parallel axes share it too, so their planes need no labels.

use nalgebra::{Unit, Vector3};

use super::direction::{Direction, DirectionError, estimate_direction};
use crate::numerics::ransac::{Estimator, RansacOptions, ransac};
use crate::observations::view::ViewingPlane;

/// Two planes count as parallel if the sine of their angle is at most this. Their common direction
/// would be a thousand times less certain than the planes.
pub(crate) const PARALLEL_PAIR: f64 = 1e-3;

/// Default of the largest angle between axis and plane, radians: two pixels over the length of a
/// line of 200 pixels.
const THRESHOLD: f64 = 0.01;

/// Number of planes after which the cost of a direction is compared.
const PART: usize = 32;

/// A direction and the planes that agree with it.
#[derive(Clone, Debug, PartialEq)]
pub struct RobustDirection {
    /// Least squares direction of the inliers and the singular values of their normals.
    pub direction: Direction,
    /// Indices of the planes within the threshold, ascending.
    pub inliers: Vec<usize>,
    /// Number of samples drawn.
    pub samples: usize,
}

/// Options for [`estimate_direction_robustly`] with a threshold of 0.01 radians.
pub fn default_direction_options() -> RansacOptions<'static> {
    RansacOptions::with_threshold(THRESHOLD)
}

/// The direction that two planes share; `None` if they are parallel.
pub fn common_direction(first: &ViewingPlane, second: &ViewingPlane) -> Option<Unit<Vector3<f64>>> {
    Unit::try_new(first.normal.cross(&second.normal), PARALLEL_PAIR)
}

/// The direction with which most planes agree; the threshold is the largest angle between axis and
/// plane, radians.
///
/// # Errors
/// [`DirectionError::NoConsensus`] if fewer than three planes agree, [`DirectionError::Options`],
/// [`DirectionError::Interrupted`], and the errors of [`estimate_direction`] on the inliers.
pub fn estimate_direction_robustly(
    planes: &[ViewingPlane],
    options: &RansacOptions,
) -> Result<RobustDirection, DirectionError> {
    options.check()?;
    let estimator = DirectionEstimator { planes };
    let failure = |inliers| DirectionError::NoConsensus { inliers, planes: planes.len() };
    let Some(consensus) = ransac(&estimator, options)? else {
        // All pairs are parallel. The error of least squares shows this with the singular values.
        return Err(estimate_direction(planes).err().unwrap_or(failure(0)));
    };
    if consensus.inliers.len() < 3 {
        return Err(failure(consensus.inliers.len()));
    }
    let inliers: Vec<_> = consensus.inliers.iter().map(|&index| planes[index]).collect();
    let direction = estimate_direction(&inliers)?;
    Ok(RobustDirection { direction, inliers: consensus.inliers, samples: consensus.samples })
}

struct DirectionEstimator<'a> {
    planes: &'a [ViewingPlane],
}

impl Estimator for DirectionEstimator<'_> {
    type Model = Unit<Vector3<f64>>;
    const SAMPLE: usize = 2;

    fn count(&self) -> usize {
        self.planes.len()
    }

    fn add_models(&self, sample: &[usize], models: &mut Vec<Self::Model>) {
        models.extend(common_direction(&self.planes[sample[0]], &self.planes[sample[1]]));
    }

    /// Squares of the sines of the angles.
    fn write_squares(&self, direction: &Self::Model, squares: &mut [f64], mut go_on: impl FnMut(&[f64]) -> bool) {
        for (part, planes) in squares.chunks_mut(PART).zip(self.planes.chunks(PART)) {
            part.iter_mut().zip(planes).for_each(|(square, plane)| *square = plane.normal.dot(direction).powi(2));
            if !go_on(part) {
                return;
            }
        }
    }

    fn fitted(&self, _: &Self::Model, data: &[usize]) -> Option<Self::Model> {
        let planes: Vec<_> = data.iter().map(|&index| self.planes[index]).collect();
        estimate_direction(&planes).ok().map(|direction| direction.direction)
    }
}
