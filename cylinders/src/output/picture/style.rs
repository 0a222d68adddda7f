//! Dashes and markers of series. Colour alone does not tell curves apart in print, and a curve
//! would hide another one below it.

use plotters::coord::ranged1d::Ranged;
use plotters::coord::cartesian::Cartesian2d;
use plotters::drawing::DrawingArea;
use plotters::element::{Circle, DashedPathElement, PathElement};
use plotters::prelude::{DrawingBackend, EmptyElement};
use plotters::style::{Color, ShapeStyle};

use super::axes::stroke;
use super::{Area, Drawn, rgb, units};
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

/// The stroke of a series.
pub(super) fn series_stroke(index: usize) -> ShapeStyle {
    stroke(rgb(palette::series(index)), width(index))
}

/// Draws a path with the dashes and the colour of a series.
pub(super) fn draw_path<DB: DrawingBackend, X: Ranged, Y: Ranged>(
    area: &DrawingArea<DB, Cartesian2d<X, Y>>,
    index: usize,
    points: &[(X::ValueType, Y::ValueType)],
) -> Drawn<DB>
where
    X::ValueType: Clone + 'static,
    Y::ValueType: Clone + 'static,
{
    match DASHES[index % DASHES.len()] {
        None => area.draw(&PathElement::new(points.to_vec(), series_stroke(index))),
        Some((dash, gap)) => {
            let (dash, gap) = (units(dash), units(gap));
            area.draw(&DashedPathElement::new(points.to_vec(), dash, gap, series_stroke(index)))
        }
    }
}
