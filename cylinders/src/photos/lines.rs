//! Photographs to candidates of silhouettes.
//!
//! A segment stays a candidate by its length alone. Its end points are known to about half a pixel
//! across it, so a segment of `L` pixels is turned by up to `1 / L` radians: a short one agrees
//! with any direction near it, and says nothing.

use std::borrow::Cow;

use nalgebra::Point2;
use thiserror::Error;

use super::ribbons::{Ribbon, ribbons};
use crate::detection::{DetectedSegment, GreyImage, segments};
use crate::numerics::interrupt::{Interrupt, Interrupted};
use crate::observations::copies::IndependentLines;
use crate::observations::photograph::Photograph;
use crate::observations::view::{View, ViewError};

/// Default of the least length of a line, as a part of the diagonal of the image.
const LEAST_LENGTH: f64 = 0.03;

/// Points that are nearer are one point; normalised image coordinates.
const SAME_POINT: f64 = 1e-6;

/// Which segments become lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineOptions<'a> {
    /// Least length of a line after its pieces are joined, as a part of the diagonal of the image.
    pub least_length: f64,
    /// Ends the detection between its steps.
    pub interrupt: Interrupt<'a>,
}

impl Default for LineOptions<'_> {
    fn default() -> Self {
        Self { least_length: LEAST_LENGTH, interrupt: Interrupt::never() }
    }
}

/// Why a photograph gives no lines.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum PhotoError {
    /// The camera has no calibration.
    #[error("`{image}`: the camera has no calibration, so pixels cannot be used; add `K` to the scene")]
    NoCalibration {
        /// Name of the image.
        image: String,
    },
    /// The lines are refused.
    #[error("the lines of `{image}`: {source}")]
    View {
        /// Name of the image.
        image: String,
        /// Reason.
        source: ViewError,
    },
    /// The options interrupt the detection.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
}

/// The image that a lens without distortion would give, of the same size. Pixels outside of the
/// photograph are unknown.
///
/// # Errors
/// [`PhotoError::NoCalibration`].
pub fn undistorted_image<'a>(photograph: &Photograph, image: &'a GreyImage) -> Result<Cow<'a, GreyImage>, PhotoError> {
    let Some(calibration) = photograph.camera.calibration() else {
        return Err(PhotoError::NoCalibration { image: photograph.name.clone() });
    };
    if photograph.distortion.is_none() {
        return Ok(Cow::Borrowed(image));
    }
    let seen = |ideal: Point2<f64>| {
        let point = calibration.point_to_normalised(&ideal);
        let seen = photograph.distortion.distort(&point);
        // Beyond the fold of the distortion a point of the image is seen a second time.
        let back = photograph.distortion.undistort(&seen)?;
        ((back - point).norm() < SAME_POINT).then(|| calibration.point_to_pixels(&seen))
    };
    Ok(Cow::Owned(image.warped(seen)))
}

/// What a photograph shows.
#[derive(Clone, Debug)]
pub struct Seen {
    /// The view with the candidates for silhouettes.
    pub view: View,
    /// Width and height of the image, pixels.
    pub size: [usize; 2],
    /// Pairs of them with an even part of the image between them.
    pub ribbons: Vec<Ribbon>,
}

/// The candidates for silhouettes that are detected in the image of a photograph.
///
/// # Errors
/// [`PhotoError`].
pub fn seen(photograph: &Photograph, image: &GreyImage, options: &LineOptions) -> Result<Seen, PhotoError> {
    let ideal = undistorted_image(photograph, image)?;
    let diagonal = (image.width() as f64).hypot(image.height() as f64);
    options.interrupt.check()?;
    let view = candidate_lines(photograph, &segments(&ideal, options.interrupt)?, diagonal, options)?;
    options.interrupt.check()?;
    Ok(Seen { ribbons: ribbons(&view, &ideal), view, size: [image.width(), image.height()] })
}

/// The view of a photograph with the candidates for silhouettes among its segments (pixels without
/// distortion), the longest first. Pieces of a line, and both edges of a thin one, are one line.
///
/// # Errors
/// [`PhotoError`].
pub fn candidate_lines(
    photograph: &Photograph,
    segments: &[DetectedSegment],
    diagonal: f64,
    options: &LineOptions,
) -> Result<View, PhotoError> {
    let image = || photograph.name.clone();
    let calibration = *photograph.camera.calibration().ok_or_else(|| PhotoError::NoCalibration { image: image() })?;
    let mut ends: Vec<_> = segments.iter().map(|segment| segment.ends).collect();
    let length = |ends: &[Point2<f64>; 2]| (ends[1] - ends[0]).norm();
    // A third of a line is enough for a piece of it.
    ends.retain(|ends| length(ends) >= options.least_length * diagonal / 3.0);
    // A group of pieces begins with its longest.
    ends.sort_by(|a, b| length(b).total_cmp(&length(a)));
    let view = View::from_pixel_segments(photograph.camera, &ends)
        .map_err(|source| PhotoError::View { image: image(), source })?;
    let joined = IndependentLines::of(&[view.with_image(image()).with_distortion(photograph.distortion)]);
    let Some(view) = joined.views.into_iter().next() else {
        return Err(PhotoError::View { image: image(), source: ViewError::NoCalibration });
    };
    let pixels = |ends: &[Point2<f64>; 2]| length(&ends.map(|end| calibration.point_to_pixels(&end)));
    let mut long: Vec<_> = view
        .ends()
        .iter()
        .enumerate()
        .filter_map(|(line, ends)| Some((line, pixels(ends.as_ref()?))))
        .filter(|(_, length)| *length >= options.least_length * diagonal)
        .collect();
    long.sort_by(|a, b| b.1.total_cmp(&a.1));
    Ok(view.selected(&long.iter().map(|(line, _)| *line).collect::<Vec<_>>()))
}
