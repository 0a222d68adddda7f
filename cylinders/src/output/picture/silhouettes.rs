//! An image with the lines that were given and the silhouettes of the cylinders that were found.

use nalgebra::{Point2, Point3, Vector3};
use plotters::element::{Circle as Dot, PathElement};
use plotters::prelude::DrawingBackend;
use plotters::style::{Color, ShapeStyle};

use super::axes::{Entry, Extent, Mark, frame, frame_size, height_for, legend, legend_width, stroke};
use super::clip::Window;
use super::{Area, Drawn, Picture, rgb, units};
use crate::output::palette::{self, GIVEN, GREY};
use crate::space::extent::image_corners;
use crate::{Camera, Cylinder, CylinderLines, Scene};

/// Width of the picture without the legend, units.
const WIDTH: u32 = 640;

/// Least and largest height of the picture, units.
const HEIGHT: (f64, f64) = (300.0, 1000.0);

/// The silhouettes in an image, pixels; normalised coordinates for a camera without calibration.
#[derive(Clone, Debug)]
pub struct SilhouettePicture {
    title: String,
    unit: &'static str,
    window: Window,
    given: Vec<Given>,
    /// Index of the cylinder, start of its legend, silhouettes and axis.
    found: Vec<(usize, String, [Vector3<f64>; 3])>,
    points: Vec<(Point2<f64>, palette::Colour)>,
}

/// A given line.
#[derive(Clone, Copy, Debug)]
enum Given {
    Line(Vector3<f64>),
    Segment([Point2<f64>; 2]),
}

impl SilhouettePicture {
    /// The image of a view of the scene, by its index, with all its lines and with the cylinders
    /// that have lines in it. `None` if there is no such view.
    pub fn new(scene: &Scene, found: &[(CylinderLines, Cylinder)], view: usize) -> Option<Self> {
        let (index, view) = (view, scene.views.get(view)?);
        let camera = view.camera();
        let calibration = camera.calibration();
        let line = |line: &Vector3<f64>| upward_line(&calibration.map_or(*line, |known| known.line_to_pixels(line)));
        let point = |point: &Point2<f64>| upward(&calibration.map_or(*point, |known| known.point_to_pixels(point)));
        let window = Window::around(image_corners(camera).iter().map(point));

        let seen = |(number, (lines, cylinder)): (usize, &(CylinderLines, Cylinder))| {
            lines.views.get(index).filter(|view| !view.lines().is_empty())?;
            let [right, left] = cylinder.silhouette(camera)?;
            let label = lines.label.as_ref().map_or(String::new(), |label| format!("{label}: "));
            Some((number, label, [right, left, axis(cylinder, camera)].map(|silhouette| line(&silhouette))))
        };
        let given = |(given, ends): (&Vector3<f64>, &Option<[Point2<f64>; 2]>)| match ends {
            Some(ends) => Given::Segment([point(&ends[0]), point(&ends[1])]),
            None => Given::Line(line(given)),
        };
        let pixel = |world: &Point3<f64>| {
            let seen = camera.rotation() * world.coords + camera.translation();
            let image = (seen.z > 0.0).then(|| point(&Point2::from(seen.xy() / seen.z)))?;
            let on = found.iter().position(|(_, cylinder)| cylinder.is_near(world));
            window.contains(&image).then(|| (image, on.map_or(GREY, palette::series)))
        };
        Some(Self {
            title: view.image().map_or(format!("view {index}"), str::to_owned),
            unit: if calibration.is_some() { "pixels" } else { "normalised" },
            window,
            given: view.lines().iter().zip(view.ends()).map(given).collect(),
            found: found.iter().enumerate().filter_map(seen).collect(),
            points: scene.points.iter().filter_map(pixel).collect(),
        })
    }

    fn entries(&self) -> Vec<Entry> {
        let entry = |mark, colour, label: String| Entry { mark, colour, label };
        let mut entries = vec![entry(Mark::Line, GIVEN, "line given".to_owned())];
        for (number, label, _) in &self.found {
            let colour = palette::series(*number);
            entries.push(entry(Mark::Line, colour, format!("{label}silhouettes, axis")));
            if !self.points.is_empty() {
                entries.push(entry(Mark::Dot, colour, format!("{label}points on the surface")));
            }
        }
        if !self.points.is_empty() {
            entries.push(entry(Mark::Dot, GREY, "other points".to_owned()));
        }
        entries
    }
}

/// The image of the axis: the plane through the axis and the camera centre.
fn axis(cylinder: &Cylinder, camera: &Camera) -> Vector3<f64> {
    camera.rotation() * cylinder.direction.cross(&(cylinder.axis_point - camera.centre()))
}

/// The coordinate `y` of an image points down.
fn upward(point: &Point2<f64>) -> Point2<f64> {
    Point2::new(point.x, -point.y)
}

fn upward_line(line: &Vector3<f64>) -> Vector3<f64> {
    Vector3::new(line.x, -line.y, line.z)
}

impl Picture for SilhouettePicture {
    fn size(&self) -> (u32, u32) {
        let size = self.window.high - self.window.low;
        let height = height_for(f64::from(WIDTH), size.y / size.x);
        (WIDTH + legend_width(&self.entries()), height.clamp(HEIGHT.0, HEIGHT.1) as u32)
    }

    fn draw<DB: DrawingBackend>(&self, area: &Area<DB>) -> Drawn<DB> {
        let (area, beside) = area.split_horizontally(units(f64::from(WIDTH)));
        legend(&beside, &self.entries())?;
        let window = self.window.widened(0.0, frame_size(&area));
        let x = Extent::exactly([window.low.x, window.high.x]);
        let y = Extent::exactly([window.low.y, window.high.y]).downward();
        let labels = [format!("x / {}", self.unit), format!("y / {}", self.unit)];
        let chart = frame(&area, &self.title, (&labels[0], x), (&labels[1], y))?;
        let area = chart.plotting_area();
        for (point, colour) in &self.points {
            area.draw(&Dot::new((point.x, point.y), units(1.0), rgb(*colour).filled()))?;
        }
        let segment = |ends: Option<[Point2<f64>; 2]>, style: ShapeStyle| {
            let path = ends.map(|ends| PathElement::new(ends.map(|end| (end.x, end.y)), style));
            path.iter().try_for_each(|path| area.draw(path))
        };
        let line = |line: &Vector3<f64>, style: ShapeStyle| segment(self.window.line(line), style);
        for (number, _, [right, left, axis]) in &self.found {
            let colour = rgb(palette::series(*number));
            line(right, stroke(colour, 3.5))?;
            line(left, stroke(colour, 3.5))?;
            line(axis, stroke(colour.mix(0.6), 1.0))?;
        }
        // The line is thinner and drawn above, so that both are visible if they agree.
        for given in &self.given {
            let inside = match given {
                Given::Line(line) => self.window.line(line),
                Given::Segment(ends) => self.window.segment(*ends),
            };
            segment(inside, stroke(rgb(GIVEN), 1.5))?;
        }
        let corners = [self.window.low, self.window.high].map(|corner| (corner.x, corner.y));
        area.draw(&plotters::element::Rectangle::new(corners, stroke(rgb(GREY), 1.0)))
    }
}
