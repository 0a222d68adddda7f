//! The scene in space, as the numbers that the script of the page draws.

use nalgebra::Point3;
use serde_json::{Value, json};

use super::escape::escaped_json;
use crate::output::palette::{self, GREY};
use crate::space::extent::{image_corners, visible_extent};
use crate::{Camera, Cylinder, CylinderLines, Scene};

/// At most this number of points is drawn: every second, third, .. is left out if there are more.
const MOST_POINTS: usize = 20_000;

/// Depth of a camera's pyramid, relative to its distance from the nearest cylinder.
const PYRAMID: f64 = 0.15;

/// Length of a cylinder whose extent is not known, relative to its radius.
const LENGTH: f64 = 4.0;

/// `{"cylinders": [..], "cameras": [..], "points": [..]}`
pub(super) fn json(scene: &Scene, found: &[(CylinderLines, Cylinder)]) -> String {
    let cylinder = |(number, (lines, cylinder)): (usize, &(CylinderLines, Cylinder))| {
        let half = 0.5 * LENGTH * cylinder.radius;
        let extent = visible_extent(cylinder, &lines.views, &scene.points).unwrap_or([-half, half]);
        json!({
            "label": lines.label,
            "ends": extent.map(|height| numbers(&cylinder.axis_at(height))),
            "radius": cylinder.radius,
            "colour": palette::series(number),
        })
    };
    let seen = scene.views.iter().filter(|view| !view.lines().is_empty());
    let step = scene.points.len().div_ceil(MOST_POINTS).max(1);
    let point = |point: &Point3<f64>| {
        let on = found.iter().position(|(_, cylinder)| cylinder.is_near(point));
        json!([point.x, point.y, point.z, on.map_or(GREY, palette::series)])
    };
    escaped_json(&json!({
        "cylinders": found.iter().enumerate().map(cylinder).collect::<Vec<_>>(),
        "cameras": seen.map(|view| camera(view.camera(), found)).collect::<Vec<_>>(),
        "points": scene.points.iter().step_by(step).map(point).collect::<Vec<_>>(),
    }))
}

/// The centre and the four corners of the pyramid.
fn camera(camera: &Camera, found: &[(CylinderLines, Cylinder)]) -> Value {
    let distances = found.iter().map(|(_, cylinder)| cylinder.distance(&camera.centre()));
    let nearest = distances.fold(f64::INFINITY, f64::min);
    let depth = if nearest.is_finite() { PYRAMID * nearest } else { 1.0 };
    let corner =
        |corner: nalgebra::Point2<f64>| camera.centre() + camera.rotation().tr_mul(&(corner.to_homogeneous() * depth));
    let corners = image_corners(camera).map(corner);
    let all: Vec<_> = std::iter::once(camera.centre()).chain(corners).map(|point| numbers(&point)).collect();
    json!(all)
}

fn numbers(point: &Point3<f64>) -> [f64; 3] {
    point.coords.into()
}
