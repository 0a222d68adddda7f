//! Grey images.

use nalgebra::Point2;
use thiserror::Error;

/// An image of one channel, row by row. A value that is not finite stands for an unknown pixel.
///
/// The pixel coordinates (0, 0) are the upper left corner of the image, so the centre of its first
/// pixel is at (0.5, 0.5).
#[derive(Clone, Debug, PartialEq)]
pub struct GreyImage {
    width: usize,
    height: usize,
    values: Vec<f32>,
}

/// Why values are not an image.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum GreyError {
    /// The number of values is not that of the pixels.
    #[error("{values} values for an image of {width} x {height} pixels; pass one value for each pixel, row by row")]
    Size {
        /// Number of values.
        values: usize,
        /// Pixels of a row.
        width: usize,
        /// Number of rows.
        height: usize,
    },
}

impl GreyImage {
    /// An image of these values, 0 (black) to 255 (white).
    ///
    /// # Errors
    /// [`GreyError::Size`].
    pub fn new(width: usize, height: usize, values: Vec<f32>) -> Result<Self, GreyError> {
        match width.checked_mul(height) == Some(values.len()) {
            true => Ok(Self { width, height, values }),
            false => Err(GreyError::Size { values: values.len(), width, height }),
        }
    }

    /// Pixels of a row.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Number of rows.
    pub fn height(&self) -> usize {
        self.height
    }

    /// The values, row by row.
    pub fn values(&self) -> &[f32] {
        &self.values
    }

    /// The value between pixels, by linear interpolation; NaN outside.
    pub fn at(&self, point: &Point2<f64>) -> f32 {
        let (x, y) = (point.x - 0.5, point.y - 0.5);
        let inside = x >= 0.0 && y >= 0.0 && x <= self.width as f64 - 1.0 && y <= self.height as f64 - 1.0;
        if !inside {
            return f32::NAN;
        }
        let (column, row) = (x as usize, y as usize);
        let (right, below) = ((column + 1).min(self.width - 1), (row + 1).min(self.height - 1));
        let (u, v) = ((x - column as f64) as f32, (y - row as f64) as f32);
        let value = |column: usize, row: usize| self.values[row * self.width + column];
        (value(column, row) * (1.0 - u) + value(right, row) * u) * (1.0 - v)
            + (value(column, below) * (1.0 - u) + value(right, below) * u) * v
    }

    /// An image of the same size whose pixels are seen at other places of this one; `None` for a
    /// pixel that is unknown.
    pub fn warped(&self, seen: impl Fn(Point2<f64>) -> Option<Point2<f64>>) -> Self {
        let place = |index: usize| Point2::new((index % self.width) as f64 + 0.5, (index / self.width) as f64 + 0.5);
        let value = |index| seen(place(index)).map_or(f32::NAN, |point| self.at(&point));
        Self { values: (0..self.values.len()).map(value).collect(), ..*self }
    }
}
