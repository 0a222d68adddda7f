//! Rendered photographs: cylinders that stand on a chequered floor, lit from one side, with
//! occlusion, anti-aliasing and noise. The truth is known, and nothing else is told to whoever
//! looks for it.

use std::f64::consts::TAU;

use nalgebra::{Matrix3, Matrix3x4, Point2, Point3, Rotation3, Unit, Vector3};

use crate::detection::GreyImage;
use crate::observations::distortion::Distortion;
use crate::observations::photograph::Photograph;
use crate::observations::view::{Calibration, Camera};
use crate::random::Random;
use crate::space::cylinder::Cylinder;

/// Half of the side of the square on which the cylinders stand, world units.
const HALF_SIDE: f64 = 3.5;
/// Range of the radii.
const RADII: [f64; 2] = [0.25, 0.7];
/// Range of the heights.
const HEIGHTS: [f64; 2] = [2.0, 4.0];
/// Least distance between surfaces.
const CLEARANCE: f64 = 0.4;
/// Side of a square of the floor.
const SQUARE: f64 = 0.9;
/// The floor ends at this distance from its middle.
const FLOOR: f64 = 9.0;
/// Distance of the cameras from the middle.
const DISTANCES: [f64; 2] = [10.0, 14.0];
/// Height of the cameras.
const CAMERA_HEIGHTS: [f64; 2] = [1.5, 5.0];
/// Focal length as a part of the width of the image.
const FOCAL: f64 = 0.95;
/// Steps of the light that a cylinder gets from its surroundings only.
const AMBIENT: f64 = 0.35;

/// What to render.
#[derive(Clone, Copy, Debug)]
pub struct RenderingSetup {
    /// Number of cylinders.
    pub cylinders: usize,
    /// Number of photographs, all around.
    pub images: usize,
    /// Width of a photograph, pixels.
    pub width: usize,
    /// Height of a photograph, pixels.
    pub height: usize,
    /// Standard deviation of the noise, grey values of 255.
    pub noise: f64,
    /// Lens distortion of all cameras.
    pub distortion: Distortion,
}

/// Photographs and their truth.
#[derive(Clone, Debug)]
pub struct RenderedScene {
    /// Names, cameras and distortion.
    pub photographs: Vec<Photograph>,
    /// The images, in the same order.
    pub images: Vec<GreyImage>,
    /// The cylinders.
    pub cylinders: Vec<Cylinder>,
}

impl RenderingSetup {
    /// Renders the scene of a seed. The world frame is turned at random. `None` if there is no room
    /// for the cylinders, or the size of the image is zero.
    pub fn scene(&self, seed: u64) -> Option<RenderedScene> {
        let mut random = Random::new(seed);
        let turn =
            Rotation3::from_euler_angles(random.uniform(0.0, TAU), random.uniform(-0.5, 0.5), random.uniform(0.0, TAU));
        let columns = columns(self.cylinders, &mut random)?;
        let light = Unit::try_new(Vector3::new(random.normal(), random.normal(), 1.5), 1e-9)?;
        let stage = Stage { columns, light: light.into_inner(), floor_angle: random.uniform(0.0, TAU) };
        let (mut photographs, mut images) = (Vec::new(), Vec::new());
        for index in 0..self.images {
            let (rotation, centre) = self.pose(index, &mut random);
            let calibration = self.calibration()?;
            let in_world = rotation * turn.matrix().transpose();
            let translation = -(rotation * centre.coords);
            let [a, b, c] = [0, 1, 2].map(|column| in_world.column(column).into_owned());
            let camera = Camera::from_normalised(&Matrix3x4::from_columns(&[a, b, c, translation])).ok()?;
            let name = format!("{index:02}.png");
            let photograph =
                Photograph { name, camera: camera.with_calibration(calibration), distortion: self.distortion };
            images.push(self.image(&photograph, &stage, (&rotation, &centre), &mut random)?);
            photographs.push(photograph);
        }
        let up = Unit::new_unchecked(turn * Vector3::z());
        let cylinder = |column: &Column| Cylinder::new(&(turn * column.foot), up, column.radius);
        Some(RenderedScene { photographs, images, cylinders: stage.columns.iter().map(cylinder).collect() })
    }

    fn calibration(&self) -> Option<Calibration> {
        let (width, height) = (self.width as f64, self.height as f64);
        let focal = FOCAL * width;
        Calibration::new(&Matrix3::new(focal, 0.0, 0.5 * width, 0.0, focal, 0.5 * height, 0.0, 0.0, 1.0)).ok()
    }

    /// Rotation from stage to camera, and the camera centre on the stage.
    fn pose(&self, index: usize, random: &mut Random) -> (Matrix3<f64>, Point3<f64>) {
        let angle = TAU * (index as f64 + random.uniform(0.0, 0.7)) / self.images as f64;
        let distance = random.uniform(DISTANCES[0], DISTANCES[1]);
        let height = random.uniform(CAMERA_HEIGHTS[0], CAMERA_HEIGHTS[1]);
        let centre = Point3::new(angle.cos() * distance, angle.sin() * distance, height);
        let forward =
            (Vector3::new(random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4), 1.4) - centre.coords).normalize();
        let right = forward.cross(&Vector3::z()).normalize();
        let upright = Matrix3::from_rows(&[right.transpose(), forward.cross(&right).transpose(), forward.transpose()]);
        let roll = Rotation3::from_axis_angle(&Vector3::z_axis(), random.uniform(-0.15, 0.15));
        (roll.into_inner() * upright, centre)
    }

    /// Each pixel is the mean of nine rays, with noise, rounded.
    fn image(
        &self,
        photograph: &Photograph,
        stage: &Stage,
        (rotation, centre): (&Matrix3<f64>, &Point3<f64>),
        random: &mut Random,
    ) -> Option<GreyImage> {
        let calibration = photograph.camera.calibration()?;
        let mut values = Vec::with_capacity(self.width * self.height);
        for row in 0..self.height {
            for column in 0..self.width {
                let mut sum = 0.0;
                for sample in 0..9 {
                    let (i, j) = (f64::from(sample % 3), f64::from(sample / 3));
                    let pixel = Point2::new(column as f64 + (i + 0.5) / 3.0, row as f64 + (j + 0.5) / 3.0);
                    let ideal = photograph.distortion.undistort(&calibration.point_to_normalised(&pixel))?;
                    sum += stage.brightness(centre, &rotation.tr_mul(&ideal.to_homogeneous()));
                }
                let value = 255.0 * sum / 9.0 + self.noise * random.normal();
                values.push(value.round().clamp(0.0, 255.0) as f32);
            }
        }
        GreyImage::new(self.width, self.height, values).ok()
    }
}

/// A cylinder that stands on the floor, the plane `z = 0`.
struct Column {
    foot: Point3<f64>,
    radius: f64,
    height: f64,
    albedo: f64,
}

struct Stage {
    columns: Vec<Column>,
    /// Unit vector to the light.
    light: Vector3<f64>,
    floor_angle: f64,
}

impl Stage {
    /// What is seen along a ray, 0 to 1.
    fn brightness(&self, centre: &Point3<f64>, ray: &Vector3<f64>) -> f64 {
        let hit = |column: &Column| column.hit(centre, ray).map(|(depth, normal)| (depth, normal, column.albedo));
        let nearest = self.columns.iter().filter_map(hit).min_by(|a, b| a.0.total_cmp(&b.0));
        if let Some((_, normal, albedo)) = nearest {
            return albedo * (AMBIENT + (1.0 - AMBIENT) * normal.dot(&self.light).max(0.0));
        }
        let depth = -centre.z / ray.z;
        let place = centre + ray * depth;
        if depth > 0.0 && place.coords.xy().amax() < FLOOR {
            let (sine, cosine) = self.floor_angle.sin_cos();
            let (u, v) = (place.x * cosine - place.y * sine, place.x * sine + place.y * cosine);
            let odd = ((u / SQUARE).floor() + (v / SQUARE).floor()).rem_euclid(2.0) > 0.5;
            return if odd { 0.3 } else { 0.62 };
        }
        // A sky that is brighter above.
        0.75 + 0.2 * (ray.z / ray.norm())
    }
}

impl Column {
    /// Depth and unit normal where a ray meets the side or the top.
    fn hit(&self, centre: &Point3<f64>, ray: &Vector3<f64>) -> Option<(f64, Vector3<f64>)> {
        let (offset, flat) = (centre.coords.xy() - self.foot.coords.xy(), ray.xy());
        let (a, b) = (flat.norm_squared(), offset.dot(&flat));
        let root = b * b - a * (offset.norm_squared() - self.radius * self.radius);
        if root <= 0.0 {
            return None;
        }
        let depth = (-b - root.sqrt()) / a;
        let side = centre + ray * depth;
        if depth > 0.0 && (0.0..=self.height).contains(&side.z) {
            let normal = (side.coords.xy() - self.foot.coords.xy()) / self.radius;
            return Some((depth, normal.push(0.0)));
        }
        let depth = (self.height - centre.z) / ray.z;
        let top = centre + ray * depth;
        let on_top = depth > 0.0 && (top.coords.xy() - self.foot.coords.xy()).norm() < self.radius;
        on_top.then(|| (depth, Vector3::z()))
    }
}

/// Columns that are apart from each other.
fn columns(count: usize, random: &mut Random) -> Option<Vec<Column>> {
    let mut columns: Vec<Column> = Vec::with_capacity(count);
    for _ in 0..1000 * count {
        if columns.len() == count {
            break;
        }
        let mut side = || random.uniform(-HALF_SIDE, HALF_SIDE);
        let foot = Point3::new(side(), side(), 0.0);
        let radius = random.uniform(RADII[0], RADII[1]);
        let height = random.uniform(HEIGHTS[0], HEIGHTS[1]);
        let albedo = random.uniform(0.45, 1.0);
        if columns.iter().all(|other| (other.foot - foot).norm() >= radius + other.radius + CLEARANCE) {
            columns.push(Column { foot, radius, height, albedo });
        }
    }
    (columns.len() == count).then_some(columns)
}
