//! A view of the scene as an SVG element: the photograph, the given lines and the silhouettes, in
//! pixels of the photograph. Straight lines are bent where the lens bends them. The photograph is
//! in the element, so that it needs no other file.

use std::fmt::Write;
use std::path::PathBuf;

use nalgebra::{Point2, Vector2, Vector3};

use super::data_url::data_url;
use super::escape::escaped;
use super::image_file::{self, ImageFile};
use crate::output::palette::{self, Colour, GIVEN};
use crate::{Cylinder, CylinderLines, Scene, View};

/// Pixels to the unit of normalised coordinates for a camera without calibration.
const SCALE: f64 = 1000.0;

/// Number of points of a line that is bent.
const POINTS: usize = 129;

/// Largest angle between a point of a line and the one nearest to the optical axis, radians.
const FARTHEST: f64 = 1.5;

/// Largest difference, normalised coordinates, between a point and the one found again where it is
/// seen. Beyond a fold of the distortion another one is found.
const SAME: f64 = 1e-6;

/// One figure for each view with lines. The photographs are in one of the folders.
pub(super) fn figures(scene: &Scene, found: &[(CylinderLines, Cylinder)], folders: &[PathBuf]) -> String {
    let seen = scene.views.iter().enumerate().filter(|(_, view)| !view.lines().is_empty());
    let figure = |(index, view): (usize, &View)| {
        let photograph = view.image().and_then(|name| image_file::find(folders, name));
        figure(index, view, found, photograph.as_ref())
    };
    seen.map(figure).collect()
}

fn figure(index: usize, view: &View, found: &[(CylinderLines, Cylinder)], photograph: Option<&ImageFile>) -> String {
    let svg = svg(index, view, found, photograph);
    let name = view.image().map_or(format!("view {index}"), |name| format!("{name} (view {index})"));
    let note = if photograph.is_none() { ", without photograph" } else { "" };
    format!("<figure>{svg}<figcaption>{}{note}</figcaption></figure>\n", escaped(&name))
}

/// The photograph of a view under its lines and the silhouettes of the cylinders that have lines in
/// it, as an SVG file that needs no other file. `None` if no folder has the photograph.
pub fn photograph_overlay(
    scene: &Scene,
    found: &[(CylinderLines, Cylinder)],
    index: usize,
    folders: &[PathBuf],
) -> Option<String> {
    let view = scene.views.get(index)?;
    let photograph = image_file::find(folders, view.image()?)?;
    Some(svg(index, view, found, Some(&photograph)))
}

fn svg(index: usize, view: &View, found: &[(CylinderLines, Cylinder)], photograph: Option<&ImageFile>) -> String {
    let [width, height] = size(view, photograph);
    let unit = 0.002 * width.max(height);
    let mut svg = format!("<svg viewBox=\"0 0 {width} {height}\" role=\"img\" xmlns=\"http://www.w3.org/2000/svg\">\n");
    // Writing to a string does not fail.
    let _ = match photograph {
        Some(ImageFile { bytes, media_type, .. }) => writeln!(
            svg,
            "<image width=\"{width}\" height=\"{height}\" preserveAspectRatio=\"none\" href=\"{}\"/>",
            data_url(media_type, bytes)
        ),
        None => writeln!(svg, "<rect width=\"{width}\" height=\"{height}\" class=\"blank\"/>"),
    };
    for (number, (lines, cylinder)) in found.iter().enumerate() {
        let is_seen = lines.views.get(index).is_some_and(|view| !view.lines().is_empty());
        for line in cylinder.silhouette(view.camera()).iter().flatten().filter(|_| is_seen) {
            path(&mut svg, "found", palette::series(number), 2.0 * unit, &curve(view, line, None));
        }
    }
    for (line, ends) in view.lines().iter().zip(view.ends()) {
        path(&mut svg, "given", GIVEN, unit, &curve(view, line, ends.as_ref()));
    }
    svg.push_str("</svg>\n");
    svg
}

/// Width and height of the image: those of the file, or twice the principal point.
fn size(view: &View, photograph: Option<&ImageFile>) -> [f64; 2] {
    let assumed = view.camera().calibration().map(|calibration| calibration.matrix().column(2).xy() * 2.0);
    match (photograph, assumed) {
        (Some(photograph), _) => photograph.size.map(f64::from),
        (None, Some(size)) if size.min() > 0.0 => [size.x, size.y],
        _ => [SCALE, SCALE],
    }
}

/// Where a point in normalised coordinates is seen, pixels. `None` if the lens does not show it.
fn pixel(view: &View, ideal: &Point2<f64>) -> Option<Point2<f64>> {
    let Some(calibration) = view.camera().calibration() else {
        return Some((ideal + Vector2::new(0.5, 0.5)) * SCALE);
    };
    let lens = view.distortion();
    let seen = if lens.is_none() { *ideal } else { lens.distort(ideal) };
    let is_shown = lens.is_none()
        || lens.undistort(&seen).is_some_and(|found| (found - ideal).norm() <= SAME * (1.0 + ideal.coords.norm()));
    Some(calibration.point_to_pixels(&seen)).filter(|_| is_shown)
}

/// The parts of a line that the lens shows, between the end points if there are any.
fn curve(view: &View, line: &Vector3<f64>, ends: Option<&[Point2<f64>; 2]>) -> Vec<Vec<Point2<f64>>> {
    let square = line.xy().norm_squared();
    let foot = Point2::from(line.xy() * (-line.z / square));
    let along = Vector2::new(-line.y, line.x) / square.sqrt();
    // The angle from the foot, seen from the camera centre, grows evenly from point to point.
    let distance = (1.0 + foot.coords.norm_squared()).sqrt();
    let [start, end] = match ends {
        Some(ends) => ends.map(|end| (along.dot(&(end - foot)) / distance).atan()),
        None => [-FARTHEST, FARTHEST],
    };
    let mut parts = vec![Vec::new()];
    for index in 0..POINTS {
        let angle = start + (end - start) * index as f64 / (POINTS - 1) as f64;
        match pixel(view, &(foot + along * (distance * angle.tan()))) {
            Some(point) if point.coords.iter().all(|entry| entry.is_finite()) => {
                if let Some(part) = parts.last_mut() {
                    part.push(point);
                }
            }
            _ => parts.push(Vec::new()),
        }
    }
    parts
}

fn path(svg: &mut String, class: &str, [red, green, blue]: Colour, width: f64, parts: &[Vec<Point2<f64>>]) {
    let mut data = String::new();
    for part in parts.iter().filter(|part| part.len() > 1) {
        for (index, point) in part.iter().enumerate() {
            let _ = write!(data, "{}{:.2} {:.2}", if index == 0 { "M" } else { "L" }, point.x, point.y);
        }
    }
    let _ = writeln!(
        svg,
        "<path class=\"{class}\" d=\"{data}\" stroke=\"rgb({red},{green},{blue})\" stroke-width=\"{width:.3}\" fill=\"none\"/>"
    );
}
