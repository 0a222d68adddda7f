//! Simulated photographs of several similar cylinders among clutter, parallel or of several
//! directions. The truth is known.
//!
//! Silhouettes are not computed from tangent planes, as in the solvers, but from points: the end
//! points of the lines on the surface where the line of sight is tangent are projected and moved by
//! noise, and the image line passes through each pair. A silhouette that another cylinder hides is
//! not seen, and some visible silhouettes are not detected.

use std::f64::consts::TAU;

use nalgebra::{Matrix3, Matrix3x4, Point2, Point3, Rotation3, Unit, Vector2, Vector3};

use crate::numerics::random::Random;
use crate::observations::view::{Calibration, Camera, View, ViewError};
use crate::space::cylinder::{Cylinder, Side};

/// Focal length and principal point, pixels.
const FOCAL: f64 = 1000.0;
const PRINCIPAL: [f64; 2] = [800.0, 600.0];

/// Smallest and largest radius; world units.
const RADII: [f64; 2] = [0.25, 0.4];

/// Half of the length of the cylinders.
const HALF_LENGTH: f64 = 1.5;

/// Half of the side of the square in which their axes stand.
const HALF_SIDE: f64 = 3.0;

/// Smallest distance between two axes.
const CLEARANCE: f64 = 1.2;

/// Smallest and largest distance of a camera from the middle of the square, and largest height
/// above or below it.
const DISTANCES: [f64; 2] = [9.0, 13.0];
const ELEVATION: f64 = 2.0;

/// Largest angle between the first direction and another: no camera stands near an axis. Least
/// angle between two directions. Radians.
const LARGEST_ANGLE: f64 = 0.785;
const LEAST_ANGLE: f64 = 0.436;

/// Numbers of cylinders and images, noise and outliers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParallelSetup {
    /// Number of cylinders, at most ten: there may be no room for more.
    pub cylinders: usize,
    /// Number of images, from all sides.
    pub images: usize,
    /// Standard deviation of each coordinate of a line's end point, pixels.
    pub noise: f64,
    /// Probability with which a visible silhouette is detected.
    pub detection: f64,
    /// Least part of all lines that are not silhouettes of a cylinder, averaged over the cylinders.
    /// With seven cylinders it is 6/7 even without clutter.
    pub outlier_rate: f64,
}

/// A simulated scene and its truth.
#[derive(Clone, Debug, PartialEq)]
pub struct ParallelScene {
    /// The images with their lines, in no order.
    pub views: Vec<View>,
    /// Common direction of the cylinders, or that of the first of them.
    pub direction: Unit<Vector3<f64>>,
    /// All directions of cylinders.
    pub directions: Vec<Unit<Vector3<f64>>>,
    /// The middle of the square in which they stand, at half of their height.
    pub middle: Point3<f64>,
    /// The cylinders.
    pub cylinders: Vec<Cylinder>,
    /// For each line of each view, the index of its cylinder and its side; `None` for clutter.
    pub truth: Vec<Vec<Option<(usize, Side)>>>,
}

impl ParallelSetup {
    /// The set-up of the paper: seven cylinders, twelve images, 89 % outliers. Chosen here: noise
    /// of one pixel, and nine of ten silhouettes detected.
    pub fn seven_in_twelve() -> Self {
        Self { cylinders: 7, images: 12, noise: 1.0, detection: 0.9, outlier_rate: 0.89 }
    }

    /// A random scene of parallel cylinders.
    ///
    /// # Errors
    /// [`ViewError`], but not for finite values.
    pub fn scene(&self, seed: u64) -> Result<ParallelScene, ViewError> {
        self.scene_of_directions(1, seed)
    }

    /// A random scene of cylinders that take turns in so many directions, which are 25 degrees or
    /// more apart and within 45 degrees of the first. Cylinders hide those of their own direction
    /// only.
    ///
    /// # Errors
    /// [`ViewError`], but not for finite values.
    pub fn scene_of_directions(&self, directions: usize, seed: u64) -> Result<ParallelScene, ViewError> {
        let mut random = Random::new(seed);
        let frames = frames(directions, &mut random);
        let circles: Vec<_> = (0..directions)
            .map(|group| circles((self.cylinders + directions - 1 - group) / directions, &mut random))
            .collect();
        let cameras: Vec<_> = (0..self.images).map(|index| self.camera(index, &frames[0], &mut random)).collect();
        let mut photographs: Vec<Vec<MarkedLine>> = Vec::new();
        for camera in &cameras {
            let mut lines = Vec::new();
            for (group, (frame, circles)) in frames.iter().zip(&circles).enumerate() {
                let of_group = self.silhouettes(camera, frame, circles, &mut random);
                // Cylinder `k` of a group is cylinder `group + k directions` of the scene.
                let mark = |(index, side): (usize, Side)| (group + index * directions, side);
                lines.extend(of_group.into_iter().map(|(marked, line)| (marked.map(mark), line)));
            }
            photographs.push(lines);
        }
        self.add_clutter(&mut photographs, &cameras, &frames, &mut random);

        let calibration = Matrix3::new(FOCAL, 0.0, PRINCIPAL[0], 0.0, FOCAL, PRINCIPAL[1], 0.0, 0.0, 1.0);
        let mut views = Vec::with_capacity(self.images);
        let mut truth = Vec::with_capacity(self.images);
        for (camera, mut lines) in cameras.iter().zip(photographs) {
            shuffle(&mut lines, &mut random);
            let (labels, lines): (Vec<_>, Vec<_>) = lines.into_iter().unzip();
            let camera = Camera::from_normalised(&camera.matrix)?.with_calibration(Calibration::new(&calibration)?);
            views.push(View::from_normalised_lines(camera, &lines)?);
            truth.push(labels);
        }
        let cylinder = |index: usize| {
            let (frame, of_group) = (&frames[index % directions], &circles[index % directions]);
            let (centre, radius) = of_group.get(index / directions)?;
            Some(Cylinder::new(&frame.point(centre, 0.0), frame.direction(), *radius))
        };
        Ok(ParallelScene {
            views,
            direction: frames[0].direction(),
            directions: frames.iter().map(Frame::direction).collect(),
            middle: frames[0].origin,
            cylinders: (0..self.cylinders).map_while(cylinder).collect(),
            truth,
        })
    }

    /// Lines along the directions at random places, up to the rate of outliers.
    fn add_clutter(
        &self,
        photographs: &mut [Vec<MarkedLine>],
        cameras: &[Photographer],
        frames: &[Frame],
        random: &mut Random,
    ) {
        let silhouettes: usize = photographs.iter().map(Vec::len).sum();
        let mean = silhouettes as f64 / self.cylinders as f64;
        let clutter = ((mean / (1.0 - self.outlier_rate)).ceil() as usize).saturating_sub(silhouettes);
        for index in 0..clutter {
            let image = index % self.images;
            let frame = &frames[index / self.images % frames.len()];
            let place = Point2::from(Vector2::from_fn(|_, _| random.uniform(-HALF_SIDE, HALF_SIDE)));
            photographs[image].push((None, self.seen(&cameras[image], frame, &place, random)));
        }
    }

    /// A camera in its sector around the scene, directed at the middle of the scene.
    fn camera(&self, index: usize, frame: &Frame, random: &mut Random) -> Photographer {
        let angle = TAU * (index as f64 + random.uniform(0.0, 0.8)) / self.images as f64;
        let distance = random.uniform(DISTANCES[0], DISTANCES[1]);
        let place = Point2::new(angle.cos(), angle.sin()) * distance;
        let centre = frame.point(&place, random.uniform(-ELEVATION, ELEVATION));
        let forward = (frame.origin + Vector3::from_fn(|_, _| random.uniform(-0.3, 0.3)) - centre).normalize();
        let right = forward.cross(&frame.direction()).normalize();
        let upright = Matrix3::from_rows(&[right.transpose(), forward.cross(&right).transpose(), forward.transpose()]);
        let roll = Rotation3::from_axis_angle(&Vector3::z_axis(), random.uniform(-0.2, 0.2));
        let rotation = roll.into_inner() * upright;
        let translation = -(rotation * centre.coords);
        let [first, second, third] = [0, 1, 2].map(|column| rotation.column(column).into_owned());
        Photographer { matrix: Matrix3x4::from_columns(&[first, second, third, translation]), centre }
    }

    /// The silhouettes that are visible and detected.
    fn silhouettes(
        &self,
        camera: &Photographer,
        frame: &Frame,
        circles: &[(Point2<f64>, f64)],
        random: &mut Random,
    ) -> Vec<MarkedLine> {
        let mut lines = Vec::new();
        let place = frame.place(&camera.centre);
        for (index, (centre, radius)) in circles.iter().enumerate() {
            // Around the axis, measured from the direction to the camera at distance rho, contacts
            // are at +-acos(r / rho).
            let toward = place - centre;
            let cosine = radius / toward.norm();
            let toward = toward.normalize();
            // This contact is left of the ray to the axis if the axis points up.
            let left = Vector2::new(-toward.y, toward.x);
            for (side, sign) in [(Side::Left, -1.0), (Side::Right, 1.0)] {
                let contact = centre + (toward * cosine - left * (sign * (1.0 - cosine * cosine).sqrt())) * *radius;
                let hidden = |(other, (centre, radius)): (usize, &(Point2<f64>, f64))| {
                    other != index && hides(centre, *radius, &place, &contact)
                };
                let visible = !circles.iter().enumerate().any(hidden);
                if visible && random.uniform(0.0, 1.0) < self.detection {
                    lines.push((Some((index, side)), self.seen(camera, frame, &contact, random)));
                }
            }
        }
        lines
    }

    /// The image, in normalised coordinates, of the line along the axes through a point of the
    /// cross-section.
    fn seen(&self, camera: &Photographer, frame: &Frame, point: &Point2<f64>, random: &mut Random) -> Vector3<f64> {
        let ends = [-HALF_LENGTH, HALF_LENGTH].map(|height| {
            let image = camera.matrix * frame.point(point, height).to_homogeneous();
            let noise = Vector3::new(random.normal(), random.normal(), 0.0) * (self.noise / FOCAL);
            image / image.z + noise
        });
        ends[0].cross(&ends[1])
    }
}

/// A line, and the cylinder and side whose silhouette it is.
type MarkedLine = (Option<(usize, Side)>, Vector3<f64>);

/// A camera `[R t]` and its centre.
struct Photographer {
    matrix: Matrix3x4<f64>,
    centre: Point3<f64>,
}

/// The cross-section in space. Seen against the direction, the second axis is a right turn from the
/// first.
struct Frame {
    rotation: Rotation3<f64>,
    origin: Point3<f64>,
}

impl Frame {
    fn random(random: &mut Random) -> Self {
        let axis = Unit::new_normalize(Vector3::from_fn(|_, _| random.normal()));
        let rotation = Rotation3::from_axis_angle(&axis, random.uniform(0.0, 3.0));
        Self { rotation, origin: Point3::from(Vector3::from_fn(|_, _| random.uniform(-20.0, 20.0))) }
    }

    fn direction(&self) -> Unit<Vector3<f64>> {
        self.rotation * Vector3::y_axis()
    }

    /// Where a point is in the cross-section.
    fn place(&self, point: &Point3<f64>) -> Point2<f64> {
        let local = self.rotation.inverse() * (point - self.origin);
        Point2::new(local.x, local.z)
    }

    fn point(&self, place: &Point2<f64>, height: f64) -> Point3<f64> {
        self.origin + self.rotation * Vector3::new(place.x, height, place.y)
    }
}

/// So many frames with one origin. The directions are apart from each other.
fn frames(count: usize, random: &mut Random) -> Vec<Frame> {
    let mut frames = vec![Frame::random(random)];
    while frames.len() < count {
        let first = &frames[0];
        let axis = Unit::new_normalize(Vector3::from_fn(|_, _| random.normal()));
        let rotation = Rotation3::from_axis_angle(&axis, random.uniform(0.0, 3.0)) * first.rotation;
        let other = Frame { rotation, origin: first.origin };
        let angle = |frame: &Frame| frame.direction().dot(&other.direction()).abs().min(1.0).acos();
        if angle(first) <= LARGEST_ANGLE && frames.iter().all(|frame| angle(frame) >= LEAST_ANGLE) {
            frames.push(other);
        }
    }
    frames
}

/// Circles that are apart from each other; fewer if there is no room.
fn circles(count: usize, random: &mut Random) -> Vec<(Point2<f64>, f64)> {
    let mut circles: Vec<(Point2<f64>, f64)> = Vec::with_capacity(count);
    for _ in 0..1000 * count {
        if circles.len() == count {
            break;
        }
        let centre = Point2::from(Vector2::from_fn(|_, _| random.uniform(-HALF_SIDE, HALF_SIDE)));
        if circles.iter().all(|(other, _)| (other - centre).norm() >= CLEARANCE) {
            circles.push((centre, random.uniform(RADII[0], RADII[1])));
        }
    }
    circles
}

/// Whether a circle is between a camera and a point.
fn hides(centre: &Point2<f64>, radius: f64, camera: &Point2<f64>, point: &Point2<f64>) -> bool {
    let sight = point - camera;
    let along = ((centre - camera).dot(&sight) / sight.norm_squared()).clamp(0.0, 1.0);
    (camera + sight * along - centre).norm() < radius
}

/// Shuffles by the method of Fisher and Yates.
fn shuffle<T>(items: &mut [T], random: &mut Random) {
    for last in (1..items.len()).rev() {
        let other = random.uniform(0.0, (last + 1) as f64) as usize;
        items.swap(last, other.min(last));
    }
}
