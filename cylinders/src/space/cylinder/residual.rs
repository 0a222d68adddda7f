//! The distance of a given line from the silhouette of a cylinder.

use crate::observations::scene::LineId;
use nalgebra::Vector3;

use super::{Cylinder, Side};
use crate::observations::view::{View, ViewingPlane};
use crate::space::silhouette_distance::{SilhouetteDistance, lines_in_pixels, lines_with_ends};

/// The distance of a given line from the silhouette of a cylinder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineResidual {
    /// Index of the view.
    pub view: usize,
    /// Index of the line in its view.
    pub line: usize,
    /// Side of the silhouette that is nearest to the line: by its end points, or by the angle if
    /// they are unknown.
    pub side: Side,
    /// Signed distance between viewing plane and cylinder, world units: distance of the axis from
    /// the plane, turned about its camera centre to be parallel to the axis, minus the radius. It
    /// is negative if the plane cuts the cylinder.
    pub distance: f64,
    /// Angle between the viewing plane and the tangent plane of that silhouette, radians.
    pub angle: f64,
    /// Distance in pixels, if the camera has a calibration: the root mean square distance from the
    /// silhouette of the end points of the given line, or of two points that stand for a line
    /// without end points (`silhouette_distance`). It is the distance that RANSAC compares with its
    /// threshold and that refinement makes small.
    pub pixels: Option<f64>,
}

impl LineResidual {
    /// The place of the line.
    pub(crate) fn id(&self) -> LineId {
        LineId { view: self.view, line: self.line }
    }

    /// The angle with the sign of the distance: negative if the viewing plane cuts the cylinder,
    /// radians.
    pub fn signed_angle(&self) -> f64 {
        self.angle.copysign(self.distance)
    }
}

impl Cylinder {
    /// Residuals of the lines of a view; `None` if it has lines but its camera is not outside the
    /// cylinder. `view` is the index of the view in the residuals.
    pub fn residuals(&self, view: usize, lines: &View) -> Option<Vec<LineResidual>> {
        if lines.lines().is_empty() {
            return Some(Vec::new());
        }
        let camera = lines.camera();
        let silhouette = self.silhouette(camera)?;
        let in_pixels = lines_in_pixels(view, lines);
        let at_ends: Vec<_> =
            lines_with_ends(view, lines).iter().map(|measured| measured.as_ref()?.distance(self)).collect();
        let residual = |(index, (line, plane)): (usize, (&Vector3<f64>, ViewingPlane))| {
            // Lines have no sign: the angle is between 0 and pi / 2.
            let angle = |other: &Vector3<f64>| line.cross(other).norm().atan2(line.dot(other).abs());
            let [right, left] = silhouette.each_ref().map(angle);
            let at_ends = at_ends[index].as_ref();
            let by_angle = if left < right { Side::Left } else { Side::Right };
            let side = at_ends.map_or(by_angle, SilhouetteDistance::side);
            let angle = if side == Side::Left { left } else { right };
            let pixels = in_pixels[index].as_ref().and_then(|measured| measured.distance(self));
            let pixels = pixels.map(|distance| distance.mean_square().sqrt());
            let distance = self.plane_distance(&plane);
            LineResidual { view, line: index, side, distance, angle, pixels }
        };
        Some(lines.lines().iter().zip(lines.planes()).enumerate().map(residual).collect())
    }

    /// Distance of the axis from the plane, which is turned to be parallel to the axis, minus the
    /// radius.
    fn plane_distance(&self, plane: &ViewingPlane) -> f64 {
        let w = self.direction.into_inner();
        let normal = (plane.normal - w * w.dot(&plane.normal)).normalize();
        normal.dot(&self.vector_to_axis(&plane.centre)).abs() - self.radius
    }
}
