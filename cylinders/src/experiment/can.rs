//! A simulated soda can in photographs from all sides, and the dual conics that the methods find
//! for some of them.
//!
//! Silhouettes come from points, not from tangent planes: the ends of each line of contact, at
//! bottom and top, are projected, moved by noise in pixels, and joined.

use std::f64::consts::TAU;

use nalgebra::{Matrix3, Matrix3x4, Point3, Rotation3, Unit, Vector3};

use super::random::instance_seed;
use crate::direction::estimate_direction;
use crate::random::Random;
use crate::rectify::{Rectification, TangentLine};
use crate::{Calibration, Camera, Cylinder, SectionLine, Sight, View, ViewError};

/// Radius of the can, millimetres.
pub(super) const RADIUS: f64 = 33.0;
/// Half of its height, the middle of its axis, and its direction.
const HALF_HEIGHT: f64 = 57.5;
const MIDDLE: [f64; 3] = [120.0, -40.0, 30.0];
const DIRECTION: [f64; 3] = [0.1, -0.2, 0.97];

/// Distance of the cameras from the axis, and their largest height above or below the middle,
/// millimetres.
const DISTANCES: [f64; 2] = [450.0, 600.0];
const ELEVATION: f64 = 200.0;

/// Focal length and principal point, pixels.
const FOCAL: f64 = 3000.0;
const PRINCIPAL: [f64; 2] = [2000.0, 1500.0];

/// Photographs of the can.
pub(super) const PHOTOGRAPHS: usize = 18;

/// Description of the simulation.
pub(super) const SETUP: &str = "Simulated soda can (radius 33 mm, height 115 mm). 18 cameras of 4000 x 3000 pixels (focal \
length 3000) stand around it, one in each sector of 20 degrees, 450 to 600 mm from the axis \
and up to 200 mm above or below its middle; their places are drawn once for each seed. Each \
end point of each silhouette is moved by normal noise, drawn anew for each run.";

/// The can and its cameras.
pub(super) struct Can {
    cylinder: Cylinder,
    cameras: Vec<Camera>,
}

/// Deviations of the four coordinates of the ends of a line, in units of the noise.
type Deviations = [[f64; 4]; 2];

/// The deviations of all lines of a run: for each photograph the right and the left silhouette.
pub(super) struct Noise(Vec<Deviations>);

impl Noise {
    pub(super) fn new(random: &mut Random) -> Self {
        Self((0..PHOTOGRAPHS).map(|_| [[(); 4]; 2].map(|line| line.map(|()| random.normal()))).collect())
    }
}

impl Can {
    /// The can with its cameras, which are the same in all instances.
    pub(super) fn of_seed(seed: u64) -> Result<Self, ViewError> {
        let mut random = Random::new(instance_seed(seed, u64::MAX));
        let direction = Unit::new_normalize(Vector3::from(DIRECTION));
        let middle = Point3::from(MIDDLE);
        let cylinder = Cylinder::new(&middle, direction, RADIUS);
        let across = direction.cross(&Vector3::x()).normalize();
        let [px, py] = PRINCIPAL;
        let calibration = Calibration::new(&Matrix3::new(FOCAL, 0.0, px, 0.0, FOCAL, py, 0.0, 0.0, 1.0))?;
        let camera = |index| {
            let angle = TAU * (index as f64 + random.uniform(0.0, 0.8)) / PHOTOGRAPHS as f64;
            let outward = Rotation3::from_axis_angle(&direction, angle) * across;
            let height = random.uniform(-ELEVATION, ELEVATION);
            let centre =
                middle + outward * random.uniform(DISTANCES[0], DISTANCES[1]) + direction.into_inner() * height;
            Ok(Camera::from_normalised(&look_at(&centre, &middle, &direction))?.with_calibration(calibration))
        };
        Ok(Self { cylinder, cameras: (0..PHOTOGRAPHS).map(camera).collect::<Result<_, ViewError>>()? })
    }

    /// The silhouettes of these sides (0 right, 1 left) in a photograph; `None` if the camera is
    /// inside the can.
    pub(super) fn view(&self, photograph: usize, sides: &[usize], noise: &Noise, pixels: f64) -> Option<View> {
        let camera = self.cameras[photograph];
        let silhouette = self.cylinder.silhouette(&camera)?;
        let middle = self.cylinder.height(&Point3::from(MIDDLE));
        let line = |&side: &usize| {
            let normal = camera.rotation().tr_mul(&silhouette[side]).normalize();
            let deviations = noise.0[photograph][side];
            let [bottom, top] = [0, 1].map(|end| {
                let height = middle + [-HALF_HEIGHT, HALF_HEIGHT][end];
                let contact = self.cylinder.axis_at(height) - normal * RADIUS;
                let image = camera.rotation() * contact.coords + camera.translation();
                let deviation = Vector3::new(deviations[2 * end], deviations[2 * end + 1], 0.0);
                image / image.z + deviation * (pixels / FOCAL)
            });
            bottom.cross(&top)
        };
        View::from_normalised_lines(camera, &sides.iter().map(line).collect::<Vec<_>>()).ok()
    }
}

/// The lines of a cross-section, each with its camera.
pub(super) struct CrossSection {
    pub(super) lines: Vec<SectionLine>,
    pub(super) sights: Vec<Sight>,
}

/// The lines of the cross-section along the direction that the views determine. The true axis is
/// the origin and the true radius the unit. `None` if the views determine no direction.
pub(super) fn cross_section(views: &[View]) -> Option<CrossSection> {
    let planes: Vec<_> = views.iter().flat_map(View::planes).collect();
    let direction = estimate_direction(&planes).ok()?;
    let rectification = Rectification::new(&direction.direction, Point3::from(MIDDLE));
    let mut found = CrossSection { lines: Vec::with_capacity(planes.len()), sights: Vec::with_capacity(planes.len()) };
    for (index, view) in views.iter().enumerate() {
        for plane in view.planes() {
            let line = rectification.line(&plane)?;
            let line = TangentLine { offset: line.offset / RADIUS, ..line };
            found.lines.push(SectionLine { line, weight: 1.0, view: index });
            let sight = Sight::of(&plane, &direction.direction, &rectification);
            found.sights.push(Sight { camera: sight.camera / RADIUS, ..sight });
        }
    }
    Some(found)
}

/// The true dual conic in the coordinates of [`cross_section`].
pub(super) fn true_dual_conic() -> Matrix3<f64> {
    Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, -1.0))
}

/// `[R t]` of a camera that looks at a point: z forward, y down.
fn look_at(centre: &Point3<f64>, aim: &Point3<f64>, up: &Vector3<f64>) -> Matrix3x4<f64> {
    let forward = (aim - centre).normalize();
    let right = forward.cross(up).normalize();
    let down = forward.cross(&right);
    let rotation = Matrix3::from_rows(&[right.transpose(), down.transpose(), forward.transpose()]);
    let mut camera = rotation.insert_column(3, 0.0);
    camera.set_column(3, &-(rotation * centre.coords));
    camera
}
