//! Scenes whose clutter is no chance: cylinders that stand among the edges of a floor, of a wall or
//! of boxes, as lines with noise.

use std::f64::consts::TAU;

use eliminant_cylinders::random::Random;
use eliminant_cylinders::{Calibration, Camera, Cylinder, View};
use nalgebra::{Matrix3, Matrix3x4, Point2, Point3, Rotation3, Unit, Vector2, Vector3};

const SIZE: [f64; 2] = [1600.0, 1200.0];
const FOCAL: f64 = 1000.0;
/// Cameras stand on a ring, at these distances and heights.
const DISTANCES: [f64; 2] = [9.0, 13.0];
const CAMERA_HEIGHTS: [f64; 2] = [1.5, 5.0];
/// The cylinders stand in the middle, this far apart, and have one height.
const HALF_SIDE: f64 = 3.0;
const CLEARANCE: f64 = 1.2;
const RADII: [f64; 2] = [0.25, 0.4];
const HEIGHT: f64 = 3.0;
/// Shorter lines are not detected, pixels; of the others this part is.
const LEAST_LENGTH: f64 = 40.0;
const DETECTION: f64 = 0.9;

/// What surrounds the cylinders.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Texture {
    /// Nothing.
    None,
    /// A floor of 20 x 20 squares.
    Floor,
    /// A wall of 20 x 8 tiles behind the cylinders.
    Wall,
    /// Two rows of seven boxes on each other, behind the cylinders.
    Boxes,
}

/// How a scene is made.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TextureSetup {
    pub(crate) texture: Texture,
    pub(crate) cylinders: usize,
    pub(crate) images: usize,
    /// The cameras stand on this part of the ring, radians.
    pub(crate) arc: f64,
    /// Standard deviation of each coordinate of the ends of lines, pixels.
    pub(crate) noise: f64,
}

/// Lines, and the cylinders among them.
pub(crate) struct TexturedScene {
    pub(crate) views: Vec<View>,
    pub(crate) cylinders: Vec<Cylinder>,
}

impl TextureSetup {
    /// Seven cylinders in twelve images from all sides, noise of 0.3 pixels.
    pub(crate) fn new(texture: Texture) -> Self {
        Self { texture, cylinders: 7, images: 12, arc: TAU, noise: 0.3 }
    }

    pub(crate) fn scene(&self, seed: u64) -> TexturedScene {
        let Self { texture, cylinders, images, arc, noise } = *self;
        let mut random = Random::new(seed);
        let turn = Rotation3::from_euler_angles(random.uniform(0.0, 3.0), random.uniform(-0.5, 0.5), 1.0);
        let circles = circles(cylinders, &mut random);
        let edges = texture.edges();
        let view = |index: usize, random: &mut Random| {
            let (camera, centre) = camera(arc * (index as f64 + random.uniform(0.0, 0.7)) / images as f64, random);
            let of_edges = edges.iter().filter(|edge| edge.is_seen(&centre)).map(|edge| edge.ends);
            let of_cylinders = silhouettes(&circles, &centre);
            let segments: Vec<_> = of_edges.chain(of_cylinders).filter_map(|ends| seen(&camera, &ends)).collect();
            let detected = segments.into_iter().filter(|_| random.uniform(0.0, 1.0) < DETECTION);
            let detected: Vec<_> = detected.collect();
            let mut moved = |end: Point2<f64>| end + Vector2::new(random.normal(), random.normal()) * noise;
            let lines: Vec<_> = detected.into_iter().map(|ends| ends.map(&mut moved)).collect();
            let in_world = camera.fixed_columns::<3>(0) * turn.matrix().transpose();
            let [a, b, c] = [0, 1, 2].map(|column| in_world.column(column).into_owned());
            let camera = Matrix3x4::from_columns(&[a, b, c, camera.column(3).into_owned()]);
            let calibration = Calibration::new(&calibration()).expect("a calibration");
            let camera = Camera::from_normalised(&camera).expect("a camera").with_calibration(calibration);
            View::from_pixel_segments(camera, &lines).expect("lines")
        };
        let views = (0..images).map(|index| view(index, &mut random)).collect();
        let up = Unit::new_unchecked(turn * Vector3::z());
        let cylinder = |(foot, radius): &(Point2<f64>, f64)| {
            Cylinder::new(&(turn * Point3::new(foot.x, foot.y, 0.5 * HEIGHT)), up, *radius)
        };
        TexturedScene { views, cylinders: circles.iter().map(cylinder).collect() }
    }
}

impl TexturedScene {
    /// Numbers of cylinders that are among those found, and of others. Axis in the middle and
    /// radius are off by less than a tenth of the radius, the direction by less than a hundredth.
    pub(crate) fn right_and_false(&self, found: &[Cylinder]) -> [usize; 2] {
        let is_same = |found: &Cylinder, truth: &Cylinder| {
            let axis = found.distance(&truth.axis_point) + found.radius;
            axis.max((found.radius - truth.radius).abs()) < 0.1 * truth.radius
                && found.direction.cross(&truth.direction).norm() < 0.01
        };
        let is_found = |truth: &&Cylinder| found.iter().any(|found| is_same(found, truth));
        let is_true = |found: &&Cylinder| self.cylinders.iter().any(|truth| is_same(found, truth));
        let right = self.cylinders.iter().filter(is_found).count();
        [right, found.len() - found.iter().filter(is_true).count()]
    }
}

/// An edge, seen if its surface or one of its two faces the camera: a point and the normal of each.
struct Edge {
    ends: [Point3<f64>; 2],
    faces: Vec<Vector3<f64>>,
}

impl Edge {
    fn is_seen(&self, centre: &Point3<f64>) -> bool {
        self.faces.iter().any(|normal| normal.dot(&(centre - self.ends[0])) > 0.0)
    }
}

impl Texture {
    fn edges(self) -> Vec<Edge> {
        let lines = |count: usize, from: f64, step: f64| (0..=count).map(move |index| from + step * index as f64);
        match self {
            Self::None => Vec::new(),
            Self::Floor => {
                let edge = |one: [f64; 2], other: [f64; 2]| Edge {
                    ends: [one, other].map(|[x, y]| Point3::new(x, y, 0.0)),
                    faces: vec![Vector3::z()],
                };
                lines(20, -6.0, 0.6).flat_map(|at| [edge([at, -6.0], [at, 6.0]), edge([-6.0, at], [6.0, at])]).collect()
            }
            Self::Wall => {
                let edge = |one: [f64; 2], other: [f64; 2]| Edge {
                    ends: [one, other].map(|[x, z]| Point3::new(x, 4.5, z)),
                    faces: vec![-Vector3::y()],
                };
                let upright = lines(20, -6.0, 0.6).map(|x| edge([x, 0.0], [x, 4.0]));
                upright.chain(lines(8, 0.0, 0.5).map(|z| edge([-6.0, z], [6.0, z]))).collect()
            }
            Self::Boxes => {
                let corners = |row: usize, layer: usize| {
                    let start = Point3::new(-5.0, 4.5 + 1.6 * row as f64, 0.9 * layer as f64);
                    (0..7).map(move |place| start + Vector3::x() * (1.5 * place as f64))
                };
                let boxes = (0..2).flat_map(|row| (0..2).flat_map(move |layer| corners(row, layer)));
                boxes.flat_map(|corner| edges_of_box(&corner, &Vector3::new(1.0, 1.0, 0.8))).collect()
            }
        }
    }
}

/// The twelve edges of a box from a corner and its size.
fn edges_of_box(corner: &Point3<f64>, size: &Vector3<f64>) -> Vec<Edge> {
    let edge = |along: usize, ends: [bool; 2]| {
        let others = [(along + 1) % 3, (along + 2) % 3];
        let mut start = *corner;
        let mut faces = Vec::new();
        for (axis, at_end) in others.into_iter().zip(ends) {
            let mut normal = Vector3::zeros();
            normal[axis] = if at_end { 1.0 } else { -1.0 };
            start[axis] += if at_end { size[axis] } else { 0.0 };
            faces.push(normal);
        }
        let mut end = start;
        end[along] += size[along];
        Edge { ends: [start, end], faces }
    };
    let sides = [[false, false], [false, true], [true, false], [true, true]];
    (0..3).flat_map(|along| sides.map(|ends| edge(along, ends))).collect()
}

fn calibration() -> Matrix3<f64> {
    Matrix3::new(FOCAL, 0.0, 0.5 * SIZE[0], 0.0, FOCAL, 0.5 * SIZE[1], 0.0, 0.0, 1.0)
}

/// A camera at this angle of the ring that looks at the middle, and its centre.
fn camera(angle: f64, random: &mut Random) -> (Matrix3x4<f64>, Point3<f64>) {
    let distance = random.uniform(DISTANCES[0], DISTANCES[1]);
    let height = random.uniform(CAMERA_HEIGHTS[0], CAMERA_HEIGHTS[1]);
    let centre = Point3::new(angle.cos() * distance, angle.sin() * distance, height);
    let target = Vector3::new(random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4), 1.2);
    let forward = (target - centre.coords).normalize();
    let right = forward.cross(&Vector3::z()).normalize();
    let upright = Matrix3::from_rows(&[right.transpose(), forward.cross(&right).transpose(), forward.transpose()]);
    let rotation = Rotation3::from_axis_angle(&Vector3::z_axis(), random.uniform(-0.15, 0.15)).matrix() * upright;
    let [a, b, c] = [0, 1, 2].map(|column| rotation.column(column).into_owned());
    (Matrix3x4::from_columns(&[a, b, c, -(rotation * centre.coords)]), centre)
}

/// Circles that are apart from each other.
fn circles(count: usize, random: &mut Random) -> Vec<(Point2<f64>, f64)> {
    let mut circles: Vec<(Point2<f64>, f64)> = Vec::with_capacity(count);
    while circles.len() < count {
        let centre = Point2::from(Vector2::from_fn(|_, _| random.uniform(-HALF_SIDE, HALF_SIDE)));
        if circles.iter().all(|(other, _)| (other - centre).norm() >= CLEARANCE) {
            circles.push((centre, random.uniform(RADII[0], RADII[1])));
        }
    }
    circles
}

/// The silhouettes that no other cylinder hides, as lines on the surfaces.
fn silhouettes(circles: &[(Point2<f64>, f64)], camera: &Point3<f64>) -> Vec<[Point3<f64>; 2]> {
    let camera = camera.xy();
    let mut lines = Vec::new();
    for (index, (centre, radius)) in circles.iter().enumerate() {
        let toward = camera - centre;
        let cosine = radius / toward.norm();
        let toward = toward.normalize();
        let across = Vector2::new(-toward.y, toward.x) * (1.0 - cosine * cosine).sqrt();
        for across in [across, -across] {
            let contact = centre + (toward * cosine + across) * *radius;
            let sight = contact - camera;
            let hides = |(other, (centre, radius)): (usize, &(Point2<f64>, f64))| {
                let along = ((centre - camera).dot(&sight) / sight.norm_squared()).clamp(0.0, 1.0);
                other != index && (camera + sight * along - centre).norm() < *radius
            };
            if !circles.iter().enumerate().any(hides) {
                lines.push([0.0, HEIGHT].map(|height| Point3::new(contact.x, contact.y, height)));
            }
        }
    }
    lines
}

/// The part of an edge that the image shows, pixels; `None` if it is too short.
fn seen(camera: &Matrix3x4<f64>, ends: &[Point3<f64>; 2]) -> Option<[Point2<f64>; 2]> {
    let [first, second] = ends.map(|end| calibration() * camera * end.to_homogeneous());
    // The edge is at `first + t (second - first)`; each bound is a product that is not negative.
    let bounds = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, SIZE[0]], [0.0, -1.0, SIZE[1]]];
    let mut range = [0.0_f64, 1.0_f64];
    for bound in bounds.map(Vector3::from) {
        // In front of the camera by a tenth.
        let least = if bound.xy() == Vector2::zeros() { 0.1 } else { 0.0 };
        let [at_first, at_second] = [&first, &second].map(|end| bound.dot(end) - least);
        let crossing = at_first / (at_first - at_second);
        match (at_first >= 0.0, at_second >= 0.0) {
            (true, true) => {}
            (true, false) => range[1] = range[1].min(crossing),
            (false, true) => range[0] = range[0].max(crossing),
            (false, false) => return None,
        }
    }
    let [low, high] = range.map(|place| {
        let point = first + (second - first) * place;
        Point2::from(point.xy() / point.z)
    });
    (range[0] < range[1] && (high - low).norm() >= LEAST_LENGTH).then_some([low, high])
}
