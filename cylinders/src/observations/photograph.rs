//! A photograph: the camera for pixels in which segments are marked.

use nalgebra::Point2;

use super::distortion::Distortion;
use super::view::Camera;

/// A named image with its camera. Pixels are those of the original photograph, with its distortion.
#[derive(Clone, Debug, PartialEq)]
pub struct Photograph {
    /// Name of the image file.
    pub name: String,
    /// Camera. It needs a calibration, because segments are in pixels.
    pub camera: Camera,
    /// Distortion of the lens.
    pub distortion: Distortion,
}

impl Photograph {
    /// The pixel at which a lens without distortion would show the point seen at `pixel`. `None`
    /// without calibration, or if the distortion cannot be inverted.
    pub fn undistort(&self, pixel: &Point2<f64>) -> Option<Point2<f64>> {
        let calibration = self.camera.calibration()?;
        if self.distortion.is_none() {
            return Some(*pixel);
        }
        let ideal = self.distortion.undistort(&calibration.point_to_normalised(pixel))?;
        Some(calibration.point_to_pixels(&ideal))
    }
}
