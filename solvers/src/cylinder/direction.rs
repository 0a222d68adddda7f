//! Step 1: the direction of the axis.
//!
//! A viewing plane that is tangent to the cylinder is parallel to its axis, so its normal `n_i = R^T l_i` is orthogonal
//! to the direction `w`. All of them together are a homogeneous linear system
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

use super::view::ViewingPlane;

/// `sigma_2 / sigma_1` at and below which all planes count as parallel. The ratio is about the angle between the planes:
/// a thousandth of a pixel in an image of some thousand pixels.
const PARALLEL_PLANES: f64 = 1e-6;

/// Iterations that the singular value decomposition may take; three columns need about ten.
const SVD_ITERATIONS: usize = 500;

/// Direction of the axis and how well the planes determine it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Direction {
    /// Unit direction `w` in the world frame; its entry of largest magnitude is positive.
    pub direction: Unit<Vector3<f64>>,
    /// Singular values of the stacked unit normals, descending. `sigma_3 / sigma_2` is about the angle (radians) by
    /// which `w` is uncertain.
    pub singular_values: [f64; 3],
}

/// Why the planes determine no direction.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum DirectionError {
    /// All viewing planes are parallel: any direction in them would do.
    #[error(
        "all viewing planes are parallel (singular values {0:.3e}, {1:.3e}, {2:.3e}): they leave the axis direction open; \
         add a view from another side",
        singular_values[0], singular_values[1], singular_values[2]
    )]
    ParallelPlanes {
        /// Singular values, descending.
        singular_values: [f64; 3],
    },
    /// No direction lies in all planes, or noise drowns it: `sigma_3 > sigma_2 / 2`.
    #[error(
        "the viewing planes have no direction in common (singular values {0:.3e}, {1:.3e}, {2:.3e}): the lines are not \
         silhouettes of one cylinder, or too noisy for so few views",
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
}

/// Least squares direction of the axis from at least three tangent planes.
///
/// # Errors
/// [`DirectionError`]. A direction is also refused when `sigma_2 - sigma_3 < sigma_3`: perturbations of the size seen
/// in the data (`sigma_3`) can then turn the singular vector by any angle (Wedin's bound, perturbation over gap).
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
    // Also where a singular value is NaN.
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
