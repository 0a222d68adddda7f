//! Matches as text for people and as JSON for programs.

use std::fmt;

use serde::Serialize;

use super::number::{number, triple};
use super::report::{Report, ResidualReport};
use crate::estimation::warnings::camera_warnings;
use crate::matching::{MOST_FALSE_ALARMS, MatchedCylinder, Matching};
use crate::observations::scene::LineId;
use crate::observations::view::View;

/// All cylinders found, as plain numbers in the form of the JSON output.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MatchingReport {
    /// Unit directions of the axes.
    pub directions: Vec<[f64; 3]>,
    /// Largest distance of a match: pixels if all cameras have a calibration, radians otherwise.
    pub threshold: f64,
    /// Number of lines in all views.
    pub lines: usize,
    /// Least number of matches that was required of a cylinder.
    pub least_support: usize,
    /// The part of all lines that are not silhouettes of a cylinder, averaged over the cylinders.
    pub outlier_rate: f64,
    /// The cylinders, direction by direction, the least likely by chance first.
    pub cylinders: Vec<MatchedCylinderReport>,
    /// Lines of no cylinder.
    pub unmatched: Vec<LineReport>,
    /// What makes the result doubtful, in words.
    pub warnings: Vec<String>,
}

/// A cylinder and its silhouettes.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MatchedCylinderReport {
    /// Point of the axis nearest to the world's origin.
    pub axis_point: [f64; 3],
    /// Unit direction of the axis, one of the directions of the report.
    pub direction: [f64; 3],
    /// Radius, world units.
    pub radius: f64,
    /// Root mean square distance between matches and circle in the cross-section, world units.
    pub section_rms: f64,
    /// The part of all lines that are not silhouettes of the cylinder.
    pub outlier_rate: f64,
    /// Expected number of cylinders with matches as many and as near by chance.
    pub false_alarms: f64,
    /// The cylinder refined on its matches in the images, with the form of `cylinders triangulate`.
    /// Absent if it could not be refined.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub refined: Option<Report>,
    /// Whether the refined cylinders of its direction have one direction. Otherwise it is refined
    /// by itself: it is the only one, or their lines say that they are not parallel.
    pub parallel: bool,
    /// One residual for each silhouette.
    pub matches: Vec<ResidualReport>,
}

/// A line of a scene.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LineReport {
    /// Name of the image; absent if it has none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub image: Option<String>,
    /// Index of the view in the scene, from 0.
    pub view: usize,
    /// Index of the line in its view, from 0.
    pub line: usize,
}

impl MatchingReport {
    /// Collects the numbers of the result for these views and the threshold of the search.
    pub fn new(views: &[View], threshold: f64, matching: &Matching) -> Self {
        let cylinder = |found: &MatchedCylinder| MatchedCylinderReport {
            axis_point: found.cylinder.axis_point.coords.into(),
            direction: found.cylinder.direction.into_inner().into(),
            radius: found.cylinder.radius,
            section_rms: found.rms,
            outlier_rate: found.outlier_rate,
            false_alarms: found.false_alarms,
            refined: None,
            parallel: false,
            matches: found
                .matches
                .iter()
                .map(|residual| ResidualReport::new(&views[residual.view], residual))
                .collect(),
        };
        let line =
            |&LineId { view, line }: &LineId| LineReport { image: views[view].image().map(str::to_owned), view, line };
        let rates = matching.cylinders.iter().map(|found| found.outlier_rate);
        Self {
            directions: matching.directions.iter().map(|direction| direction.into_inner().into()).collect(),
            threshold,
            lines: views.iter().map(|view| view.lines().len()).sum(),
            least_support: matching.least_support,
            outlier_rate: rates.sum::<f64>() / matching.cylinders.len() as f64,
            cylinders: matching.cylinders.iter().map(cylinder).collect(),
            unmatched: matching.unmatched.iter().map(line).collect(),
            warnings: warnings(views, matching),
        }
    }
}

impl MatchingReport {
    /// The report with the refined cylinders, in the order of the matching, and whether they share
    /// their direction; or why they could not be refined. Their warnings are said, too, each with
    /// the number of its cylinder.
    pub fn with_refined<E: fmt::Display>(mut self, refined: Vec<Result<(Report, bool), E>>) -> Self {
        for (index, (cylinder, refined)) in self.cylinders.iter_mut().zip(refined).enumerate() {
            let number = index + 1;
            match refined {
                Ok((report, parallel)) => {
                    // Those about the cameras concern all cylinders and are said once.
                    let new: Vec<_> =
                        report.warnings.iter().filter(|warning| !self.warnings.contains(warning)).collect();
                    let new: Vec<_> = new.iter().map(|warning| format!("cylinder {number}: {warning}")).collect();
                    self.warnings.extend(new);
                    (cylinder.refined, cylinder.parallel) = (Some(report), parallel);
                }
                Err(error) => self.warnings.push(format!("cylinder {number} is not refined: {error}")),
            }
        }
        self
    }
}

fn warnings(views: &[View], matching: &Matching) -> Vec<String> {
    // The search takes them only if their number, or that of their matches, is given.
    let chance = |(index, found): (usize, &MatchedCylinder)| {
        let (number, false_alarms) = (index + 1, found.false_alarms);
        (false_alarms > MOST_FALSE_ALARMS).then(|| {
            format!("cylinder {number} may be chance: {false_alarms:.1e} with as many and as near matches are expected")
        })
    };
    let two_images = |(index, found): (usize, &MatchedCylinder)| {
        let number = index + 1;
        (images(found) == 2)
            .then(|| format!("only two images show cylinder {number}: a flat band in space could look like it there"))
    };
    let bands = |(index, found): (usize, &MatchedCylinder)| {
        let number = index + 1;
        (images(found) > 2 && !found.is_round(views)).then(|| {
            format!("cylinder {number} need not be round: a flat band in space could look like it in these images")
        })
    };
    let of_cameras = camera_warnings(views).into_iter().map(|warning| warning.to_string());
    let cylinders = || matching.cylinders.iter().enumerate();
    let doubts = cylinders().filter_map(chance).chain(cylinders().filter_map(two_images));
    of_cameras.chain(doubts).chain(cylinders().filter_map(bands)).collect()
}

/// Number of images with matches, which are in the order of the views.
fn images(found: &MatchedCylinder) -> usize {
    found.matches.chunk_by(|one, other| one.view == other.view).count()
}

/// Text for people, with seven significant digits.
impl fmt::Display for MatchingReport {
    fn fmt(&self, text: &mut fmt::Formatter<'_>) -> fmt::Result {
        for direction in &self.directions {
            writeln!(text, "direction        {}", triple(*direction))?;
        }
        writeln!(text, "cylinders        {:14}   with {} matches or more", self.cylinders.len(), self.least_support)?;
        writeln!(text, "threshold        {:14.4}   largest distance of a match", self.threshold)?;
        writeln!(text, "lines            {:14}   {} of no cylinder", self.lines, self.unmatched.len())?;
        writeln!(text, "outlier rate     {:14.4}   mean over the cylinders", self.outlier_rate)?;
        self.warnings.iter().try_for_each(|warning| writeln!(text, "warning: {warning}"))?;
        for (index, cylinder) in self.cylinders.iter().enumerate() {
            writeln!(text, "\ncylinder         {:14}", index + 1)?;
            writeln!(text, "axis point       {}   nearest to the origin", triple(cylinder.axis_point))?;
            if self.directions.len() > 1 {
                writeln!(text, "direction        {}", triple(cylinder.direction))?;
            }
            writeln!(text, "radius           {}", number(cylinder.radius))?;
            writeln!(text, "section rms      {:14.6e}   world units", cylinder.section_rms)?;
            writeln!(text, "outlier rate     {:14.4}   {} matches", cylinder.outlier_rate, cylinder.matches.len())?;
            writeln!(text, "false alarms     {:14.1e}   as many and as near matches by chance", cylinder.false_alarms)?;
            if let Some(refined) = &cylinder.refined {
                let how = if cylinder.parallel { ", parallel to the others of its direction" } else { "" };
                writeln!(text, "\nrefined{how}")?;
                refined.write_cylinder(text)?;
            }
            writeln!(text, "\n{}", ResidualReport::HEADING)?;
            cylinder.matches.iter().try_for_each(|residual| writeln!(text, "{residual}"))?;
        }
        Ok(())
    }
}
