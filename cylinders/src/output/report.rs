//! A triangulation as plain numbers, in the form of the JSON output.

use nalgebra::Point3;
use serde::Serialize;

use crate::axis::direction::Direction;
use crate::cross_section::circle::CircleFit;
use crate::estimation::alternatives::Alternative;
use crate::estimation::estimate::{Estimate, SurfacePoints};
use crate::estimation::refine::Refinement;
use crate::observations::scene::{CylinderLines, LineId};
use crate::observations::view::View;
use crate::space::cylinder::{LineResidual, Side};
use crate::space::extent::visible_extent;
use crate::space::silhouette_distance::DistanceUnit;

/// The result as plain numbers in the form of the JSON output.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// Label of the cylinder; absent for lines without label.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub label: Option<String>,
    /// Point of the axis nearest to the world's origin.
    pub axis_point: [f64; 3],
    /// Unit direction of the axis.
    pub direction: [f64; 3],
    /// Radius, world units.
    pub radius: f64,
    /// The part of the axis that the views show: signed distances from the axis point along the
    /// direction, world units. Null if nothing determines it.
    pub extent: Option<[f64; 2]>,
    /// Number of lines of which none is a copy of another.
    pub independent_lines: usize,
    /// Whether other cylinders explain the lines about as well.
    pub ambiguous: bool,
    /// All cylinders that explain the lines about as well, the best first, and after them one on
    /// which nearly as many other lines agree; absent if the result is not ambiguous.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub plausible: Vec<PlausibleReport>,
    /// What makes the result doubtful, in words.
    pub warnings: Vec<String>,
    /// Quality of the least squares estimate; absent if there was none.
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub least_squares: Option<LeastSquaresReport>,
    /// Uncertainty; absent without refinement.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub refinement: Option<RefinementReport>,
    /// What RANSAC chose; absent without it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub consensus: Option<ConsensusReport>,
    /// One entry for each line.
    pub residuals: Vec<ResidualReport>,
    /// Number of scene points and of points near the surface; absent if the scene has no points.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub points: Option<PointReport>,
}

/// How well least squares determined and fitted the cylinder.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct LeastSquaresReport {
    /// Singular values of the linear system for the direction, descending.
    pub singular_values: [f64; 3],
    /// Root mean square distance between lines and circle in the cross-section, world units. Least
    /// squares make it small; it is not comparable with distances in the images.
    pub section_rms: f64,
    /// Number of real stationary points of the least squares problem.
    pub stationary_points: usize,
}

/// A cylinder that explains the lines about as well as the best.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct PlausibleReport {
    /// Point of the axis nearest to the world's origin.
    pub axis_point: [f64; 3],
    /// Unit direction of the axis.
    pub direction: [f64; 3],
    /// Radius, world units.
    pub radius: f64,
    /// Root mean square distance of the lines from its silhouettes: pixels if all cameras have a
    /// calibration, radians otherwise.
    pub image_rms: f64,
    /// Its likelihood relative to the best.
    pub plausibility: f64,
}

/// Result of the refinement. Of all lines, or with RANSAC of the inliers; copies of a line count
/// once.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct RefinementReport {
    /// Standard deviation of the direction, radians.
    pub direction_deviation: f64,
    /// Standard deviation of the axis at the reference point, world units.
    pub position_deviation: f64,
    /// Standard deviation of the radius, world units.
    pub radius_deviation: f64,
    /// The point of the axis to which the deviation of the position refers.
    pub reference: [f64; 3],
    /// Unit vectors `f1`, `f2` across the axis.
    pub across: [[f64; 3]; 2],
    /// Covariance of the components of the direction along `f1`, `f2` (radians), of the axis at the
    /// reference along `f1`, `f2`, and of the radius (world units).
    pub covariance: [[f64; 5]; 5],
    /// Root mean square distance of the lines from their silhouettes in the images.
    pub image_rms: f64,
    /// Estimated standard deviation of that distance: larger than `image_rms`, because the cylinder
    /// adapts to the noise of the lines.
    pub noise: f64,
    /// Degrees of freedom of that estimate.
    pub degrees_of_freedom: f64,
    /// Unit of both, `pixels` or `radians`.
    pub unit: DistanceUnit,
    /// Number of lines without end points. It is not known where they were seen: their distances
    /// are measured at two points a fifth of the focal length apart, and if there are any, the
    /// deviations follow from the scatter of the lines instead of one noise of all points.
    pub lines_without_ends: usize,
}

/// What RANSAC chose.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ConsensusReport {
    /// Number of lines that agree with the cylinder.
    pub inliers: usize,
    /// Number of lines.
    pub lines: usize,
    /// Number of lines that agree, copies counted once.
    pub independent_inliers: usize,
    /// Largest root mean square distance of a line that agrees, unit of the refinement.
    pub threshold: f64,
    /// Expected number of cylinders on which as many lines agree by chance (an upper bound).
    pub false_alarms: f64,
    /// Number of samples drawn.
    pub samples: usize,
}

/// Residual of one line.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ResidualReport {
    /// Name of the image; absent if it has none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub image: Option<String>,
    /// Index of the view in the scene, from 0.
    pub view: usize,
    /// Index of the line in its view, from 0.
    pub line: usize,
    /// Side of the silhouette that is nearest to the line, if the direction of the axis points up.
    pub side: Side,
    /// Distance of the axis from the viewing plane minus the radius, world units.
    pub distance: f64,
    /// Angle between the viewing plane and the tangent plane of that side, radians.
    pub angle: f64,
    /// Distance in pixels; null without calibration.
    pub pixels: Option<f64>,
    /// Whether the line agrees with the cylinder; absent without RANSAC.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub inlier: Option<bool>,
}

/// Scene points against the surface.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct PointReport {
    /// Number of points.
    pub total: usize,
    /// Number of points within 5 % of the radius from the surface.
    pub near_surface: usize,
    /// What they told; absent if they were not asked.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub evidence: Option<SurfacePoints>,
}

impl Report {
    /// Collects the numbers of the estimate for these lines. `points` are the points of the scene.
    pub fn new(lines: &CylinderLines, estimate: &Estimate, points: &[Point3<f64>]) -> Self {
        let Estimate { cylinder, residuals, consensus, .. } = estimate;
        let residual = |(id, residual): (&LineId, &LineResidual)| {
            let place = LineId { view: residual.view, line: residual.line };
            let in_scene = LineResidual { view: id.view, line: id.line, ..*residual };
            let inlier = consensus.as_ref().map(|consensus| consensus.inliers.contains(&place));
            ResidualReport { inlier, ..ResidualReport::new(&lines.views[id.view], &in_scene) }
        };
        let agreeing = match consensus {
            Some(consensus) => lines.selected(&consensus.inliers),
            None => lines.clone(),
        };
        let plausible = estimate.plausible.as_ref().filter(|plausible| plausible.is_ambiguous());
        let least_squares = |(direction, fit): (Direction, CircleFit)| LeastSquaresReport {
            singular_values: direction.singular_values,
            section_rms: fit.rms,
            stationary_points: fit.stationary_points,
        };
        let refinement = |(refinement, unit): &(Refinement, DistanceUnit)| RefinementReport {
            lines_without_ends: agreeing.views.iter().flat_map(View::ends).filter(|ends| ends.is_none()).count(),
            ..RefinementReport::new(refinement, *unit)
        };
        Self {
            label: lines.label.clone(),
            axis_point: cylinder.axis_point.coords.into(),
            direction: cylinder.direction.into_inner().into(),
            radius: cylinder.radius,
            extent: visible_extent(cylinder, &agreeing.views, points),
            independent_lines: estimate.independent_lines,
            ambiguous: plausible.is_some(),
            plausible: plausible.iter().flat_map(|plausible| &plausible.cylinders).map(PlausibleReport::new).collect(),
            warnings: estimate.warnings.iter().map(|warning| warning.in_scene(lines).to_string()).collect(),
            least_squares: estimate.least_squares.map(least_squares),
            refinement: estimate.refinement.as_ref().map(refinement),
            consensus: consensus.as_ref().map(|consensus| ConsensusReport {
                inliers: consensus.inliers.len(),
                lines: residuals.len(),
                independent_inliers: consensus.independent,
                threshold: consensus.threshold,
                false_alarms: consensus.false_alarms,
                samples: consensus.samples,
            }),
            residuals: lines.lines.iter().zip(residuals).map(residual).collect(),
            points: (!points.is_empty()).then(|| PointReport::new(estimate, points)),
        }
    }
}

impl PlausibleReport {
    fn new(alternative: &Alternative) -> Self {
        Self {
            axis_point: alternative.cylinder.axis_point.coords.into(),
            direction: alternative.cylinder.direction.into_inner().into(),
            radius: alternative.cylinder.radius,
            image_rms: alternative.rms,
            plausibility: alternative.plausibility,
        }
    }
}

impl RefinementReport {
    fn new(refinement: &Refinement, unit: DistanceUnit) -> Self {
        let covariance = &refinement.covariance;
        Self {
            direction_deviation: refinement.deviation.direction,
            position_deviation: refinement.deviation.position,
            radius_deviation: refinement.deviation.radius,
            reference: refinement.reference.coords.into(),
            across: refinement.across.map(Into::into),
            covariance: [0, 1, 2, 3, 4].map(|row| [0, 1, 2, 3, 4].map(|column| covariance[(row, column)])),
            image_rms: refinement.rms,
            noise: refinement.noise,
            degrees_of_freedom: refinement.degrees_of_freedom,
            unit,
            lines_without_ends: 0,
        }
    }
}

impl ResidualReport {
    /// Heading of the table whose rows are residuals.
    pub const HEADING: &str = "view  line   side      distance   angle/degrees     pixels";

    /// The residual of a line of this view.
    pub fn new(view: &View, residual: &LineResidual) -> Self {
        Self {
            image: view.image().map(str::to_owned),
            view: residual.view,
            line: residual.line,
            side: residual.side,
            distance: residual.distance,
            angle: residual.angle,
            pixels: residual.pixels,
            inlier: None,
        }
    }
}

impl PointReport {
    fn new(estimate: &Estimate, points: &[Point3<f64>]) -> Self {
        let near_surface = points.iter().filter(|point| estimate.cylinder.is_near(point)).count();
        Self { total: points.len(), near_surface, evidence: estimate.surface_points }
    }
}
