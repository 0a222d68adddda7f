//! Rectangles around regions (LSD, sections 2.5 and 2.7).

use std::f32::consts::PI;

use nalgebra::{Point2, Vector2};

use super::level_lines::{LevelLines, TOLERANCE, difference};
use super::region::Region;
use super::significance::significance;

/// A rectangle along a direction; pixels of the reduced image.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rectangle {
    /// Middle of its short sides, in the direction of its level lines.
    pub(super) ends: [Point2<f64>; 2],
    /// Length of its short sides.
    pub(super) width: f64,
    /// Unit direction.
    along: Vector2<f64>,
    /// Part of all directions that count as aligned: the tolerance over half a turn.
    probability: f64,
}

impl Rectangle {
    /// The rectangle of a region: centre of gravity and main axis, weighted by the gradient.
    pub(super) fn around(lines: &LevelLines, region: &Region, tolerance: f32) -> Option<Self> {
        let place = |pixel: usize| Vector2::new((pixel % lines.width) as f64, (pixel / lines.width) as f64);
        let weight = |pixel: usize| f64::from(lines.steepness[pixel]);
        let sum: f64 = region.pixels.iter().map(|&pixel| weight(pixel)).sum();
        let centre = region.pixels.iter().map(|&pixel| place(pixel) * weight(pixel)).sum::<Vector2<f64>>() / sum;
        let (mut difference_, mut product) = (0.0, 0.0);
        for &pixel in &region.pixels {
            let offset = place(pixel) - centre;
            difference_ += weight(pixel) * (offset.x - offset.y) * (offset.x + offset.y);
            product += weight(pixel) * 2.0 * offset.x * offset.y;
        }
        let angle = 0.5 * product.atan2(difference_);
        let is_turned = difference(angle as f32, region.angle).abs() > PI / 2.0;
        let angle = if is_turned { angle + std::f64::consts::PI } else { angle };
        let along = Vector2::new(angle.cos(), angle.sin());
        let across = Vector2::new(-along.y, along.x);
        let (mut low, mut high) = (Vector2::repeat(f64::INFINITY), Vector2::repeat(-f64::INFINITY));
        for &pixel in &region.pixels {
            let offset = place(pixel) - centre;
            let offset = Vector2::new(along.dot(&offset), across.dot(&offset));
            (low, high) = (low.inf(&offset), high.sup(&offset));
        }
        let finite = angle.is_finite() && low.x.is_finite() && high.x > low.x;
        finite.then(|| Self {
            ends: [low.x, high.x].map(|position| Point2::from(centre + along * position)),
            width: (high.y - low.y).max(1.0),
            along,
            probability: f64::from(tolerance / PI),
        })
    }

    pub(super) fn length(&self) -> f64 {
        (self.ends[1] - self.ends[0]).norm()
    }

    /// Pixels of a region for each pixel of the rectangle.
    pub(super) fn density(&self, region: &Region) -> f64 {
        region.pixels.len() as f64 / (self.length() * self.width)
    }

    /// The variant of the rectangle that is the least likely by chance, with `-log10` of its number
    /// of false alarms: narrower tolerances, less width, less on one side. The search ends at the
    /// first that is no chance.
    pub(super) fn improved(self, lines: &LevelLines, log_tests: f64) -> (Self, f64) {
        let mut best = (self, self.significance(lines, log_tests));
        for change in [Self::finer, Self::narrower, Self::less_left, Self::less_right, Self::finer] {
            if best.1 > 0.0 {
                break;
            }
            let mut variant = best.0;
            for _ in 0..5 {
                variant = change(variant);
                if variant.width < 0.5 {
                    break;
                }
                let significance = variant.significance(lines, log_tests);
                if significance > best.1 {
                    best = (variant, significance);
                }
            }
        }
        best
    }

    fn finer(self) -> Self {
        Self { probability: self.probability / 2.0, ..self }
    }

    fn narrower(self) -> Self {
        Self { width: self.width - 0.5, ..self }
    }

    fn less_left(self) -> Self {
        self.less(-0.25)
    }

    fn less_right(self) -> Self {
        self.less(0.25)
    }

    /// Half a pixel less width; the middle moves to one side.
    fn less(self, side: f64) -> Self {
        let step = Vector2::new(-self.along.y, self.along.x) * side;
        Self { ends: self.ends.map(|end| end + step), ..self.narrower() }
    }

    fn significance(&self, lines: &LevelLines, log_tests: f64) -> f64 {
        let angle = self.along.y.atan2(self.along.x) as f32;
        let tolerance = (self.probability * std::f64::consts::PI) as f32;
        let (mut pixels, mut aligned) = (0, 0);
        self.visit(lines, |pixel| {
            pixels += 1;
            aligned += usize::from(lines.is_aligned(pixel, angle, tolerance));
        });
        significance(log_tests, pixels, aligned, self.probability)
    }

    /// Visits all pixels whose centre is in the rectangle, column by column: an edge of the
    /// rectangle bounds a column from above or from below.
    fn visit(&self, lines: &LevelLines, mut see: impl FnMut(usize)) {
        let half = Vector2::new(-self.along.y, self.along.x) * (0.5 * self.width);
        let [start, end] = self.ends;
        let corners = [start - half, end - half, end + half, start + half];
        let low = corners.iter().map(|corner| corner.x).fold(f64::INFINITY, f64::min);
        let high = corners.iter().map(|corner| corner.x).fold(-f64::INFINITY, f64::max);
        for column in low.ceil().max(0.0) as usize..lines.width {
            let x = column as f64;
            if x > high {
                break;
            }
            let (mut top, mut bottom) = (f64::INFINITY, -f64::INFINITY);
            for side in 0..4 {
                let (from, to) = (corners[side], corners[(side + 1) % 4]);
                if (from.x <= x) == (to.x <= x) && from.x != x && to.x != x {
                    continue;
                }
                let part = if from.x == to.x { 0.0 } else { ((x - from.x) / (to.x - from.x)).clamp(0.0, 1.0) };
                let y = from.y + (to.y - from.y) * part;
                let ys = if from.x == to.x { [from.y, to.y] } else { [y, y] };
                (top, bottom) = (top.min(ys[0]).min(ys[1]), bottom.max(ys[0]).max(ys[1]));
            }
            for row in top.ceil().max(0.0) as usize..lines.height {
                if row as f64 > bottom {
                    break;
                }
                see(row * lines.width + column);
            }
        }
    }
}

/// The default tolerance as that of a rectangle.
pub(super) const PROBABILITY: f64 = TOLERANCE as f64 / std::f64::consts::PI;
