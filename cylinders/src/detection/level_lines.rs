//! The image at 0.8 of its size, and the level line at each of its pixels (LSD, sections 2.1 to
//! 2.3).
//!
//! Reduction removes the stairs of aliased edges. The gradient is taken between four pixels:
//!
//! ```text
//!     a b     gx = (b + d - a - c) / 2      level line: the gradient turned by a right angle,
//!     c d     gy = (c + d - a - b) / 2      (-gy, gx), so that the brighter side is on its left
//! ```

use std::f32::consts::FRAC_PI_8;

use super::grey::GreyImage;

/// Size of the reduced image.
pub(super) const SCALE: f64 = 0.8;

/// Standard deviation of the smoothing, pixels of the reduced image.
const SIGMA: f64 = 0.6;

/// The kernel ends where it is below a thousandth of its middle.
const REACH: f64 = 3.717;

/// Values are rounded to whole numbers, so gradients are wrong by up to two.
const QUANTISATION: f32 = 2.0;

/// Tolerance of directions, radians: 22.5 degrees.
pub(super) const TOLERANCE: f32 = FRAC_PI_8;

/// Direction and steepness of the level lines of the reduced image.
pub(super) struct LevelLines {
    pub(super) width: usize,
    pub(super) height: usize,
    /// Direction, radians; NaN where the gradient is too small to have one.
    pub(super) angles: Vec<f32>,
    /// Length of the gradient.
    pub(super) steepness: Vec<f32>,
}

impl LevelLines {
    pub(super) fn of(image: &GreyImage) -> Self {
        let (columns, rows, values) = reduced(image);
        let (width, height) = (columns.saturating_sub(1), rows.saturating_sub(1));
        let least = QUANTISATION / TOLERANCE.sin();
        let mut lines = Self { width, height, angles: Vec::new(), steepness: Vec::new() };
        lines.angles.reserve(width * height);
        lines.steepness.reserve(width * height);
        for row in 0..height {
            for column in 0..width {
                let [a, b] = [values[row * columns + column], values[row * columns + column + 1]];
                let [c, d] = [values[(row + 1) * columns + column], values[(row + 1) * columns + column + 1]];
                let (x, y) = ((b + d - a - c) / 2.0, (c + d - a - b) / 2.0);
                let steepness = x.hypot(y);
                // The comparison is false at an unknown pixel.
                let steep = steepness > least;
                lines.angles.push(if steep { x.atan2(-y) } else { f32::NAN });
                lines.steepness.push(if steep { steepness } else { 0.0 });
            }
        }
        lines
    }

    /// Whether the direction at a pixel is within a tolerance of another.
    pub(super) fn is_aligned(&self, pixel: usize, angle: f32, tolerance: f32) -> bool {
        difference(self.angles[pixel], angle).abs() <= tolerance
    }
}

/// The difference of two angles, from minus half a turn to half a turn.
pub(super) fn difference(first: f32, second: f32) -> f32 {
    use std::f32::consts::{PI, TAU};
    let difference = first - second;
    if difference > PI {
        difference - TAU
    } else if difference < -PI {
        difference + TAU
    } else {
        difference
    }
}

/// The image smoothed and sampled. Middles of images correspond, so do their corners: a point at
/// `u` is at `u / 0.8` in the full image, in coordinates that begin at the corner.
fn reduced(image: &GreyImage) -> (usize, usize, Vec<f32>) {
    let size = |length: usize| (length as f64 * SCALE).floor() as usize;
    let (width, height) = (size(image.width()), size(image.height()));
    let across: Vec<_> = (0..width).map(|place| Kernel::at(place, image.width())).collect();
    let down: Vec<_> = (0..height).map(|place| Kernel::at(place, image.height())).collect();
    let mut rows = Vec::with_capacity(width * image.height());
    for row in image.values().chunks_exact(image.width().max(1)) {
        rows.extend(across.iter().map(|kernel| {
            kernel.weights.iter().zip(&row[kernel.first..]).map(|(weight, value)| weight * value).sum::<f32>()
        }));
    }
    let mut values = vec![0.0; width * height];
    for (kernel, target) in down.iter().zip(values.chunks_exact_mut(width.max(1))) {
        for (weight, row) in kernel.weights.iter().zip(rows[kernel.first * width..].chunks_exact(width.max(1))) {
            target.iter_mut().zip(row).for_each(|(value, other)| *value += weight * other);
        }
    }
    (width, height, values)
}

/// Weights of the pixels from `first` on; their sum is one.
struct Kernel {
    first: usize,
    weights: Vec<f32>,
}

impl Kernel {
    fn at(place: usize, length: usize) -> Self {
        let middle = (place as f64 + 0.5) / SCALE - 0.5;
        let sigma = SIGMA / SCALE;
        let first = (middle - REACH * sigma).ceil().max(0.0) as usize;
        let last = ((middle + REACH * sigma).floor() as usize).min(length.saturating_sub(1));
        let weights: Vec<_> =
            (first..=last).map(|pixel| (-0.5 * ((pixel as f64 - middle) / sigma).powi(2)).exp()).collect();
        let sum: f64 = weights.iter().sum();
        Self { first, weights: weights.iter().map(|weight| (weight / sum) as f32).collect() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_brighter_side_is_left_of_a_level_line() {
        let bright_right = (0..400).map(|index| if index % 20 < 10 { 40.0 } else { 200.0 }).collect();
        let lines = LevelLines::of(&GreyImage::new(20, 20, bright_right).expect("an image"));
        let steepest = lines.steepness.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1)).expect("pixels").0;
        // Left of a walk down, where y increases, is the right of the image.
        assert!(difference(lines.angles[steepest], std::f32::consts::FRAC_PI_2).abs() < 1e-4);
        // Corner 10 of the full image is corner 8 of the reduced one, between its pixels 7 and 8.
        assert_eq!(steepest % lines.width, 7);
    }
}
