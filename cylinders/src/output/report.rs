//! A triangulation as text for people and as JSON for programs.

use std::fmt;

use nalgebra::Point3;
use serde::Serialize;

use crate::estimation::estimate::{Estimate, EstimateConsensus};
use crate::observations::scene::{CylinderLines, LineId};
use crate::observations::view::View;
use crate::space::cylinder::{Cylinder, LineResidual, NEAR_SURFACE, Side};
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
    /// Root mean square distance between lines and circle in the cross-section, world units.
    pub rms: f64,
    /// Number of real stationary points of the least squares problem.
    pub stationary_points: usize,
}

/// Result of the refinement.
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
    /// Root mean square distance of the lines from their silhouettes; of the inliers only, if
    /// RANSAC was used.
    pub rms: f64,
    /// Unit of that distance, `pixels` or `radians`.
    pub unit: DistanceUnit,
}

/// What RANSAC chose.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ConsensusReport {
    /// Number of lines that agree with the cylinder.
    pub inliers: usize,
    /// Number of lines.
    pub lines: usize,
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
}

impl Report {
    /// Collects the numbers of the estimate for these lines. `points` are the points of the scene.
    pub fn new(lines: &CylinderLines, estimate: &Estimate, points: &[Point3<f64>]) -> Self {
        let Estimate { cylinder, residuals, least_squares, refinement, consensus } = estimate;
        let residual = |(id, residual): (&LineId, &LineResidual)| {
            let place = LineId { view: residual.view, line: residual.line };
            let in_scene = LineResidual { view: id.view, line: id.line, ..*residual };
            let inlier = consensus.as_ref().map(|consensus| consensus.inliers.contains(&place));
            ResidualReport { inlier, ..ResidualReport::new(&lines.views[id.view], &in_scene) }
        };
        Self {
            label: lines.label.clone(),
            axis_point: cylinder.axis_point.coords.into(),
            direction: cylinder.direction.into_inner().into(),
            radius: cylinder.radius,
            least_squares: least_squares.map(|(direction, fit)| LeastSquaresReport {
                singular_values: direction.singular_values,
                rms: fit.rms,
                stationary_points: fit.stationary_points,
            }),
            refinement: refinement.as_ref().map(|(refinement, unit)| RefinementReport {
                direction_deviation: refinement.deviation.direction,
                position_deviation: refinement.deviation.position,
                radius_deviation: refinement.deviation.radius,
                reference: refinement.reference.coords.into(),
                rms: refinement.rms,
                unit: *unit,
            }),
            consensus: consensus.as_ref().map(|EstimateConsensus { inliers, samples }| ConsensusReport {
                inliers: inliers.len(),
                lines: residuals.len(),
                samples: *samples,
            }),
            residuals: lines.lines.iter().zip(residuals).map(residual).collect(),
            points: (!points.is_empty()).then(|| PointReport::new(cylinder, points)),
        }
    }
}

/// Text for people, with seven significant digits.
impl fmt::Display for Report {
    fn fmt(&self, text: &mut fmt::Formatter<'_>) -> fmt::Result {
        let triple = |[x, y, z]: [f64; 3]| format!("{x:14.7}{y:14.7}{z:14.7}");
        if let Some(label) = &self.label {
            writeln!(text, "cylinder         {label:>14}")?;
        }
        writeln!(text, "axis point       {}   nearest to the origin", triple(self.axis_point))?;
        writeln!(text, "direction        {}", triple(self.direction))?;
        writeln!(text, "radius           {:14.7}", self.radius)?;
        if let Some(LeastSquaresReport { singular_values: [sigma1, sigma2, sigma3], rms, stationary_points }) =
            &self.least_squares
        {
            writeln!(text, "singular values  {sigma1:14.6e}{sigma2:14.6e}{sigma3:14.6e}   of the direction")?;
            writeln!(text, "rms distance     {rms:14.6e}   best of {stationary_points} stationary points")?;
        }
        if let Some(refined) = &self.refinement {
            let [direction, position, radius] =
                [refined.direction_deviation, refined.position_deviation, refined.radius_deviation];
            writeln!(
                text,
                "refined          {:14.6e}   {}, rms distance of lines and silhouettes",
                refined.rms, refined.unit
            )?;
            writeln!(
                text,
                "deviations       {direction:14.6e}{position:14.6e}{radius:14.6e}   direction [rad], axis, radius"
            )?;
            writeln!(text, "at               {}   point of the axis", triple(refined.reference))?;
        }
        if let Some(ConsensusReport { inliers, lines, samples }) = &self.consensus {
            writeln!(text, "inliers          {inliers:>14}   of {lines} lines, {samples} samples")?;
        }
        if let Some(points) = &self.points {
            let percent = 100.0 * NEAR_SURFACE;
            writeln!(
                text,
                "points           {} of {} within {percent}% of the radius from the surface",
                points.near_surface, points.total
            )?;
        }
        writeln!(text, "\n{}", ResidualReport::HEADING)?;
        self.residuals.iter().try_for_each(|residual| writeln!(text, "{residual}"))
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

/// A row of a table.
impl fmt::Display for ResidualReport {
    fn fmt(&self, text: &mut fmt::Formatter<'_>) -> fmt::Result {
        let pixels = self.pixels.map_or("-".to_owned(), |pixels| format!("{pixels:.3}"));
        let image = self.image.as_ref().map_or(String::new(), |image| format!("   {image}"));
        let outlier = if self.inlier == Some(false) { "   outlier" } else { "" };
        let (side, degrees) = (self.side.to_string(), self.angle.to_degrees());
        write!(text, "{:4}{:6}{side:>7}{:14.4e}", self.view, self.line, self.distance)?;
        write!(text, "{degrees:16.6}{pixels:>11}{image}{outlier}")
    }
}

impl PointReport {
    fn new(cylinder: &Cylinder, points: &[Point3<f64>]) -> Self {
        Self { total: points.len(), near_surface: points.iter().filter(|point| cylinder.is_near(point)).count() }
    }
}
