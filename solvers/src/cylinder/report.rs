//! A triangulation as text for people and as JSON for programs.

use std::fmt;

use nalgebra::Point3;
use serde::Serialize;

use super::cylinder::{Cylinder, LineResidual, NEAR_SURFACE, Side};
use super::scene::{CylinderLines, LineId};
use super::triangulate::Triangulation;
use super::view::View;

/// The result in plain numbers, in the form in which it is written as JSON.
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
    /// Singular values of the linear system for the direction, descending.
    pub singular_values: [f64; 3],
    /// Root mean square distance between lines and circle in the cross-section, world units.
    pub rms: f64,
    /// Number of real stationary points of the least squares problem.
    pub stationary_points: usize,
    /// One for each line.
    pub residuals: Vec<ResidualReport>,
    /// Number of scene points and of those near the surface; absent when the scene has none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub points: Option<PointReport>,
}

/// Residual of one line.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ResidualReport {
    /// Name of the image; absent when it has none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub image: Option<String>,
    /// Index of the view in the scene, from 0.
    pub view: usize,
    /// Index of the line in its view, from 0.
    pub line: usize,
    /// Side of the silhouette that is nearest to the line, the direction of the axis pointing up.
    pub side: Side,
    /// Distance of the axis from the viewing plane minus the radius, world units.
    pub distance: f64,
    /// Angle between the viewing plane and the nearest tangent plane, radians.
    pub angle: f64,
    /// Distance in pixels; null without calibration.
    pub pixels: Option<f64>,
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
    /// Gathers the numbers of the result for these lines; `points` are those of the scene.
    pub fn new(lines: &CylinderLines, result: &Triangulation, points: &[Point3<f64>]) -> Self {
        let cylinder = &result.cylinder;
        let residual = |(id, residual): (&LineId, &LineResidual)| {
            ResidualReport::new(&lines.views[id.view], &LineResidual { view: id.view, line: id.line, ..*residual })
        };
        let residuals = lines.lines.iter().zip(&result.residuals).map(residual);
        Self {
            label: lines.label.clone(),
            axis_point: cylinder.axis_point.coords.into(),
            direction: cylinder.direction.into_inner().into(),
            radius: cylinder.radius,
            singular_values: result.direction.singular_values,
            rms: result.fit.rms,
            stationary_points: result.fit.stationary_points,
            residuals: residuals.collect(),
            points: (!points.is_empty()).then(|| PointReport::new(cylinder, points)),
        }
    }
}

/// For people: seven significant digits.
impl fmt::Display for Report {
    fn fmt(&self, text: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [sigma1, sigma2, sigma3] = self.singular_values;
        let triple = |[x, y, z]: [f64; 3]| format!("{x:14.7}{y:14.7}{z:14.7}");
        if let Some(label) = &self.label {
            writeln!(text, "cylinder         {label:>14}")?;
        }
        writeln!(text, "axis point       {}   nearest to the origin", triple(self.axis_point))?;
        writeln!(text, "direction        {}", triple(self.direction))?;
        writeln!(text, "radius           {:14.7}", self.radius)?;
        writeln!(text, "singular values  {sigma1:14.6e}{sigma2:14.6e}{sigma3:14.6e}   of the direction")?;
        writeln!(text, "rms distance     {:14.6e}   best of {} stationary points", self.rms, self.stationary_points)?;
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
    /// Heading of a table of which each residual is a row.
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
        }
    }
}

/// A row of a table.
impl fmt::Display for ResidualReport {
    fn fmt(&self, text: &mut fmt::Formatter<'_>) -> fmt::Result {
        let pixels = self.pixels.map_or("-".to_owned(), |pixels| format!("{pixels:.3}"));
        let image = self.image.as_ref().map_or(String::new(), |image| format!("   {image}"));
        let (side, degrees) = (self.side.to_string(), self.angle.to_degrees());
        write!(text, "{:4}{:6}{side:>7}{:14.4e}{degrees:16.6}{pixels:>11}{image}", self.view, self.line, self.distance)
    }
}

impl PointReport {
    fn new(cylinder: &Cylinder, points: &[Point3<f64>]) -> Self {
        Self { total: points.len(), near_surface: points.iter().filter(|point| cylinder.is_near(point)).count() }
    }
}
