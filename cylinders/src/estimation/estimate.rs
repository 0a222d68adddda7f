//! A cylinder from any of the estimators, in one form for reports.

use thiserror::Error;

use super::parallel::ParallelError;
use super::refine::{RefineError, RefineOptions, Refinement, refine};
use super::robust::{RobustError, RobustTriangulation};
use super::triangulate::{TriangulateError, Triangulation};
use crate::axis::direction::Direction;
use crate::cross_section::circle::CircleFit;
use crate::observations::scene::LineId;
use crate::observations::view::View;
use crate::space::cylinder::{Cylinder, LineResidual};
use crate::space::silhouette_distance::DistanceUnit;

/// A cylinder and the results of its estimators.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// The cylinder.
    pub cylinder: Cylinder,
    /// One residual for each line, in the order of views and lines.
    pub residuals: Vec<LineResidual>,
    /// Direction and circle of least squares on all lines, if the estimate is theirs or started
    /// from them.
    pub least_squares: Option<(Direction, CircleFit)>,
    /// The refinement and the unit of its distances, if the cylinder was refined.
    pub refinement: Option<(Refinement, DistanceUnit)>,
    /// What RANSAC chose, if it was used.
    pub consensus: Option<EstimateConsensus>,
}

/// What RANSAC chose.
#[derive(Clone, Debug, PartialEq)]
pub struct EstimateConsensus {
    /// The lines that agree with the cylinder.
    pub inliers: Vec<LineId>,
    /// Number of samples drawn.
    pub samples: usize,
}

/// Why there is no cylinder.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum EstimateError {
    /// Least squares found no cylinder.
    #[error(transparent)]
    Triangulate(#[from] TriangulateError),
    /// The cylinders with a shared direction are not determined.
    #[error(transparent)]
    Parallel(#[from] ParallelError),
    /// RANSAC found no cylinder.
    #[error(transparent)]
    Robust(#[from] RobustError),
    /// The cylinder could not be refined.
    #[error(transparent)]
    Refine(#[from] RefineError),
}

impl From<Triangulation> for Estimate {
    fn from(result: Triangulation) -> Self {
        let Triangulation { cylinder, direction, fit, residuals } = result;
        Self { cylinder, residuals, least_squares: Some((direction, fit)), refinement: None, consensus: None }
    }
}

impl Estimate {
    /// The result of RANSAC, with distances in this unit.
    pub fn from_robust(result: RobustTriangulation, unit: DistanceUnit) -> Self {
        let RobustTriangulation { refinement, inliers, residuals, samples } = result;
        Self {
            cylinder: refinement.cylinder,
            residuals,
            least_squares: None,
            refinement: Some((refinement, unit)),
            consensus: Some(EstimateConsensus { inliers, samples }),
        }
    }

    /// The estimate refined on all lines.
    ///
    /// # Errors
    /// [`RefineError`].
    pub fn refined(self, views: &[View], options: &RefineOptions) -> Result<Self, RefineError> {
        let refinement = refine(views, &self.cylinder, options)?;
        let cylinder = refinement.cylinder;
        let mut residuals = Vec::with_capacity(self.residuals.len());
        for (view, content) in views.iter().enumerate().filter(|(_, content)| !content.lines().is_empty()) {
            let inside = RefineError::CameraInside { view };
            residuals.extend(cylinder.residuals(view, content).ok_or(inside)?);
        }
        Ok(Self { cylinder, residuals, refinement: Some((refinement, options.metric.unit)), ..self })
    }
}
