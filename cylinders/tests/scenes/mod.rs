//! Random scenes for the tests of the estimators, and the distance between two cylinders.

#![allow(dead_code, reason = "every test file uses a part of it")]

use eliminant_cylinders::{Calibration, Camera, Cylinder, Loss, Metric, RefineOptions, Refinement, View, refine};
use nalgebra::{Matrix3, Matrix3x4, Point2, Point3, Rotation3, Unit, Vector2, Vector3};

use crate::random::Random;
use crate::scene::{Can, Photograph, Setup};

/// Views of photographs, with lines in pixels.
pub(crate) fn views(setup: &Setup, photographs: &[Photograph]) -> Vec<View> {
    let view = |photograph: &Photograph| view(setup, &photograph.camera, &photograph.lines);
    photographs.iter().map(view).collect()
}

/// A view with the calibration of the setup and lines in pixels.
pub(crate) fn view(setup: &Setup, camera: &Matrix3x4<f64>, lines: &[Vector3<f64>]) -> View {
    let calibration = Calibration::new(&setup.calibration).expect("a calibration");
    let camera = Camera::from_normalised(camera).expect("a camera").with_calibration(calibration);
    View::from_pixel_lines(camera, lines).expect("lines")
}

/// A side of a cylinder, 1 or -1, and the part of its height over which it is seen.
pub(crate) type SeenPart = (f64, [f64; 2]);

/// The end points of a silhouette, pixels, with the noise of the setup.
pub(crate) fn silhouette(
    can: &Can,
    setup: &Setup,
    photograph: &Photograph,
    (side, part): SeenPart,
    random: &mut Random,
) -> [Point2<f64>; 2] {
    let rotation = photograph.camera.fixed_columns::<3>(0);
    let centre = Point3::from(-(rotation.tr_mul(&photograph.camera.column(3))));
    let direction = can.direction.into_inner();
    let offset = centre - can.base;
    let outward = offset - direction * direction.dot(&offset);
    let (toward, cosine) = (outward.normalize(), can.radius / outward.norm());
    let sideways = direction.cross(&toward) * (side * (1.0 - cosine * cosine).sqrt());
    let bottom = can.base + (toward * cosine + sideways) * can.radius;
    part.map(|part| {
        let point = bottom + direction * (can.height * part);
        let image = setup.calibration * photograph.camera * point.to_homogeneous();
        let noise = Vector2::new(random.normal(), random.normal()) * setup.noise;
        Point2::from(image.xy() / image.z + noise)
    })
}

/// The camera of a view with other lines, in normalised coordinates.
pub(crate) fn with_lines(view: &View, lines: &[Vector3<f64>]) -> View {
    View::from_normalised_lines(*view.camera(), lines).expect("lines")
}

/// A cylinder anywhere near the origin and four to eight cameras around it.
pub(crate) fn random_scene(random: &mut Random, noise: f64) -> (Can, Setup) {
    let base = Point3::from(Vector3::from_fn(|_, _| random.uniform(-5.0, 5.0)));
    let radius = random.uniform(0.5, 2.0);
    let height = random.uniform(2.0, 8.0);
    let focal = random.uniform(500.0, 4000.0);
    let calibration = Matrix3::new(focal, 2.0, 0.5 * focal, 0.0, 1.01 * focal, 0.4 * focal, 0.0, 0.0, 1.0);
    let cameras = random.uniform(4.0, 9.0) as usize;
    let setup = Setup { calibration, cameras, distance: (6.0, 20.0), elevation: 8.0, noise };
    (Can { base, direction: random_direction(random), radius, height }, setup)
}

pub(crate) fn random_direction(random: &mut Random) -> Unit<Vector3<f64>> {
    Unit::new_normalize(Vector3::from_fn(|_, _| random.normal()))
}

pub(crate) fn truth(can: &Can) -> Cylinder {
    Cylinder::new(&can.base, can.direction, can.radius)
}

/// A cylinder that is off by about `size`, relative to its radius, in every parameter.
pub(crate) fn disturbed(can: &Can, size: f64, random: &mut Random) -> Cylinder {
    let mut vector = || Vector3::from_fn(|_, _| random.uniform(-size, size));
    let direction = Unit::new_normalize(can.direction.into_inner() + vector());
    let point = can.base + can.direction.into_inner() * (can.height / 2.0) + vector() * can.radius;
    Cylinder::new(&point, direction, can.radius * (1.0 + random.uniform(-size, size)))
}

/// Largest of the relative errors of radius and axis position at `at` (against the radius) and the
/// angle between the axes.
pub(crate) fn difference(found: &Cylinder, expected: &Cylinder, at: &Point3<f64>) -> f64 {
    let radius = (found.radius - expected.radius).abs() / expected.radius;
    let axis_distance = |cylinder: &Cylinder| cylinder.distance(at) + cylinder.radius;
    let position = (axis_distance(found) - axis_distance(expected)).abs() / expected.radius;
    let angle = found.direction.cross(&expected.direction).norm().asin();
    radius.max(position).max(angle)
}

/// The similarity `X -> scale * rotation * X + shift` of the world.
pub(crate) struct Motion {
    pub(crate) rotation: Rotation3<f64>,
    pub(crate) shift: Vector3<f64>,
    pub(crate) scale: f64,
}

impl Motion {
    pub(crate) fn random(random: &mut Random) -> Self {
        Self {
            rotation: Rotation3::from_axis_angle(&random_direction(random), random.uniform(0.0, 3.0)),
            shift: Vector3::from_fn(|_, _| random.uniform(-20.0, 20.0)),
            scale: random.uniform(0.01, 100.0),
        }
    }

    pub(crate) fn point(&self, point: &Point3<f64>) -> Point3<f64> {
        Point3::from(self.rotation * point.coords * self.scale + self.shift)
    }

    pub(crate) fn cylinder(&self, cylinder: &Cylinder) -> Cylinder {
        let direction = self.rotation * cylinder.direction;
        Cylinder::new(&self.point(&cylinder.axis_point), direction, cylinder.radius * self.scale)
    }

    /// `[R t]` becomes `[R Q^T, scale t - R Q^T shift]`.
    pub(crate) fn view(&self, view: &View) -> View {
        let camera = view.camera();
        let turned = camera.rotation() * self.rotation.inverse().matrix();
        let translation = camera.translation() * self.scale - turned * self.shift;
        let matrix = camera_matrix(&turned, &translation);
        let mut moved = Camera::from_normalised(&matrix).expect("a camera");
        if let Some(calibration) = camera.calibration() {
            moved = moved.with_calibration(*calibration);
        }
        let moved = View::from_normalised_lines(moved, view.lines()).expect("lines");
        moved.with_ends(view.ends().to_vec()).expect("end points")
    }
}

/// Refined on the silhouette distance in the default metric.
pub(crate) fn refined(views: &[View], start: &Cylinder) -> Refinement {
    let options = RefineOptions { metric: Metric::of(views), loss: Loss::Quadratic };
    refine(views, start, &options).expect("a cylinder")
}

fn camera_matrix(rotation: &Matrix3<f64>, translation: &Vector3<f64>) -> Matrix3x4<f64> {
    Matrix3x4::from_fn(|row, column| if column == 3 { translation[row] } else { rotation[(row, column)] })
}

/// The view of a camera without calibration.
pub(crate) fn without_calibration(view: &View) -> View {
    let camera = view.camera();
    let camera = Camera::from_normalised(&camera_matrix(camera.rotation(), camera.translation())).expect("a camera");
    let lines = View::from_normalised_lines(camera, view.lines()).expect("lines");
    lines.with_ends(view.ends().to_vec()).expect("end points")
}

/// The same viewing planes, in a camera that is turned by half a turn about its y axis.
pub(crate) fn turned_round(view: &View) -> View {
    let turn = Matrix3::from_diagonal(&Vector3::new(-1.0, 1.0, -1.0));
    let camera = view.camera();
    let matrix = camera_matrix(&(turn * camera.rotation()), &(turn * camera.translation()));
    let mut turned = Camera::from_normalised(&matrix).expect("a camera");
    if let Some(calibration) = camera.calibration() {
        turned = turned.with_calibration(*calibration);
    }
    let lines: Vec<_> = view.lines().iter().map(|line| turn * line).collect();
    View::from_normalised_lines(turned, &lines).expect("lines")
}
