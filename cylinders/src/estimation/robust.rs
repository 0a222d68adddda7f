//! The cylinder on which most lines agree if many of them are not its silhouettes: RANSAC around
//! the minimal solver, then refinement.
//!
//! ```text
//!   3 lines --> direction, unless known --> 3 tangent lines --> up to 4 circles --> cylinders
//! ```
//!
//! Two planes determine the direction, and the third improves it. Three lines give six numbers for
//! the five parameters of a cylinder, so a sample whose own lines do not agree is rejected before
//! other lines are tested. A line agrees with a cylinder if its distance from the silhouette is
//! within the threshold and the point of contact lies in front of the camera. This test chooses
//! among the four circles.

use nalgebra::{Unit, Vector3};
use thiserror::Error;

use super::refine::{Loss, RefineError, Refinement, optimise, refine_lines};
use super::triangulate::{fit_cylinder, identified_planes};
use crate::axis::direction::estimate_direction;
use crate::axis::robust_direction::PARALLEL_PAIR;
use crate::cross_section::closed_form::tangent_circles;
use crate::cross_section::rectify::Rectification;
use crate::numerics::ransac::{Estimator, RansacOptions, RansacOptionsError, ransac};
use crate::observations::scene::LineId;
use crate::observations::view::{View, ViewingPlane};
use crate::space::cylinder::{Cylinder, LineResidual};
use crate::space::silhouette_distance::{DistanceUnit, MeasuredLine, Metric, MetricError};

/// Default of the largest distance between a line and its silhouette: an end point that is off by a
/// pixel may reach it.
const THRESHOLD_PIXELS: f64 = 3.0;

/// Default of the same distance in radians: three pixels at a focal length of 3000.
const THRESHOLD_RADIANS: f64 = 1e-3;

/// Steps of Levenberg-Marquardt in a local optimisation.
const LOCAL_STEPS: usize = 5;

/// Limit on the repetitions of final refinement and choice of inliers. They agree after one or two.
const REPETITIONS: usize = 10;

/// Options of the robust estimation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RobustOptions {
    /// How distances between lines and silhouettes are measured.
    pub metric: Metric,
    /// Options of RANSAC. The threshold is the largest root mean square distance of an inlier, in
    /// the unit of the metric.
    pub ransac: RansacOptions,
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
}

/// Why no cylinder was found.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum RobustError {
    /// There are too few lines: a fourth one is needed to choose among the cylinders that touch
    /// three.
    #[error(
        "{lines} line(s) given; a robust estimate samples three of them and needs others to agree: pass at least four \
         lines from two views, better two silhouettes from each of three views; without wrong lines, use plain \
         triangulation"
    )]
    TooFewLines {
        /// Number of lines.
        lines: usize,
    },
    /// An option of RANSAC is out of range.
    #[error(transparent)]
    Options(#[from] RansacOptionsError),
    /// Distances cannot be measured.
    #[error(transparent)]
    Metric(#[from] MetricError),
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

impl RobustOptions {
    /// Pixels and a threshold of 3 if all cameras have a calibration, radians and a threshold of
    /// 0.001 otherwise.
    pub fn of(views: &[View]) -> Self {
        let metric = Metric::of(views);
        let threshold = match metric.unit {
            DistanceUnit::Pixels => THRESHOLD_PIXELS,
            DistanceUnit::Radians => THRESHOLD_RADIANS,
        };
        Self { metric, ransac: RansacOptions::with_threshold(threshold), direction: None }
    }
}

/// The cylinder on which most lines agree, whatever the other lines are.
///
/// # Errors
/// [`RobustError`].
pub fn triangulate_robustly(views: &[View], options: &RobustOptions) -> Result<RobustTriangulation, RobustError> {
    options.ransac.check()?;
    let planes = identified_planes(views);
    let lines = planes.len();
    if lines < 4 {
        return Err(RobustError::TooFewLines { lines });
    }
    let measured = options.metric.measured_lines(views)?;
    let square_threshold = options.ransac.threshold.powi(2);
    let estimator = CylinderEstimator { planes, measured, direction: options.direction, square_threshold };
    let no_consensus = |inliers, samples| RobustError::NoConsensus { inliers, lines, samples };
    let consensus = ransac(&estimator, &options.ransac).ok_or(no_consensus(0, options.ransac.max_samples))?;
    let samples = consensus.samples;
    if consensus.inliers.len() < 4 {
        return Err(no_consensus(consensus.inliers.len(), samples));
    }

    let mut inliers = consensus.inliers;
    let refined = |inliers: &[usize], start: &Cylinder| {
        let failure = |error| RobustError::Refine { inliers: inliers.len(), lines, error };
        refine_lines(&estimator.measured(inliers), start, Loss::Quadratic).map_err(failure)
    };
    let mut refinement = refined(&inliers, &consensus.model)?;
    for _ in 0..REPETITIONS {
        let agreeing = estimator.inliers(&refinement.cylinder);
        if agreeing == inliers || agreeing.len() < 4 {
            break;
        }
        refinement = refined(&agreeing, &refinement.cylinder)?;
        inliers = agreeing;
    }

    let mut residuals = Vec::with_capacity(lines);
    for (view, content) in views.iter().enumerate().filter(|(_, content)| !content.lines().is_empty()) {
        let inside = RobustError::CameraInside { view };
        residuals.extend(refinement.cylinder.residuals(view, content).ok_or(inside)?);
    }
    let inliers = inliers.into_iter().map(|index| estimator.planes[index].0).collect();
    Ok(RobustTriangulation { refinement, inliers, residuals, samples })
}

struct CylinderEstimator {
    planes: Vec<(LineId, ViewingPlane)>,
    measured: Vec<MeasuredLine>,
    direction: Option<Unit<Vector3<f64>>>,
    square_threshold: f64,
}

impl CylinderEstimator {
    fn measured(&self, data: &[usize]) -> Vec<MeasuredLine> {
        data.iter().map(|&index| self.measured[index]).collect()
    }

    /// Whether all lines of a sample agree with a cylinder.
    fn agree(&self, cylinder: &Cylinder, sample: &[usize]) -> bool {
        let square = |&datum: &usize| Some(self.measured[datum].square(&self.measured[datum].silhouettes(cylinder)?));
        sample.iter().all(|datum| square(datum).is_some_and(|square| square < self.square_threshold))
    }

    fn inliers(&self, cylinder: &Cylinder) -> Vec<usize> {
        let mut squares = vec![0.0; self.count()];
        self.write_squares(cylinder, &mut squares);
        (0..squares.len()).filter(|&datum| squares[datum] < self.square_threshold).collect()
    }

    /// The known direction, or the least squares direction of the three planes of the sample. The
    /// latter is one step of inverse iteration from the direction of the two planes that are
    /// furthest from parallel; its error is of the square of the noise. Up to scale, the inverse of
    /// `N^T N` is the sum of `c c^T` over the cross products `c` of its rows (Cauchy-Binet).
    fn direction(&self, sample: &[usize]) -> Option<Unit<Vector3<f64>>> {
        if self.direction.is_some() {
            return self.direction;
        }
        let normal = |index: usize| &self.planes[sample[index]].1.normal;
        let crosses = [[0, 1], [0, 2], [1, 2]].map(|[first, second]| normal(first).cross(normal(second)));
        let mut widest = crosses[0];
        for cross in &crosses[1..] {
            if cross.norm_squared() > widest.norm_squared() {
                widest = *cross;
            }
        }
        let widest = Unit::try_new(widest, PARALLEL_PAIR)?;
        Unit::try_new(crosses.iter().map(|cross| cross * cross.dot(&widest)).sum(), 0.0)
    }
}

impl Estimator for CylinderEstimator {
    type Model = Cylinder;
    const SAMPLE: usize = 3;

    fn count(&self) -> usize {
        self.planes.len()
    }

    fn models(&self, sample: &[usize]) -> Vec<Cylinder> {
        let cylinders = || {
            let direction = self.direction(sample)?;
            let rectification = Rectification::new(&direction, self.planes[sample[0]].1.centre);
            let line = |index: usize| rectification.line(&self.planes[sample[index]].1);
            let circles = tangent_circles(&[line(0)?, line(1)?, line(2)?]).ok()?;
            let cylinder = |circle| Cylinder::from_circle(&circle, &rectification, direction);
            Some(circles.into_iter().map(cylinder).filter(|cylinder| self.agree(cylinder, sample)).collect())
        };
        cylinders().unwrap_or_default()
    }

    /// The silhouettes of a view are computed once for all its lines.
    fn write_squares(&self, cylinder: &Cylinder, squares: &mut [f64]) {
        let mut squares = squares.iter_mut();
        for of_view in self.measured.chunk_by(|a, b| a.view == b.view) {
            let silhouettes = of_view[0].silhouettes(cylinder);
            for (line, square) in of_view.iter().zip(&mut squares) {
                *square = silhouettes.as_ref().map_or(f64::INFINITY, |silhouettes| line.square(silhouettes));
            }
        }
    }

    /// Constrained least squares, followed by a few steps on the silhouette distance.
    fn fitted(&self, model: &Cylinder, data: &[usize]) -> Option<Cylinder> {
        let identified: Vec<_> = data.iter().map(|&index| self.planes[index]).collect();
        let planes: Vec<_> = identified.iter().map(|&(_, plane)| plane).collect();
        if let Some(direction) = self.direction {
            return fit_cylinder(&identified, &direction).ok().map(|(cylinder, _)| cylinder);
        }
        let direct =
            estimate_direction(&planes).ok().and_then(|direction| fit_cylinder(&identified, &direction.direction).ok());
        let start = direct.map_or(*model, |(cylinder, _)| cylinder);
        optimise(&self.measured(data), &start, Loss::Quadratic, LOCAL_STEPS).ok().map(|optimised| optimised.cylinder)
    }
}
