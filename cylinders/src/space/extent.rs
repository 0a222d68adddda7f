//! Which part of an infinite cylinder the views show.

use nalgebra::{Point2, Point3, Vector3};

use super::cylinder::Cylinder;
use super::silhouette_distance::{MeasuredLine, lines_with_ends};
use crate::observations::view::{Camera, View};

/// If there are fewer points on the surface than this, the images decide.
const ENOUGH_POINTS: usize = 20;

/// The part of the points at either end that is ignored, because they may be on the surface by
/// chance.
const BY_CHANCE: f64 = 0.01;

/// Length of the axis that a camera is assumed to see, in units of its distance from the axis.
/// Lines of sight at less than 18 degrees to the axis show nothing that can be measured.
const FAR: f64 = 3.0;

/// Half the width of the image of a camera without calibration, normalised coordinates: a field of
/// view of 53 degrees.
const HALF_WIDTH: f64 = 0.5;

/// The corners of the image in normalised coordinates, in order around it. The size of the image is
/// assumed to be twice the principal point. Without calibration, or if the principal point is not
/// positive, it is a square.
pub(crate) fn image_corners(camera: &Camera) -> [Point2<f64>; 4] {
    let size = camera.calibration().map(|calibration| calibration.matrix().column(2).xy() * 2.0);
    let unit = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
    match (camera.calibration(), size) {
        (Some(calibration), Some(size)) if size.min() > 0.0 => {
            unit.map(|(x, y)| calibration.point_to_normalised(&Point2::new(x * size.x, y * size.y)))
        }
        _ => unit.map(|(x, y)| Point2::new(2.0 * x - 1.0, 2.0 * y - 1.0) * HALF_WIDTH),
    }
}

/// The visible part of a cylinder: least and largest distance along the axis from the axis point,
/// world units. If lines have end points, it is the range of the end points. Otherwise, if enough
/// scene points lie on the surface, it is their range. Otherwise it is the part in which the images
/// with lines of the cylinder show its two contact lines, the median of both ends. `None` if
/// nothing determines it.
pub fn visible_extent(cylinder: &Cylinder, views: &[View], points: &[Point3<f64>]) -> Option<[f64; 2]> {
    let between_ends = views.iter().filter_map(|view| between_ends(cylinder, view));
    if let Some(extent) = between_ends.reduce(|one, other| [one[0].min(other[0]), one[1].max(other[1])]) {
        return Some(extent);
    }
    let near = points.iter().filter(|point| cylinder.is_near(point));
    let mut heights: Vec<_> = near.map(|point| cylinder.height(point)).collect();
    if heights.len() >= ENOUGH_POINTS {
        heights.sort_by(f64::total_cmp);
        let outliers = (heights.len() as f64 * BY_CHANCE) as usize;
        return proper([heights[outliers], heights[heights.len() - 1 - outliers]]);
    }
    let seen = views.iter().filter(|view| !view.lines().is_empty()).flat_map(|view| seen_by(cylinder, view.camera()));
    let (mut low, mut high): (Vec<_>, Vec<_>) = seen.map(|[low, high]| (low, high)).unzip();
    proper([median(&mut low)?, median(&mut high)?])
}

/// For each line of a view with end points: the points on the rays to the end points that are
/// nearest to the contact line on the surface.
pub(crate) fn end_contacts(cylinder: &Cylinder, view: &View) -> Vec<Option<[Point3<f64>; 2]>> {
    let contacts = |line: &Option<MeasuredLine>| line.as_ref()?.contacts(cylinder, &line.as_ref()?.distance(cylinder)?);
    lines_with_ends(0, view).iter().map(contacts).collect()
}

/// The heights from the lowest to the highest end point of a view.
fn between_ends(cylinder: &Cylinder, view: &View) -> Option<[f64; 2]> {
    let [lowest, highest] = believed(cylinder, view.camera());
    let contacts = end_contacts(cylinder, view);
    let heights = contacts.iter().flatten().flatten().map(|point| cylinder.height(point).max(lowest).min(highest));
    proper(heights.fold([f64::INFINITY, -f64::INFINITY], |[low, high], height| [low.min(height), high.max(height)]))
}

/// The heights that a camera is assumed to see.
fn believed(cylinder: &Cylinder, camera: &Camera) -> [f64; 2] {
    let centre = camera.centre();
    let (height, distance) = (cylinder.height(&centre), cylinder.distance(&centre) + cylinder.radius);
    [height - FAR * distance, height + FAR * distance]
}

/// The parts of the two contact lines that a camera shows.
fn seen_by(cylinder: &Cylinder, camera: &Camera) -> Vec<[f64; 2]> {
    let centre = camera.centre();
    let corners = image_corners(camera).map(|corner| corner.to_homogeneous());
    let middle: Vector3<f64> = corners.iter().sum();
    // Planes through the centre and the borders of the image, positive inside. Together they bound
    // the pyramid in front of the camera.
    let planes = [0, 1, 2, 3].map(|index| {
        let border = corners[index].cross(&corners[(index + 1) % 4]);
        camera.rotation().tr_mul(&border) * border.dot(&middle).signum()
    });

    let contact = |line: &Vector3<f64>| {
        let foot = cylinder.axis_point - camera.rotation().tr_mul(line) * cylinder.radius;
        let mut seen = believed(cylinder, camera);
        for plane in &planes {
            // `offset + slope s >= 0` for the point at the height `s`.
            let (offset, slope) = (plane.dot(&(foot - centre)), plane.dot(&cylinder.direction));
            let root = -offset / slope;
            match slope {
                0.0 if offset < 0.0 => return None,
                0.0 => {}
                slope if slope > 0.0 => seen[0] = seen[0].max(root),
                _ => seen[1] = seen[1].min(root),
            }
        }
        proper(seen)
    };
    cylinder.silhouette(camera).iter().flatten().filter_map(contact).collect()
}

fn proper([low, high]: [f64; 2]) -> Option<[f64; 2]> {
    (low < high).then_some([low, high])
}

/// The median, the upper one of two.
fn median(values: &mut [f64]) -> Option<f64> {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied()
}
