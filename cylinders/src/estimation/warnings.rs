//! What makes an estimate doubtful: other cylinders that explain the lines, a bad fit, a wrong
//! line, cameras that may be mirrored.

use std::fmt;

use super::alternatives::PlausibleCylinders;
use super::evidence::Evidence;
use crate::observations::scene::{CylinderLines, LineId};
use crate::observations::view::{Camera, View};
use crate::space::cylinder::Cylinder;
use crate::space::silhouette_distance::{DistanceUnit, Metric};

/// The fit is bad if the noise that it needs is larger, pixels. Lines are marked to a few pixels.
const BAD_NOISE_PIXELS: f64 = 10.0;

/// The same in radians: at a focal length of 3000.
const BAD_NOISE_RADIANS: f64 = 10.0 / 3000.0;

/// The allowance of lines without end points.
const WITHOUT_ENDS: f64 = 3.0;

/// Silhouettes that are nearer to each other than this in all images may be joined, pixels: twice
/// the largest distance between copies.
const THIN_PIXELS: f64 = 4.0;

/// The same in radians: at a focal length of 3000.
const THIN_RADIANS: f64 = 4.0 / 3000.0;

/// Least squares are not accurate if refinement changes the radius by more than this part.
const FAR: f64 = 0.03;

/// A line is called wrong if noise would explain its distance in fewer than this part of all
/// scenes.
const SIGNIFICANCE: f64 = 1e-3;

/// Number of lines of largest distance among which a wrong one is looked for.
const SUSPECTS: usize = 10;

/// Steps of Levenberg-Marquardt without the suspect.
const STEPS: usize = 100;

/// Why an estimate is doubtful.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Warning {
    /// Several cylinders explain the lines about equally well.
    Ambiguous {
        /// Number of plausible cylinders.
        cylinders: usize,
    },
    /// Nearly as many other lines agree on another cylinder.
    Rival {
        /// Number of independent lines that agree with the estimate, and with the other cylinder.
        agreeing: [usize; 2],
    },
    /// Another cylinder explains the lines much better than the estimate.
    NotTheBest,
    /// Least squares in the cross-section are far from the cylinder that fits best in the images.
    FarFromRefined {
        /// Radius of that cylinder over the radius of the estimate.
        ratio: f64,
    },
    /// Only three lines are clearly distinct, though others may be a few pixels away from them:
    /// nothing checks the result.
    ThreeLines,
    /// The distances are too large for noise.
    BadFit {
        /// Standard deviation of a distance that would explain them.
        noise: f64,
        /// Its unit.
        unit: DistanceUnit,
    },
    /// Without this line all others fit much better.
    WrongLine {
        /// The line.
        line: LineId,
        /// Its distance from the silhouette of the cylinder that fits the others.
        distance: f64,
        /// Unit of the distance.
        unit: DistanceUnit,
    },
    /// A line of this view touches the cylinder behind the camera.
    Behind {
        /// Index of the view.
        view: usize,
    },
    /// Camera matrices have negative determinants.
    NegatedCameras {
        /// Index of the first of these views.
        view: usize,
        /// Their number.
        views: usize,
    },
    /// Calibrations have negative focal lengths, so that images are mirrored.
    NegativeFocalLengths {
        /// Index of the first of these views.
        view: usize,
        /// Their number.
        views: usize,
    },
    /// The cylinder is so thin in the images that its two silhouettes cannot be told from copies of
    /// one line, which are joined.
    Thin {
        /// Its width in the image in which it is widest.
        width: f64,
        /// Unit of the width.
        unit: DistanceUnit,
    },
    /// As many lines may agree on a cylinder by chance.
    Chance {
        /// Expected number of such cylinders, an upper bound.
        false_alarms: f64,
    },
    /// The points of the scene move the cylinder further than the noise of its lines allows.
    PointsDisagree,
}

impl Warning {
    /// The same warning with the line named by its place in the scene.
    pub fn in_scene(self, lines: &CylinderLines) -> Self {
        let Self::WrongLine { line, distance, unit } = self else { return self };
        let before: usize = lines.views.iter().take(line.view).map(|view| view.lines().len()).sum();
        let line = lines.lines.get(before + line.line).copied().unwrap_or(line);
        Self::WrongLine { line, distance, unit }
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, text: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Ambiguous { cylinders } => write!(
                text,
                "the result is ambiguous: {cylinders} cylinders explain the lines about equally well; pass another \
                 silhouette line, best from another view"
            ),
            Self::Rival { agreeing: [own, other] } => write!(
                text,
                "the lines show another cylinder, which is listed: {other} lines agree on it, and {own} on this one; label \
                 the lines of each, or use `match`"
            ),
            Self::NotTheBest => text.write_str(
                "another cylinder explains the lines much better: it is listed; is a line wrong, or a camera mirrored?",
            ),
            Self::FarFromRefined { ratio } => write!(
                text,
                "least squares are not accurate for these lines: refinement changes the radius by {:.1} %; use --refine",
                100.0 * (ratio - 1.0)
            ),
            Self::ThreeLines => text.write_str(
                "only three lines are clearly distinct: up to four cylinders touch them, and nothing checks the result; \
                 pass another silhouette line",
            ),
            Self::BadFit { noise, unit } => write!(
                text,
                "the fit is bad: the lines are off by {}, far more than noise; lines are wrong (try --robust), or \
                 cameras are",
                length(*noise, *unit)
            ),
            Self::WrongLine { line: LineId { view, line }, distance, unit } => write!(
                text,
                "views[{view}], line {line} does not fit the others: it is {} from the silhouette of the cylinder \
                 without it; if it is wrong, remove it or try --robust",
                length(*distance, *unit)
            ),
            Self::Behind { view } => write!(
                text,
                "the cylinder touches a line of views[{view}] behind the camera: is the camera mirrored, or its line \
                 wrong?"
            ),
            Self::NegatedCameras { view, views } => write!(
                text,
                "the camera of {} has a negative determinant: it was read as a negative multiple of a camera; if it is \
                 mirrored, the result is wrong",
                place(*view, *views)
            ),
            Self::NegativeFocalLengths { view, views } => write!(
                text,
                "the calibration of {} has a negative focal length: the image is taken as mirrored; if it is not, the \
                 result is wrong",
                place(*view, *views)
            ),
            Self::Thin { width, unit } => write!(
                text,
                "the cylinder is only {} wide in the images: its two silhouettes cannot be told from copies of one line, \
                 so the radius may be wrong",
                length(*width, *unit)
            ),
            Self::PointsDisagree => text.write_str(
                "the points of the scene and the lines do not agree: the cylinder of both is further from that of the \
                 lines than their noise explains",
            ),
            Self::Chance { false_alarms } => write!(
                text,
                "so few lines agree that it may be chance: up to {false_alarms:.1e} such cylinders are expected among \
                 random lines"
            ),
        }
    }
}

/// Names the first of several views.
fn place(view: usize, views: usize) -> String {
    match views {
        ..2 => format!("views[{view}]"),
        _ => format!("views[{view}] (and of {} others)", views - 1),
    }
}

/// A distance with its unit.
fn length(distance: f64, unit: DistanceUnit) -> String {
    match unit {
        DistanceUnit::Pixels => format!("{distance:.1} {unit}"),
        DistanceUnit::Radians => format!("{distance:.2e} {unit}"),
    }
}

/// Cameras of views with lines that may be mirrored.
pub fn camera_warnings(views: &[View]) -> Vec<Warning> {
    let places = |is_doubtful: &dyn Fn(&Camera) -> bool| -> Vec<usize> {
        let doubtful = |&view: &usize| !views[view].lines().is_empty() && is_doubtful(views[view].camera());
        (0..views.len()).filter(doubtful).collect()
    };
    let has_negative = |camera: &Camera| camera.calibration().is_some_and(|k| k.matrix().diagonal().min() < 0.0);
    let negated = places(&Camera::is_negated);
    let negative = places(&has_negative);
    let negated = negated.first().map(|&view| Warning::NegatedCameras { view, views: negated.len() });
    let negative = negative.first().map(|&view| Warning::NegativeFocalLengths { view, views: negative.len() });
    negated.into_iter().chain(negative).collect()
}

/// A warning if the two silhouettes of a cylinder are too near to each other in all images.
pub(crate) fn thin(cylinder: &Cylinder, views: &[View]) -> Option<Warning> {
    let unit = Metric::of(views).unit;
    let width = |view: &View| {
        let focal = match unit {
            DistanceUnit::Pixels => view.camera().calibration()?.matrix().fixed_view::<2, 2>(0, 0).determinant(),
            DistanceUnit::Radians => 1.0,
        };
        let distance = cylinder.vector_to_axis(&view.camera().centre()).norm();
        Some(2.0 * focal.abs().sqrt() * cylinder.radius / distance)
    };
    let seeing = views.iter().filter(|view| !view.lines().is_empty());
    let width = seeing.filter_map(width).fold(0.0, f64::max);
    let least = match unit {
        DistanceUnit::Pixels => THIN_PIXELS,
        DistanceUnit::Radians => THIN_RADIANS,
    };
    (width < least).then_some(Warning::Thin { width, unit })
}

/// What the lines say against a cylinder near a minimum, or against its being the only one.
pub(crate) fn fit_warnings(
    evidence: &Evidence<'_>,
    cylinder: &Cylinder,
    plausible: &PlausibleCylinders,
) -> Vec<Warning> {
    let mut warnings = Vec::new();
    match plausible.cylinders.len() {
        1 if plausible.found.is_none() => warnings.push(Warning::NotTheBest),
        cylinders @ 2.. => warnings.push(Warning::Ambiguous { cylinders }),
        _ => {}
    }
    // With a known radius, the third line checks the others.
    if evidence.distinct.len() < 4 && evidence.known.radius.is_none() {
        warnings.push(Warning::ThreeLines);
    }
    let behind = evidence
        .measured
        .iter()
        .find(|line| line.distance(cylinder).is_none_or(|distance| distance.depth.is_nan() || distance.depth <= 0.0));
    warnings.extend(behind.map(|line| Warning::Behind { view: line.view }));

    let nearest = evidence.known.nearest(evidence.measured, cylinder, STEPS).unwrap_or(*cylinder);
    let ratio = nearest.radius / cylinder.radius;
    if (ratio - 1.0).abs() > FAR {
        warnings.push(Warning::FarFromRefined { ratio });
    }
    let squares: f64 =
        evidence.measured.iter().filter_map(|line| line.distance(&nearest)).map(|d| 2.0 * d.mean_square()).sum();
    let freedom = 2.0 * evidence.measured.len() as f64 - evidence.known.parameters();
    let noise = (squares / freedom).sqrt();
    warnings.extend(bad_fit(noise, evidence.unit, evidence.measured.iter().all(|line| line.has_ends)));
    warnings.extend(wrong_line(evidence, &nearest, squares));
    warnings
}

/// A warning if the noise is too large. Lines without end points may have been seen far from their
/// support points, so that more is allowed.
pub(crate) fn bad_fit(noise: f64, unit: DistanceUnit, have_ends: bool) -> Option<Warning> {
    let largest = match unit {
        DistanceUnit::Pixels => BAD_NOISE_PIXELS,
        DistanceUnit::Radians => BAD_NOISE_RADIANS,
    };
    let factor = if have_ends { 1.0 } else { WITHOUT_ENDS };
    (noise > factor * largest).then_some(Warning::BadFit { noise, unit })
}

/// The line without which the others fit best, if noise does not explain the gain. Without it the
/// sum of squares falls from `c` to `c'`; for Gaussian noise the ratio is at most `c' / c` with the
/// probability `(c' / c)^((nu - 2) / 2)` (F distribution with 2 and `nu - 2` degrees of freedom),
/// and one of `N` lines is chosen.
fn wrong_line(evidence: &Evidence<'_>, cylinder: &Cylinder, squares: f64) -> Option<Warning> {
    let lines = evidence.measured;
    if lines.len() < 5 {
        return None;
    }
    let square = |index: &usize| lines[*index].distance(cylinder).map_or(f64::INFINITY, |d| d.mean_square());
    let mut suspects: Vec<_> = (0..lines.len()).collect();
    suspects.sort_by(|one, other| square(other).total_cmp(&square(one)));
    suspects.truncate(SUSPECTS);
    let without = |suspect: usize| {
        let (mut others, mut planes) = (lines.to_vec(), evidence.planes.to_vec());
        let line = others.remove(suspect);
        planes.remove(suspect);
        let best = evidence.known.nearest(&others, cylinder, STEPS)?;
        let others = Evidence { planes: &planes, measured: &others, ..*evidence };
        // The usual noise in the likelihood ratio adds two degrees of freedom to the exponent.
        let probability = others.likelihood_ratio(others.cost(&best)?, squares, evidence.known.parameters() + 2.0);
        let distance = line.distance(&best)?.mean_square().sqrt();
        Some((probability * lines.len() as f64, suspect, distance))
    };
    let (probability, suspect, distance) =
        suspects.into_iter().filter_map(without).min_by(|one, other| one.0.total_cmp(&other.0))?;
    let line = evidence.planes[suspect].0;
    (probability < SIGNIFICANCE).then_some(Warning::WrongLine { line, distance, unit: evidence.unit })
}
