//! The cross-section of a cylinder: seen along its axis, with the cameras and the tangent lines, as
//! a whole and near the circle.

use std::f64::consts::TAU;

use nalgebra::{Point2, Vector2};
use plotters::element::{Circle as Dot, PathElement};
use plotters::prelude::DrawingBackend;
use plotters::style::{Color, ShapeStyle};

use super::axes::{Entry, Extent, Mark, frame, frame_size, legend, legend_width, stroke};
use super::clip::Window;
use super::{Area, Drawn, Picture, rgb, units};
use crate::cross_section::rectify::{Rectification, TangentLine};
use crate::output::palette::{self, GIVEN, GREY};
use crate::{Circle, Cylinder, CylinderLines, LeastSquares, Section, SectionLine, SectionSolver, View};

/// Side of each of the two squares, units.
const SIDE: u32 = 560;

/// Number of sides of the polygon that approximates a circle.
const SIDES: usize = 360;

/// Index of the circle's colour among the colours of the results.
const FOUND: usize = 0;

/// The cross-section through the axis point of a cylinder, with the axis at the origin, seen
/// against its direction.
#[derive(Clone, Debug)]
pub struct SectionPicture {
    title: String,
    cameras: Vec<Point2<f64>>,
    lines: Vec<(TangentLine, Point2<f64>)>,
    best: Circle,
    others: Vec<Circle>,
}

impl SectionPicture {
    /// The cylinder with the lines of these views. Lines across the axis are left out.
    pub fn new(title: String, cylinder: &Cylinder, views: &[View]) -> Self {
        let rectification = Rectification::new(&cylinder.direction, cylinder.axis_point);
        let seen = views.iter().filter(|view| !view.lines().is_empty());
        let cameras = seen.map(|view| rectification.point(&view.camera().centre())).collect();
        let planes = views.iter().flat_map(View::planes);
        let line = |plane| Some((rectification.line(&plane)?, rectification.point(&plane.centre)));
        let best = Circle { centre: Point2::origin(), radius: cylinder.radius };
        Self { title, cameras, lines: planes.filter_map(line).collect(), best, others: Vec::new() }
    }

    /// The cross-section of a cylinder by its lines, with all stationary circles of their least
    /// squares cost.
    pub fn of_cylinder(lines: &CylinderLines, cylinder: &Cylinder) -> Self {
        let title =
            lines.label.as_ref().map_or("cross-section".to_owned(), |label| format!("cross-section of {label}"));
        let picture = Self::new(title, cylinder, &lines.views);
        let tangents: Vec<_> = picture.lines().map(|line| SectionLine { line, weight: 1.0, view: 0 }).collect();
        // If the solver fails, there are no stationary circles to draw.
        let sections = LeastSquares.solve(&tangents).unwrap_or_default();
        picture.with_others(sections.iter().skip(1).filter_map(Section::circle).collect())
    }

    /// The same picture, with the other circles at which the cost is stationary; in the coordinates
    /// of [`Self::lines`].
    pub fn with_others(self, others: Vec<Circle>) -> Self {
        Self { others, ..self }
    }

    /// The tangent lines of the cross-section.
    pub fn lines(&self) -> impl Iterator<Item = TangentLine> {
        self.lines.iter().map(|(line, _)| *line)
    }

    fn entries(&self) -> Vec<Entry> {
        let entry = |mark, colour, label: &str| Entry { mark, colour, label: label.to_owned() };
        let mut entries = vec![
            entry(Mark::Line, palette::series(FOUND), "cylinder"),
            entry(Mark::Line, GIVEN, "silhouette line"),
            entry(Mark::Dot, GIVEN, "camera"),
        ];
        if !self.others.is_empty() {
            entries.push(entry(Mark::Line, GREY, "other stationary circle"));
        }
        entries
    }

    fn panel<DB: DrawingBackend>(&self, area: &Area<DB>, title: &str, shown: &[Point2<f64>], margin: f64) -> Drawn<DB> {
        let window = Window::around(shown.iter().map(upward)).widened(margin, frame_size(area));
        let x = Extent::exactly([window.low.x, window.high.x]);
        let y = Extent::exactly([window.low.y, window.high.y]).downward();
        let chart = frame(area, title, ("x / world units", x), ("z / world units", y))?;
        let area = chart.plotting_area();
        let path = |points: &[Point2<f64>], style: ShapeStyle| {
            let points: Vec<_> = points.iter().map(upward).collect();
            let coordinates = |part: &Vec<Point2<f64>>| part.iter().map(|point| (point.x, point.y)).collect::<Vec<_>>();
            let parts = window.path(&points);
            parts.iter().try_for_each(|part| area.draw(&PathElement::new(coordinates(part), style)))
        };
        let circle = |circle: &Circle, style: ShapeStyle| {
            let point = |index: usize| {
                let angle = TAU * index as f64 / SIDES as f64;
                circle.centre + Vector2::new(angle.cos(), angle.sin()) * circle.radius
            };
            path(&(0..=SIDES).map(point).collect::<Vec<_>>(), style)
        };
        for other in &self.others {
            circle(other, stroke(rgb(GREY), 1.0))?;
        }
        circle(&self.best, stroke(rgb(palette::series(FOUND)), 2.5))?;
        for (line, camera) in &self.lines {
            // From the camera to a diameter behind the contact.
            let contact = self.best.centre - line.normal * line.distance(&self.best.centre);
            let sight = contact - camera;
            let end = contact + sight * (2.0 * self.best.radius / sight.norm());
            path(&[*camera, end], stroke(rgb(GIVEN).mix(0.8), 1.0))?;
        }
        for camera in self.cameras.iter().map(upward).filter(|camera| window.contains(camera)) {
            area.draw(&Dot::new((camera.x, camera.y), units(4.0), rgb(GIVEN).filled()))?;
        }
        Ok(())
    }
}

/// `z` points down, the axis at the eye: a right-handed frame.
fn upward(point: &Point2<f64>) -> Point2<f64> {
    Point2::new(point.x, -point.y)
}

impl Picture for SectionPicture {
    fn size(&self) -> (u32, u32) {
        (2 * SIDE + legend_width(&self.entries()), SIDE)
    }

    fn draw<DB: DrawingBackend>(&self, area: &Area<DB>) -> Drawn<DB> {
        let side = units(f64::from(SIDE));
        let (left, rest) = area.split_horizontally(side);
        let (right, beside) = rest.split_horizontally(side);
        let Circle { centre, radius } = self.best;
        let around = [Vector2::new(-radius, -radius), Vector2::new(radius, radius)].map(|corner| centre + corner);
        let all: Vec<_> = self.cameras.iter().copied().chain(around).collect();
        self.panel(&left, &self.title, &all, 0.06)?;
        self.panel(&right, "near the cylinder", &around, 0.3)?;
        legend(&beside, &self.entries())
    }
}
