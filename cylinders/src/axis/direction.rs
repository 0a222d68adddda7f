//! Step 1: the direction of the axis.
//!
//! A viewing plane that is tangent to the cylinder is parallel to its axis, so its normal
//! `n_i = R^T l_i` is orthogonal to the direction `w`. All normals together give a homogeneous
//! linear system
//!
//! ```text
//!       [ n_1^T ]
//!       [  ...  ] w = 0,     sigma_1 >= sigma_2 >= sigma_3 its singular values
//!       [ n_N^T ]
//! ```
//!
//! whose least squares solution of unit length is the right singular vector of `sigma_3`.

use nalgebra::{DMatrix, Unit, Vector3};
use thiserror::Error;

use crate::numerics::interrupt::Interrupted;
use crate::numerics::ransac::RansacOptionsError;
use crate::observations::view::ViewingPlane;

/// All planes count as parallel if `sigma_2 / sigma_1` is at most this. The ratio is about the
/// angle between the planes: a thousandth of a pixel in an image of some thousand pixels.
const PARALLEL_PLANES: f64 = 1e-6;

/// Limit on the iterations of the singular value decomposition. Three columns need about ten.
const SVD_ITERATIONS: usize = 500;

/// Direction of the axis and how well the planes determine it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Direction {
    /// Unit direction `w` in the world frame; its entry of largest magnitude is positive.
    pub direction: Unit<Vector3<f64>>,
    /// Singular values of the stacked unit normals, descending. `sigma_3 / sigma_2` is about the
    /// uncertainty of `w`, radians.
    pub singular_values: [f64; 3],
}

/// The direction that several parallel cylinders have in common.
#[derive(Clone, Debug, PartialEq)]
pub struct SharedDirection {
    /// Least squares direction of the planes of all cylinders.
    pub direction: Direction,
    /// Root mean square angle between the direction and the planes of each cylinder, radians (its
    /// sine). If one is much larger than the others, its cylinder is not parallel to theirs.
    pub deviations: Vec<f64>,
}

/// Why the planes determine no direction.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum DirectionError {
    /// All viewing planes are parallel, and any direction in them fits.
    #[error(
        "all viewing planes are parallel (singular values {0:.3e}, {1:.3e}, {2:.3e}): they do not determine the axis direction; \
         add a view from another side",
        singular_values[0], singular_values[1], singular_values[2]
    )]
    ParallelPlanes {
        /// Singular values, descending.
        singular_values: [f64; 3],
    },
    /// No direction lies in all planes, or the noise is too large: `sigma_3 > sigma_2 / 2`.
    #[error(
        "the viewing planes have no direction in common (singular values {0:.3e}, {1:.3e}, {2:.3e}): the lines are not \
         silhouettes of one cylinder, or too noisy for this number of views",
        singular_values[0], singular_values[1], singular_values[2]
    )]
    NoCommonDirection {
        /// Singular values, descending.
        singular_values: [f64; 3],
    },
    /// Fewer than three planes, or a singular value decomposition that did not converge.
    #[error("the singular values of the {planes} viewing planes could not be computed")]
    NoDecomposition {
        /// Number of planes.
        planes: usize,
    },
    /// RANSAC found no direction in which three planes agree.
    #[error(
        "{inliers} of {planes} viewing planes agree on an axis direction, but three are needed: pass more lines, or a \
         larger threshold"
    )]
    NoConsensus {
        /// Number of planes that agree with the best direction.
        inliers: usize,
        /// Number of planes.
        planes: usize,
    },
    /// An option of RANSAC is out of range.
    #[error(transparent)]
    Options(#[from] RansacOptionsError),
    /// RANSAC was interrupted.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
}

/// Least squares direction of the axis from at least three tangent planes.
///
/// # Errors
/// [`DirectionError`]. A direction is also refused if `sigma_2 - sigma_3 < sigma_3`: perturbations
/// of the size seen in the data (`sigma_3`) can then turn the singular vector by any angle (Wedin's
/// bound, perturbation over gap).
pub fn estimate_direction(planes: &[ViewingPlane]) -> Result<Direction, DirectionError> {
    let failure = DirectionError::NoDecomposition { planes: planes.len() };
    if planes.len() < 3 {
        return Err(failure);
    }
    let normals = DMatrix::from_fn(planes.len(), 3, |row, column| planes[row].normal[column]);
    let svd = normals.try_svd(false, true, f64::EPSILON, SVD_ITERATIONS).ok_or(failure)?;
    let (Some(right), [first, second, third]) = (&svd.v_t, svd.singular_values.as_slice()) else {
        return Err(failure);
    };
    let singular_values = [*first, *second, *third];
    // This is also true if a singular value is NaN.
    let spans_a_plane = *second > PARALLEL_PLANES * first;
    if !spans_a_plane {
        return Err(DirectionError::ParallelPlanes { singular_values });
    }
    if *third > second / 2.0 {
        return Err(DirectionError::NoCommonDirection { singular_values });
    }
    let direction = Vector3::new(right[(2, 0)], right[(2, 1)], right[(2, 2)]);
    let sign = direction[direction.iamax()].signum();
    Ok(Direction { direction: Unit::new_normalize(direction * sign), singular_values })
}

/// Least squares direction of several parallel cylinders, given one list of planes for each. The
/// normals of all cylinders together can determine the direction if those of one cylinder do not,
/// for example with a single view of each. Planes without labels need no lists: pass all of them to
/// [`estimate_direction`], or to
/// [`estimate_direction_robustly`](super::robust_direction::estimate_direction_robustly) if some
/// are wrong.
///
/// # Errors
/// As [`estimate_direction`].
pub fn estimate_shared_direction(cylinders: &[Vec<ViewingPlane>]) -> Result<SharedDirection, DirectionError> {
    let direction = estimate_direction(&cylinders.concat())?;
    let deviation = |planes: &Vec<ViewingPlane>| {
        let sum: f64 = planes.iter().map(|plane| plane.normal.dot(&direction.direction).powi(2)).sum();
        // An empty list has deviation zero.
        (sum / planes.len().max(1) as f64).sqrt()
    };
    Ok(SharedDirection { direction, deviations: cylinders.iter().map(deviation).collect() })
}
