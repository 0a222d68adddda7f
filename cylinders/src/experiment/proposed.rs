//! The proposed method: constrained least squares with the choice of the circle in front of the
//! cameras.

use crate::circle::fit_circle_in_front;
use crate::cross_section::sight::Sight;
use crate::{Section, SectionLine};

/// Like triangulation, takes the best minimum in front of all cameras. `None` if there is no
/// circle.
pub(super) fn proposed(lines: &[SectionLine], sights: &[Sight]) -> Option<Section> {
    let tangents: Vec<_> = lines.iter().map(|line| line.line).collect();
    let extent = sights.iter().map(|sight| sight.camera.coords.norm()).fold(0.0, f64::max);
    Some(Section::from_circle(fit_circle_in_front(&tangents, sights, extent).ok()?.circle, lines))
}
