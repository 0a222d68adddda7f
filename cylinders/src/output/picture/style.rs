//! Dashes and markers of series. Colour alone does not tell curves apart in print, and a curve
//! would hide another one below it.

use plotters::coord::CoordTranslate;
use plotters::drawing::DrawingArea;
use plotters::element::{Circle, DashedPathElement, PathElement};
use plotters::prelude::{DrawingBackend, EmptyElement};
use plotters::style::{Color, ShapeStyle};

use super::{Drawn, rgb, units};
use crate::output::palette;

/// Lengths of dash and gap for each series in turn, units; no dashes for the first. A later series
/// is drawn above an earlier one, which shows through its gaps.
const DASHES: [Option<(f64, f64)>; 6] =
    [None, Some((11.0, 6.0)), Some((4.0, 5.0)), Some((20.0, 8.0)), Some((7.0, 12.0)), Some((2.0, 4.0))];

/// Corners of the marker of each series in turn, radii: polygons, and open strokes if the ends
/// differ. The first marker is a filled dot, and none covers it.
const CORNERS: [&[(f64, f64)]; 6] = [
    &[],
    &[(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0)],
    &[(0.0, -1.3), (1.2, 0.8), (-1.2, 0.8), (0.0, -1.3)],
    &[(0.0, -1.5), (1.5, 0.0), (0.0, 1.5), (-1.5, 0.0), (0.0, -1.5)],
    &[(-1.0, -1.0), (1.0, 1.0), (0.0, 0.0), (-1.0, 1.0), (1.0, -1.0)],
    &[(0.0, -1.4), (0.0, 1.4), (0.0, 0.0), (-1.4, 0.0), (1.4, 0.0)],
];

/// Radius of a marker, units.
const MARKER: f64 = 4.5;

/// Width of the line of a series, units: later series are thinner.
fn width(index: usize) -> f64 {
    if index == 0 { 2.6 } else { 1.8 }
}

/// A line of this width, units.
pub(super) fn stroke(colour: impl Color, width: f64) -> ShapeStyle {
    ShapeStyle { color: colour.to_rgba(), filled: false, stroke_width: units(width) as u32 }
}

/// The stroke of a series.
pub(super) fn series_stroke(index: usize) -> ShapeStyle {
    stroke(rgb(palette::series(index)), width(index))
}

/// Draws a path with the dashes and the colour of a series.
pub(super) fn draw_path<DB: DrawingBackend, C: CoordTranslate>(
    area: &DrawingArea<DB, C>,
    index: usize,
    points: &[C::From],
) -> Drawn<DB>
where
    C::From: Clone,
{
    match DASHES[index % DASHES.len()] {
        None => area.draw(&PathElement::new(points.to_vec(), series_stroke(index))),
        Some((dash, gap)) => {
            let points = points.to_vec();
            area.draw(&DashedPathElement::new(points, units(dash), units(gap), series_stroke(index)))
        }
    }
}

/// Draws the marker of a series at a point.
pub(super) fn draw_marker<DB: DrawingBackend, C: CoordTranslate>(
    area: &DrawingArea<DB, C>,
    index: usize,
    point: C::From,
) -> Drawn<DB>
where
    C::From: Clone,
{
    let colour = rgb(palette::series(index));
    match CORNERS[index % CORNERS.len()] {
        [] => area.draw(&Circle::new(point, units(3.2), colour.filled())),
        corners => {
            let corners = corners.iter().map(|&(x, y)| (units(MARKER * x), units(MARKER * y))).collect::<Vec<_>>();
            area.draw(&(EmptyElement::at(point) + PathElement::new(corners, stroke(colour, 1.4))))
        }
    }
}
