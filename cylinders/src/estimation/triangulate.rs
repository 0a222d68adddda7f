//! All steps from views to a cylinder.

use nalgebra::{Point3, Unit, Vector3};
use thiserror::Error;

use crate::axis::direction::{Direction, DirectionError, estimate_direction};
use crate::cross_section::circle::{CircleError, CircleFit, fit_circle_in_front};
use crate::cross_section::rectify::{Rectification, TangentLine};
use crate::cross_section::sight::Sight;
use crate::observations::copies::IndependentLines;
use crate::observations::scene::LineId;
use crate::observations::view::{View, ViewingPlane};
use crate::space::cylinder::{Cylinder, LineResidual};

/// All cameras count as standing at one place if the largest distance between the axes through
/// their centres, relative to the distance of the centres from the world's origin, is at most this.
const SINGLE_VIEWPOINT: f64 = 1e-9;

/// A triangulated cylinder and how well the lines determine and fit it.
#[derive(Clone, Debug, PartialEq)]
pub struct Triangulation {
    /// The cylinder.
    pub cylinder: Cylinder,
    /// Axis direction and singular values of its linear system.
    pub direction: Direction,
    /// The circle of the cross-section, with its cost.
    pub fit: CircleFit,
    /// One residual for each line, in the order of the views and lines.
    pub residuals: Vec<LineResidual>,
}

/// Why the views determine no cylinder.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum TriangulateError {
    /// A cylinder needs three tangent planes.
    #[error(
        "{lines} silhouette line(s) given, copies counted once; a cylinder needs at least three, and four to be unique"
    )]
    TooFewLines {
        /// Number of independent lines in all views.
        lines: usize,
    },
    /// The axis direction is not determined.
    #[error(transparent)]
    Direction(#[from] DirectionError),
    /// Seen along the axis, all camera centres coincide: a cylinder of any size fits.
    #[error(
        "all cameras stand at one place, or above each other along the axis: the distance to the cylinder is unknown"
    )]
    SingleViewpoint,
    /// The viewing plane of a line is too steep to the axis of the others.
    #[error("views[{view}], line {line}: the viewing plane is too steep to the axis of the other lines")]
    AcrossAxis {
        /// Index of the view.
        view: usize,
        /// Index of the line in its view.
        line: usize,
    },
    /// The circle of the cross-section is not determined.
    #[error(transparent)]
    Circle(#[from] CircleError),
    /// The best cylinder contains a camera, from which it has no silhouette.
    #[error(
        "the best cylinder (radius {radius:.6}) contains the camera of views[{view}]: the lines do not fit together"
    )]
    CameraInside {
        /// Index of the view.
        view: usize,
        /// Radius of that cylinder, world units.
        radius: f64,
    },
}

/// Triangulates one cylinder from its silhouette lines in at least two views. Copies of a line
/// count as one line ([`IndependentLines`]).
///
/// # Errors
/// [`TriangulateError`].
pub fn triangulate(views: &[View]) -> Result<Triangulation, TriangulateError> {
    let lines = IndependentLines::of(views);
    check_count_and_places(views, &lines)?;
    let planes: Vec<_> = lines.views.iter().flat_map(View::planes).collect();
    along(views, &lines, estimate_direction(&planes)?)
}

/// Triangulates one cylinder whose direction is known, for example from other cylinders parallel to
/// it.
///
/// # Errors
/// [`TriangulateError`].
pub fn triangulate_along(views: &[View], direction: Direction) -> Result<Triangulation, TriangulateError> {
    along(views, &IndependentLines::of(views), direction)
}

fn along(views: &[View], lines: &IndependentLines, direction: Direction) -> Result<Triangulation, TriangulateError> {
    check_count_and_places(views, lines)?;
    let (cylinder, fit) = fit_cylinder(&identified_planes(lines), &direction.direction)?;
    let mut residuals = Vec::new();
    for (view, content) in views.iter().enumerate() {
        let inside = TriangulateError::CameraInside { view, radius: cylinder.radius };
        residuals.extend(cylinder.residuals(view, content).ok_or(inside)?);
    }
    Ok(Triangulation { cylinder, direction, fit, residuals })
}

/// Three lines are needed that are no copies. If fewer are left because the cameras stand at one
/// place, that is the cause.
fn check_count_and_places(views: &[View], lines: &IndependentLines) -> Result<(), TriangulateError> {
    match lines.count() {
        3.. => Ok(()),
        ..3 if lines.given() >= 3 && is_single_viewpoint(views) => Err(TriangulateError::SingleViewpoint),
        lines => Err(TriangulateError::TooFewLines { lines }),
    }
}

/// Whether all cameras that see lines stand at one place.
pub(crate) fn is_single_viewpoint(views: &[View]) -> bool {
    let seeing = views.iter().filter(|view| !view.lines().is_empty());
    let mut centres = seeing.map(|view| view.camera().centre());
    let Some(first) = centres.next() else { return false };
    centres.all(|centre| (centre - first).norm() <= SINGLE_VIEWPOINT * first.coords.norm())
}

/// The viewing planes of independent lines, each with the place of its first copy.
pub(crate) fn identified_planes(lines: &IndependentLines) -> Vec<(LineId, ViewingPlane)> {
    let planes = lines.views.iter().flat_map(View::planes);
    lines.copies.iter().map(|copies| copies[0]).zip(planes).collect()
}

/// The lines of the cross-section along a direction.
pub(crate) struct CrossSection {
    pub(crate) rectification: Rectification,
    pub(crate) lines: Vec<TangentLine>,
    sights: Vec<Sight>,
    /// Largest distance of a camera from the origin.
    extent: f64,
}

impl CrossSection {
    pub(crate) fn of(
        planes: &[(LineId, ViewingPlane)],
        direction: &Unit<Vector3<f64>>,
    ) -> Result<Self, TriangulateError> {
        if planes.len() < 3 {
            return Err(TriangulateError::TooFewLines { lines: planes.len() });
        }
        let (origin, magnitude) = centroid(planes);
        let rectification = Rectification::new(direction, origin);
        let centre_distance = |(_, plane): &(LineId, ViewingPlane)| rectification.point(&plane.centre).coords.norm();
        let extent = planes.iter().map(centre_distance).fold(0.0, f64::max);
        if extent <= SINGLE_VIEWPOINT * magnitude {
            return Err(TriangulateError::SingleViewpoint);
        }
        let line = |&(LineId { view, line }, plane): &(LineId, ViewingPlane)| {
            rectification.line(&plane).ok_or(TriangulateError::AcrossAxis { view, line })
        };
        let lines = planes.iter().map(line).collect::<Result<Vec<_>, _>>()?;
        let sights = planes.iter().map(|(_, plane)| Sight::of(plane, direction, &rectification)).collect();
        Ok(Self { rectification, lines, sights, extent })
    }
}

/// Cylinder of constrained least squares along a direction. It is in front of the cameras if any
/// minimum of the cost is.
pub(crate) fn fit_cylinder(
    planes: &[(LineId, ViewingPlane)],
    direction: &Unit<Vector3<f64>>,
) -> Result<(Cylinder, CircleFit), TriangulateError> {
    let CrossSection { rectification, lines, sights, extent } = CrossSection::of(planes, direction)?;
    let fit = fit_circle_in_front(&lines, &sights, extent)?;
    Ok((Cylinder::from_circle(&fit.circle, &rectification, *direction), fit))
}

/// Mean of the camera centres, weighted by their numbers of lines, and their largest distance from
/// the world's origin.
fn centroid(planes: &[(LineId, ViewingPlane)]) -> (Point3<f64>, f64) {
    let centres = planes.iter().map(|(_, plane)| plane.centre.coords);
    let sum: Vector3<f64> = centres.clone().sum();
    let magnitude = centres.map(|centre| centre.norm()).fold(0.0, f64::max);
    (Point3::from(sum / planes.len() as f64), magnitude)
}
