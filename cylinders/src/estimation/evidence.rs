//! The lines of a cylinder as evidence for it.

use super::joint::Known;
use super::triangulate::identified_planes;
use crate::observations::copies::IndependentLines;
use crate::observations::scene::LineId;
use crate::observations::view::{View, ViewingPlane};
use crate::space::silhouette_distance::{DistanceUnit, MeasuredLine, Metric, MetricError};

/// Lines within this multiple of the tolerance of copies are not clearly distinct.
const NEARLY: f64 = 4.0;

/// Independent lines, as planes and prepared for measurement.
#[derive(Clone, Copy)]
pub(crate) struct Evidence<'a> {
    pub(crate) planes: &'a [(LineId, ViewingPlane)],
    pub(crate) measured: &'a [MeasuredLine],
    /// The planes of clearly distinct lines: lines that are nearly copies are joined.
    pub(crate) distinct: &'a [(LineId, ViewingPlane)],
    pub(crate) unit: DistanceUnit,
    /// What the lines need not tell.
    pub(crate) known: Known,
}

/// The planes of the clearly distinct lines among independent ones. Each has the place of its first
/// line.
pub(crate) fn distinct_planes(lines: &IndependentLines) -> Vec<(LineId, ViewingPlane)> {
    identified_planes(&IndependentLines::within(&lines.views, NEARLY))
}

/// The lines of some views in all the forms that the estimation needs.
pub(super) struct PreparedLines {
    /// Number of independent lines.
    pub(super) count: usize,
    planes: Vec<(LineId, ViewingPlane)>,
    pub(super) measured: Vec<MeasuredLine>,
    distinct: Vec<(LineId, ViewingPlane)>,
    unit: DistanceUnit,
}

impl PreparedLines {
    pub(super) fn of(views: &[View], metric: &Metric) -> Result<Self, MetricError> {
        let lines = IndependentLines::of(views);
        Ok(Self {
            count: lines.count(),
            planes: identified_planes(&lines),
            measured: metric.measured(&lines)?,
            distinct: distinct_planes(&lines),
            unit: metric.unit,
        })
    }

    /// The evidence for a cylinder of which something is known.
    pub(super) fn evidence(&self, known: Known) -> Evidence<'_> {
        Evidence { planes: &self.planes, measured: &self.measured, distinct: &self.distinct, unit: self.unit, known }
    }
}
