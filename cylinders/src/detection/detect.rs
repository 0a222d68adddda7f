//! The detector: steep pixels first, each grown to a region and this to a rectangle.

use nalgebra::{Point2, distance};

use super::grey::GreyImage;
use super::level_lines::{LevelLines, SCALE, TOLERANCE, difference};
use super::rectangle::{PROBABILITY, Rectangle};
use super::region::{Region, grow};
use super::significance::log_tests;
use super::subpixel::refined;
use crate::numerics::interrupt::{Interrupt, Interrupted};

/// Number of classes of steepness by which pixels are ordered.
const CLASSES: f32 = 1024.0;

/// Least part of a rectangle that its region fills.
const DENSITY: f64 = 0.7;

/// Factor by which the radius of a region is reduced until it is dense.
const RADIUS_STEP: f64 = 0.75;

/// A line segment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DetectedSegment {
    /// End points, pixels from the upper left corner. On a walk from the first to the second, with
    /// `y` pointing down, the brighter side is on the left as `(dy, -dx)` points: the normal
    /// `(y2 - y1, x1 - x2)` points to the bright side.
    pub ends: [Point2<f64>; 2],
    /// Width of the edge, pixels.
    pub width: f64,
    /// `-log10` of the number of segments as good that noise would give in this image.
    pub significance: f64,
}

impl DetectedSegment {
    /// Length, pixels.
    pub fn length(&self) -> f64 {
        distance(&self.ends[0], &self.ends[1])
    }
}

/// The line segments of an image, those of the steepest edges first. Values are expected from 0 to
/// 255; an edge needs a contrast of five. Segments lie between pixels that are known.
pub fn detect_segments(image: &GreyImage) -> Vec<DetectedSegment> {
    // Nothing interrupts it.
    segments(image, Interrupt::never()).unwrap_or_default()
}

/// The same, until it is interrupted.
pub(crate) fn segments(image: &GreyImage, interrupt: Interrupt<'_>) -> Result<Vec<DetectedSegment>, Interrupted> {
    let lines = LevelLines::of(image);
    if lines.angles.is_empty() {
        return Ok(Vec::new());
    }
    let log_tests = log_tests(lines.width + 1, lines.height + 1);
    let least_size = (-log_tests / PROBABILITY.log10()).ceil() as usize;
    let mut used: Vec<_> = lines.angles.iter().map(|angle| angle.is_nan()).collect();
    let mut found = Vec::new();
    for seed in by_steepness(&lines) {
        if used[seed] {
            continue;
        }
        interrupt.check()?;
        let region = grow(&lines, seed, TOLERANCE, &mut used);
        if region.pixels.len() < least_size {
            continue;
        }
        let Some(rectangle) = dense(&lines, region, &mut used) else { continue };
        let (rectangle, significance) = rectangle.improved(&lines, log_tests);
        if significance > 0.0 {
            // A gradient belongs to the corner between its four pixels.
            let ends = rectangle.ends.map(|end| Point2::new(end.x + 1.0, end.y + 1.0) / SCALE);
            let ends = refined(image, ends);
            found.push(DetectedSegment { ends, width: rectangle.width / SCALE, significance });
        }
    }
    Ok(found)
}

/// The pixels that have a direction, in classes of steepness, the steepest first.
fn by_steepness(lines: &LevelLines) -> Vec<usize> {
    let steepest = lines.steepness.iter().copied().fold(0.0, f32::max);
    let class = |pixel: &usize| (lines.steepness[*pixel] / steepest * (CLASSES - 1.0)) as u16;
    let mut pixels: Vec<_> = (0..lines.angles.len()).filter(|&pixel| !lines.angles[pixel].is_nan()).collect();
    // The order within a class is that of the pixels.
    pixels.sort_by_key(|pixel| std::cmp::Reverse(class(pixel)));
    pixels
}

/// The rectangle of a region, or of the part of it that fills its rectangle: first with a tolerance
/// that suits the directions near the seed, then the surroundings of the seed alone.
fn dense(lines: &LevelLines, region: Region, used: &mut [bool]) -> Option<Rectangle> {
    let rectangle = Rectangle::around(lines, &region, TOLERANCE)?;
    if rectangle.density(&region) >= DENSITY {
        return Some(rectangle);
    }
    let seed = region.pixels[0];
    let centre = place(lines, seed);
    let near = region.pixels.iter().filter(|&&pixel| distance(&place(lines, pixel), &centre) < rectangle.width);
    let (mut sum, mut squares, mut count) = (0.0, 0.0, 0.0);
    for &pixel in near {
        let turn = difference(lines.angles[pixel], lines.angles[seed]);
        (sum, squares, count) = (sum + turn, squares + turn * turn, count + 1.0);
    }
    let mean: f32 = sum / count;
    let tolerance = 2.0 * (squares / count - mean * mean).max(0.0).sqrt();
    region.pixels.iter().for_each(|&pixel| used[pixel] = false);
    let region = grow(lines, seed, tolerance, used);
    shortened(lines, region, tolerance, used)
}

/// The part of a region around its seed that is dense.
fn shortened(lines: &LevelLines, mut region: Region, tolerance: f32, used: &mut [bool]) -> Option<Rectangle> {
    let mut rectangle = Rectangle::around(lines, &region, tolerance)?;
    let seed = place(lines, region.pixels[0]);
    let mut radius = rectangle.ends.iter().map(|end| distance(end, &seed)).fold(0.0, f64::max);
    while rectangle.density(&region) < DENSITY {
        radius *= RADIUS_STEP;
        region.pixels.retain(|&pixel| {
            let stays = distance(&place(lines, pixel), &seed) <= radius;
            used[pixel] = stays;
            stays
        });
        // Fewer than two pixels have no rectangle.
        rectangle = Rectangle::around(lines, &region, tolerance)?;
    }
    Some(rectangle)
}

fn place(lines: &LevelLines, pixel: usize) -> Point2<f64> {
    Point2::new((pixel % lines.width) as f64, (pixel / lines.width) as f64)
}
