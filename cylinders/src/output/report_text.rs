//! A triangulation as text for people.

use std::fmt;

use super::number::{number, triple};
use super::report::{ConsensusReport, LeastSquaresReport, RefinementReport, Report, ResidualReport};
use crate::estimation::estimate::SurfacePoints;
use crate::space::cylinder::NEAR_SURFACE;

/// Text for people, with seven significant digits.
impl fmt::Display for Report {
    fn fmt(&self, text: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(label) = &self.label {
            writeln!(text, "cylinder         {label:>14}")?;
        }
        self.write_cylinder(text)?;
        if let Some(points) = &self.points {
            let percent = 100.0 * NEAR_SURFACE;
            writeln!(
                text,
                "points           {} of {} within {percent}% of the radius from the surface",
                points.near_surface, points.total
            )?;
            match points.evidence {
                Some(SurfacePoints { count: 0.0, .. }) => {
                    writeln!(text, "points used                   0   they do not gather at the surface")?;
                }
                Some(SurfacePoints { count, deviation }) => {
                    writeln!(text, "points used      {count:14.1}   {} from the surface", number(deviation).trim())?;
                }
                None => {}
            }
        }
        for (index, other) in self.plausible.iter().enumerate() {
            let (index, plausibility) = (index + 1, other.plausibility);
            writeln!(text, "\nplausible {index:<6} {}   plausibility {plausibility:.3}", number(other.radius))?;
            writeln!(text, "axis point       {}", triple(other.axis_point))?;
            writeln!(text, "direction        {}", triple(other.direction))?;
            writeln!(text, "image rms        {:14.6e}", other.image_rms)?;
        }
        for warning in &self.warnings {
            writeln!(text, "warning: {warning}")?;
        }
        writeln!(text, "\n{}", ResidualReport::HEADING)?;
        self.residuals.iter().try_for_each(|residual| writeln!(text, "{residual}"))
    }
}

impl Report {
    /// The cylinder and its quality.
    pub(super) fn write_cylinder(&self, text: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(text, "axis point       {}   nearest to the origin", triple(self.axis_point))?;
        writeln!(text, "direction        {}", triple(self.direction))?;
        writeln!(text, "radius           {}", number(self.radius))?;
        if let Some([low, high]) = self.extent {
            writeln!(text, "extent           {}{}   along the axis from the axis point", number(low), number(high))?;
        }
        self.write_quality(text)
    }

    fn write_quality(&self, text: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.independent_lines < self.residuals.len() {
            let lines = self.residuals.len();
            writeln!(
                text,
                "independent      {:>14}   of {lines} lines; the others are copies",
                self.independent_lines
            )?;
        }
        if let Some(LeastSquaresReport { singular_values: [sigma1, sigma2, sigma3], section_rms, stationary_points }) =
            &self.least_squares
        {
            writeln!(text, "singular values  {sigma1:14.6e}{sigma2:14.6e}{sigma3:14.6e}   of the direction")?;
            writeln!(
                text,
                "section rms      {section_rms:14.6e}   world units, lines and circle of least squares; best of \
                 {stationary_points} stationary points"
            )?;
        }
        if let Some(refined) = &self.refinement {
            refined.write(text)?;
        }
        if let Some(ConsensusReport { inliers, lines, samples, threshold, .. }) = &self.consensus {
            writeln!(
                text,
                "inliers          {inliers:>14}   of {lines} lines, within {threshold:.3e}; {samples} samples"
            )?;
        }
        Ok(())
    }
}

impl RefinementReport {
    fn write(&self, text: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { image_rms, noise, unit, degrees_of_freedom, .. } = self;
        writeln!(text, "image rms        {image_rms:14.6e}   {unit}, lines and silhouettes of the refined cylinder")?;
        writeln!(
            text,
            "noise            {noise:14.6e}   {unit}, deviation of an end point; {degrees_of_freedom:.0} degrees of \
             freedom"
        )?;
        let [direction, position, radius] = [self.direction_deviation, self.position_deviation, self.radius_deviation];
        writeln!(
            text,
            "deviations       {direction:14.6e}{position:14.6e}{radius:14.6e}   direction [rad], axis, radius"
        )?;
        writeln!(text, "at               {}   point of the axis", triple(self.reference))?;
        if self.lines_without_ends > 0 {
            writeln!(
                text,
                "note             {} line(s) have no end points: the deviations follow from the scatter of the lines",
                self.lines_without_ends
            )?;
        }
        Ok(())
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
        write!(text, " {degrees:15.6} {pixels:>10}{image}{outlier}")
    }
}
