//! Conics of the cross-section that several methods found for the same tangent lines.

use std::f64::consts::TAU;

use nalgebra::{Matrix2, Matrix3, Point2, SymmetricEigen, Vector2};
use plotters::element::PathElement;
use plotters::prelude::DrawingBackend;
use plotters::style::Color;

use super::axes::{Entry, Extent, Mark, frame, frame_size, legend, legend_width, stroke};
use super::clip::Window;
use super::style::draw_path;
use super::{Area, Drawn, Picture, rgb, units};
use crate::cross_section::rectify::TangentLine;
use crate::output::palette::{self, GIVEN};

/// Side of the square, units.
const SIDE: u32 = 560;

/// Number of segments of the polyline that approximates a branch.
const PARTS: usize = 720;

/// Conics with the lines that they should touch, inside a square.
#[derive(Clone, Debug)]
pub struct ConicPicture {
    /// Title.
    pub title: String,
    /// The lines.
    pub lines: Vec<TangentLine>,
    /// Names and dual conics, scaled so that the last entry is -1; circles, ellipses and
    /// hyperbolas.
    pub conics: Vec<(String, Matrix3<f64>)>,
    /// Middle of the square, world units.
    pub middle: Point2<f64>,
    /// Half of its side, world units.
    pub half_side: f64,
}

impl ConicPicture {
    fn entries(&self) -> Vec<Entry> {
        let conic = |(index, (label, _)): (usize, &(String, _))| Entry {
            mark: Mark::Series(index),
            colour: palette::series(index),
            label: label.clone(),
        };
        let lines = Entry { mark: Mark::Line, colour: GIVEN, label: "tangent line".to_owned() };
        self.conics.iter().enumerate().map(conic).chain([lines]).collect()
    }
}

impl Picture for ConicPicture {
    fn size(&self) -> (u32, u32) {
        (SIDE + legend_width(&self.entries()), SIDE)
    }

    fn draw<DB: DrawingBackend>(&self, area: &Area<DB>) -> Drawn<DB> {
        let (area, beside) = area.split_horizontally(units(f64::from(SIDE)));
        let half = Vector2::new(self.half_side, self.half_side);
        let window = Window::around([self.middle - half, self.middle + half]).widened(0.0, frame_size(&area));
        let x = Extent::exactly([window.low.x, window.high.x]);
        let y = Extent::exactly([window.low.y, window.high.y]);
        let chart = frame(&area, &self.title, ("x / world units", x), ("z / world units", y))?;
        let area = chart.plotting_area();
        let parts = |points: &[Point2<f64>]| {
            let coordinates = |part: Vec<Point2<f64>>| part.iter().map(|point| (point.x, point.y)).collect();
            window.path(points).into_iter().map(coordinates).collect::<Vec<Vec<_>>>()
        };
        // The branch is long enough to cross the window wherever it enters.
        let reach = 4.0 * (window.high - window.low).norm();
        for line in &self.lines {
            let foot = self.middle - line.normal * line.distance(&self.middle);
            let along = Vector2::new(-line.normal.y, line.normal.x) * reach;
            for part in parts(&[foot - along, foot + along]) {
                area.draw(&PathElement::new(part, stroke(rgb(GIVEN).mix(0.5), 0.8)))?;
            }
        }
        for (index, (_, dual_conic)) in self.conics.iter().enumerate() {
            for branch in branches(dual_conic, reach) {
                parts(&branch).iter().try_for_each(|part| draw_path(area, index, part))?;
            }
        }
        legend(&beside, &self.entries())
    }
}

/// The curve as polylines, a hyperbola up to the distance `reach` from its centre. Empty if the
/// conic has no real points.
///
/// In the principal axes of `M` (see the module `section`), with eigenvalues `m1 >= m2`, the curve
/// is `sqrt(m1) cos t, sqrt(m2) sin t` for an ellipse and `+-sqrt(m1) cosh t, sqrt(-m2) sinh t` for
/// a hyperbola.
fn branches(dual_conic: &Matrix3<f64>, reach: f64) -> Vec<Vec<Point2<f64>>> {
    let centre = -dual_conic.fixed_view::<2, 1>(0, 2).into_owned();
    let matrix: Matrix2<f64> = dual_conic.fixed_view::<2, 2>(0, 0) + centre * centre.transpose();
    let eigen = SymmetricEigen::new(matrix);
    let (large, small) = if eigen.eigenvalues[0] >= eigen.eigenvalues[1] { (0, 1) } else { (1, 0) };
    let axis = |index: usize| eigen.eigenvectors.column(index) * eigen.eigenvalues[index].abs().sqrt();
    let (first, second) = (axis(large), axis(small));
    let curve = |parameter: fn(f64) -> (f64, f64), from: f64, to: f64, sign: f64| {
        let point = |part: usize| {
            let (along_first, along_second) = parameter(from + (to - from) * part as f64 / PARTS as f64);
            Point2::from(centre + first * (sign * along_first) + second * along_second)
        };
        (0..=PARTS).map(point).collect()
    };
    if eigen.eigenvalues[large] <= 0.0 {
        Vec::new()
    } else if eigen.eigenvalues[small] > 0.0 {
        vec![curve(|angle| (angle.cos(), angle.sin()), 0.0, TAU, 1.0)]
    } else {
        let end = (reach / first.norm().min(second.norm()).max(f64::MIN_POSITIVE)).asinh();
        [1.0, -1.0].map(|sign| curve(|t| (t.cosh(), t.sinh()), -end, end, sign)).into()
    }
}
