//! How cylinders are searched for.

use crate::observations::view::View;
use crate::space::silhouette_distance::DistanceUnit;

/// Default of the largest distance between a line and its silhouette: what an end point that is off
/// by a pixel may reach.
const THRESHOLD_PIXELS: f64 = 3.0;

/// Default in radians: three pixels at a focal length of 3000.
const THRESHOLD_RADIANS: f64 = 1e-3;

/// In which images pairs of silhouettes are taken.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum References {
    /// In the first image with two lines or more, as in the paper. A cylinder is found only if both
    /// its silhouettes were seen there.
    First,
    /// In every image: both silhouettes of a cylinder need to be seen in one of them, whichever it
    /// is.
    Every,
}

/// How cylinders are searched for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MatchOptions {
    /// Largest distance between a line and its silhouette in the cross-section: an angle at the
    /// camera centre, in radians or as the pixels that it covers in the middle of the image.
    pub threshold: f64,
    /// Unit of the threshold.
    pub unit: DistanceUnit,
    /// In which images pairs of silhouettes are taken.
    pub references: References,
    /// Largest number of cylinders; `None` for all that have the support.
    pub count: Option<usize>,
    /// Least number of matches of a cylinder, four or more. `None` for four where the number of
    /// cylinders is given, otherwise for what the lines left over would not reach by chance if they
    /// were in no order.
    pub least_support: Option<usize>,
}

impl MatchOptions {
    /// Pairs of every image and all cylinders. A threshold of 3 pixels where all cameras have a
    /// calibration, of 0.001 radians otherwise.
    pub fn of(views: &[View]) -> Self {
        let calibrated = views.iter().all(|view| view.camera().calibration().is_some());
        let (unit, threshold) = match calibrated {
            true => (DistanceUnit::Pixels, THRESHOLD_PIXELS),
            false => (DistanceUnit::Radians, THRESHOLD_RADIANS),
        };
        Self { threshold, unit, references: References::Every, count: None, least_support: None }
    }
}
