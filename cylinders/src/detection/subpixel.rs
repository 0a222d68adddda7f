//! The place of an edge between pixels.
//!
//! Across the edge the image rises from dark to bright. In steps along the segment the place of the
//! edge is the centre of gravity of the rise, and a line is fitted to these places, weighted by the
//! contrast. The places are measured again from the fitted line, because the rise is cut off at the
//! same distance on both sides of it.

use nalgebra::{Matrix2, Point2, Vector2};

use super::grey::GreyImage;

/// Distance up to which the rise is looked at, pixels.
const REACH: f64 = 2.0;
/// Samples of the rise on each side.
const SAMPLES: i32 = 5;
/// Number of fits.
const FITS: usize = 3;
/// Least number of places.
const LEAST_PLACES: usize = 8;
/// Largest distance by which an end is moved, pixels.
const LARGEST_MOVE: f64 = 1.5;
/// A place is trusted if the rise is this large, grey values.
const LEAST_CONTRAST: f64 = 5.0;

/// The ends of a segment moved across it to the edge; as they were if the edge is not clear.
pub(super) fn refined(image: &GreyImage, ends: [Point2<f64>; 2]) -> [Point2<f64>; 2] {
    let mut moved = ends;
    for _ in 0..FITS {
        match fitted(image, moved) {
            Some(next) => moved = next,
            None => return ends,
        }
    }
    let is_near = |(new, old): (&Point2<f64>, &Point2<f64>)| (new - old).norm() <= LARGEST_MOVE;
    if moved.iter().zip(&ends).all(is_near) { moved } else { ends }
}

/// Weighted least squares of `offset = a + b s` over the places at `s` along the segment, from -1
/// at its start to 1 at its end.
fn fitted(image: &GreyImage, [start, end]: [Point2<f64>; 2]) -> Option<[Point2<f64>; 2]> {
    let (middle, half) = (nalgebra::center(&start, &end), (end - start) / 2.0);
    let along = half.normalize();
    // Points to the bright side.
    let normal = Vector2::new(along.y, -along.x);
    let steps = half.norm().floor();
    let (mut matrix, mut right, mut count) = (Matrix2::zeros(), Vector2::zeros(), 0);
    let mut step = -steps;
    while step <= steps {
        let s = step / half.norm();
        if let Some((offset, contrast)) = place(image, &(middle + half * s), &normal) {
            let row = Vector2::new(1.0, s);
            matrix += row * row.transpose() * (contrast * contrast);
            right += row * (offset * contrast * contrast);
            count += 1;
        }
        step += 1.0;
    }
    let solution = matrix.try_inverse()? * right;
    let finite = count >= LEAST_PLACES && solution.iter().all(|entry| entry.is_finite());
    finite.then(|| [start + normal * (solution.x - solution.y), end + normal * (solution.x + solution.y)])
}

/// Centre of gravity of the rise along the normal, pixels from the point, and the rise itself.
fn place(image: &GreyImage, point: &Point2<f64>, normal: &Vector2<f64>) -> Option<(f64, f64)> {
    let spacing = REACH / f64::from(SAMPLES);
    let value = |index: i32| f64::from(image.at(&(point + normal * (f64::from(index) * spacing))));
    let (mut sum, mut moment, mut before) = (0.0, 0.0, value(-SAMPLES));
    for index in 1 - SAMPLES..=SAMPLES {
        let next = value(index);
        let rise = (next - before).max(0.0);
        if next.is_nan() || before.is_nan() {
            return None;
        }
        sum += rise;
        moment += rise * (f64::from(index) - 0.5) * spacing;
        before = next;
    }
    (sum >= LEAST_CONTRAST).then(|| (moment / sum, sum))
}
