//! Options of the search for cylinders.

use crate::numerics::interrupt::Interrupt;
use crate::observations::view::View;
use crate::space::silhouette_distance::DistanceUnit;

/// Default of the largest distance between a line and its silhouette: an end point that is off by a
/// pixel may reach it.
pub(crate) const THRESHOLD_PIXELS: f64 = 3.0;

/// Default of the same distance in radians: three pixels at a focal length of 3000.
const THRESHOLD_RADIANS: f64 = 1e-3;

/// Default of the largest number of false alarms of the best cylinder of a direction that is only
/// supposed. Edges of a texture are not independent of each other, as the number supposes: circles
/// that must be round have reached 1e-2 among boxes without cylinders. Small scenes with cylinders
/// are lost at 1e-8: nearly all of three cylinders in four images.
const DIRECTION_FALSE_ALARMS: f64 = 1e-4;

/// Least distance of the silhouettes of a cylinder from its axis, in thresholds: a cylinder that is
/// thinner cannot be told from an edge.
pub(super) const LEAST_WIDTH: f64 = 2.0;

/// The images in which pairs of silhouettes are taken.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum References {
    /// The first image with two lines or more, as in the paper. A cylinder is found only if both
    /// its silhouettes were seen there.
    First,
    /// Every image, and near images together if there are few lines: a cylinder need not show both
    /// silhouettes in any image. If there are many lines, only images that are spread evenly.
    Every,
}

/// Options of the search for cylinders.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MatchOptions<'a> {
    /// Largest distance between a line and its silhouette in the cross-section: an angle at the
    /// camera centre, in radians or as the pixels that it covers in the middle of the image. It is
    /// a bound: the noise of each cylinder is estimated, and its matches are within three standard
    /// deviations.
    pub threshold: f64,
    /// Unit of the threshold.
    pub unit: DistanceUnit,
    /// The images in which pairs of silhouettes are taken.
    pub references: References,
    /// Largest number of cylinders; `None` for all that have the required support.
    pub count: Option<usize>,
    /// Least number of matches of a cylinder, four or more. `None` means four if the number of
    /// cylinders is given; otherwise it means the number that the remaining lines would not reach
    /// by chance if they were random.
    pub least_support: Option<usize>,
    /// Ends the search between pairs of lines.
    pub interrupt: Interrupt<'a>,
    /// Largest number of false alarms of the least doubtful cylinder of a direction, or of all that
    /// must be round together, if neither the direction nor the number of cylinders is given.
    pub direction_false_alarms: f64,
    /// Largest number of lines of an image along a direction, without those of edges. The first
    /// count.
    pub lines: usize,
}

impl MatchOptions<'_> {
    /// Options for pairs of every image and all cylinders, without interruption. The threshold is 3
    /// pixels if all cameras have a calibration, and 0.001 radians otherwise.
    pub fn of(views: &[View]) -> Self {
        let calibrated = views.iter().all(|view| view.camera().calibration().is_some());
        let (unit, threshold) = match calibrated {
            true => (DistanceUnit::Pixels, THRESHOLD_PIXELS),
            false => (DistanceUnit::Radians, THRESHOLD_RADIANS),
        };
        Self {
            threshold,
            unit,
            references: References::Every,
            count: None,
            least_support: None,
            interrupt: Interrupt::never(),
            direction_false_alarms: DIRECTION_FALSE_ALARMS,
            lines: usize::MAX,
        }
    }
}
