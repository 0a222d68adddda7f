//! The part of a line inside a window.

use nalgebra::{Point2, Vector3};

/// A rectangle with sides along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Window {
    pub(super) low: Point2<f64>,
    pub(super) high: Point2<f64>,
}

impl Window {
    /// The least window around some points.
    pub(super) fn around(points: impl IntoIterator<Item = Point2<f64>>) -> Self {
        let nothing =
            Self { low: Point2::new(f64::INFINITY, f64::INFINITY), high: Point2::new(-f64::INFINITY, -f64::INFINITY) };
        points
            .into_iter()
            .fold(nothing, |window, point| Self { low: window.low.inf(&point), high: window.high.sup(&point) })
    }

    /// The least window around this one, with a margin on all sides. The ratio of its sides is that
    /// of `frame`.
    pub(super) fn widened(&self, margin: f64, frame: [f64; 2]) -> Self {
        let size = self.high - self.low;
        let scale = (size.x / frame[0]).max(size.y / frame[1]) * (1.0 + 2.0 * margin);
        let (middle, half) = (nalgebra::center(&self.low, &self.high), nalgebra::Vector2::from(frame) * scale / 2.0);
        Self { low: middle - half, high: middle + half }
    }

    pub(super) fn contains(&self, point: &Point2<f64>) -> bool {
        self.low <= *point && *point <= self.high
    }

    /// The part of a segment inside (Liang & Barsky, "A new concept and method for line clipping",
    /// 1984).
    pub(super) fn segment(&self, [start, end]: [Point2<f64>; 2]) -> Option<[Point2<f64>; 2]> {
        let direction = end - start;
        let (mut first, mut last) = (0.0_f64, 1.0_f64);
        for axis in 0..2 {
            let bounds = [self.low[axis] - start[axis], self.high[axis] - start[axis]];
            if direction[axis] == 0.0 {
                if bounds[0] > 0.0 || bounds[1] < 0.0 {
                    return None;
                }
                continue;
            }
            let [enter, leave] = bounds.map(|bound| bound / direction[axis]);
            first = first.max(enter.min(leave));
            last = last.min(enter.max(leave));
        }
        // Ends inside the window are not changed, so that the segments of a path stay connected.
        let at = |position: f64| if position == 1.0 { end } else { start + direction * position };
        (first < last).then(|| [at(first), at(last)])
    }

    /// The parts of a path inside the window, each a connected polyline.
    pub(super) fn path(&self, points: &[Point2<f64>]) -> Vec<Vec<Point2<f64>>> {
        let mut parts: Vec<Vec<Point2<f64>>> = Vec::new();
        for [start, end] in points.windows(2).filter_map(|pair| self.segment([pair[0], pair[1]])) {
            match parts.last_mut() {
                Some(part) if part.last() == Some(&start) => part.push(end),
                _ => parts.push(vec![start, end]),
            }
        }
        parts
    }

    /// The part of a line `(a, b, c)` inside the window.
    pub(super) fn line(&self, line: &Vector3<f64>) -> Option<[Point2<f64>; 2]> {
        let (middle, normal) = (nalgebra::center(&self.low, &self.high), line.xy());
        let foot = middle - normal * (line.dot(&middle.to_homogeneous()) / normal.norm_squared());
        let along = nalgebra::Vector2::new(-normal.y, normal.x).normalize() * (self.high - self.low).norm();
        self.segment([foot - along, foot + along])
    }
}
