//! Synthetic scenes: a can, the cameras around it, and the silhouettes that they see.
//!
//! The silhouettes are not computed from tangent planes, as in the solver, but from points: the end
//! points of the two lines on the surface where the line of sight is tangent are projected and
//! moved by noise, and the image line passes through each pair.

use std::f64::consts::TAU;
use std::fmt::Write;

use nalgebra::{Matrix3, Matrix3x4, Point3, Rotation3, Unit, Vector3};

use crate::random::Random;

/// A can: a piece of a cylinder.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Can {
    /// Centre of the bottom.
    pub(crate) base: Point3<f64>,
    /// From the bottom to the top.
    pub(crate) direction: Unit<Vector3<f64>>,
    /// Radius.
    pub(crate) radius: f64,
    /// Height.
    pub(crate) height: f64,
}

/// How a can is photographed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Setup {
    /// Calibration, pixels.
    pub(crate) calibration: Matrix3<f64>,
    /// Number of cameras; one in each sector around the axis.
    pub(crate) cameras: usize,
    /// Smallest and largest distance of a camera from the middle of the can, seen along the axis.
    pub(crate) distance: (f64, f64),
    /// Largest height of a camera above or below the middle of the can.
    pub(crate) elevation: f64,
    /// Standard deviation of each coordinate of a silhouette's end point, pixels.
    pub(crate) noise: f64,
}

/// A photograph: `[R t]` and the two silhouette lines in pixels, normal of unit length.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Photograph {
    /// `[R t]`, world to camera.
    pub(crate) camera: Matrix3x4<f64>,
    /// The lines `(a, b, c)`, pixels.
    pub(crate) lines: [Vector3<f64>; 2],
}

/// Seed of the committed scene.
pub(crate) const SODA_CAN_SEED: u64 = 1;

/// A soda can, millimetres, on a surface that is not level with the world's axes.
pub(crate) fn soda_can() -> Can {
    let direction = Unit::new_normalize(Vector3::new(0.1, -0.2, 0.97));
    Can { base: Point3::new(120.0, -40.0, 30.0), direction, radius: 33.0, height: 115.0 }
}

/// Eight photographs of 4000 x 3000 pixels from about half a metre.
pub(crate) fn soda_can_setup() -> Setup {
    let calibration = Matrix3::new(3000.0, 0.0, 2000.0, 0.0, 3000.0, 1500.0, 0.0, 0.0, 1.0);
    Setup { calibration, cameras: 8, distance: (450.0, 600.0), elevation: 200.0, noise: 0.5 }
}

/// Photographs of the can from all sides.
pub(crate) fn photographs(can: &Can, setup: &Setup, random: &mut Random) -> Vec<Photograph> {
    let direction = can.direction.into_inner();
    let across = Unit::new_normalize(direction.cross(&Vector3::ith(direction.iamin(), 1.0)));
    let middle = can.base + direction * (can.height / 2.0);
    let photograph = |index| {
        let angle = TAU * (index as f64 + random.uniform(0.0, 0.8)) / setup.cameras as f64;
        let outward = Rotation3::from_axis_angle(&can.direction, angle) * across.into_inner();
        let distance = random.uniform(setup.distance.0, setup.distance.1);
        let elevation = random.uniform(-setup.elevation, setup.elevation);
        let centre = middle + outward * distance + direction * elevation;
        let aim = middle + Vector3::from_fn(|_, _| random.uniform(-0.5, 0.5)) * can.radius;
        let camera = look_at(&centre, &aim, &direction, random.uniform(-0.2, 0.2));
        Photograph { camera, lines: silhouettes(can, &centre, &(setup.calibration * camera), setup.noise, random) }
    };
    (0..setup.cameras).map(photograph).collect()
}

/// `[R t]` of a camera at `centre` that looks at `aim`: z forward, y down but for a roll in
/// radians.
fn look_at(centre: &Point3<f64>, aim: &Point3<f64>, up: &Vector3<f64>, roll: f64) -> Matrix3x4<f64> {
    let forward = (aim - centre).normalize();
    let right = forward.cross(up).normalize();
    let down = forward.cross(&right);
    let upright = Matrix3::from_rows(&[right.transpose(), down.transpose(), forward.transpose()]);
    let rotation = Rotation3::from_axis_angle(&Vector3::z_axis(), roll).into_inner() * upright;
    let translation = -(rotation * centre.coords);
    Matrix3x4::from_columns(&[
        rotation.column(0).into_owned(),
        rotation.column(1).into_owned(),
        rotation.column(2).into_owned(),
        translation,
    ])
}

/// The image lines of the two contact lines. Around the axis, measured from the direction to the
/// camera at distance `rho`, the surface is seen tangentially at the angles `+- acos(r / rho)`.
fn silhouettes(
    can: &Can,
    centre: &Point3<f64>,
    camera: &Matrix3x4<f64>,
    noise: f64,
    random: &mut Random,
) -> [Vector3<f64>; 2] {
    let direction = can.direction.into_inner();
    let offset = centre - can.base;
    let perpendicular = offset - direction * direction.dot(&offset);
    let toward = perpendicular.normalize();
    let sideways = direction.cross(&toward);
    let cosine = can.radius / perpendicular.norm();
    let sine = (1.0 - cosine * cosine).sqrt();
    [1.0, -1.0].map(|side| {
        let bottom = can.base + (toward * cosine + sideways * (side * sine)) * can.radius;
        let ends = [bottom, bottom + direction * can.height].map(|point| {
            let image = camera * point.to_homogeneous();
            image / image.z + Vector3::new(random.normal(), random.normal(), 0.0) * noise
        });
        let line = ends[0].cross(&ends[1]);
        line / line.xy().norm()
    })
}

/// The photographs as a scene file, nine decimals for cameras and lines (five for the line's offset
/// in pixels).
pub(crate) fn json(setup: &Setup, photographs: &[Photograph]) -> String {
    let mut text = String::from("{\n");
    let rows = |matrix: &Matrix3<f64>| (0..3).map(|row| numbers(matrix.row(row).iter(), &[1; 3])).collect::<Vec<_>>();
    // Writing to a string cannot fail.
    let _ = writeln!(text, "  \"K\": [{}],\n  \"views\": [", rows(&setup.calibration).join(", "));
    for (index, photograph) in photographs.iter().enumerate() {
        let rows: Vec<_> = (0..3).map(|row| numbers(photograph.camera.row(row).iter(), &[9; 4])).collect();
        let lines: Vec<_> = photograph.lines.iter().map(|line| numbers(line.iter(), &[9, 9, 5])).collect();
        let _ =
            writeln!(text, "    {{\n      \"camera_normalised\": [\n        {}\n      ],", rows.join(",\n        "));
        let _ = writeln!(text, "      \"lines_pixels\": [\n        {}\n      ]", lines.join(",\n        "));
        let _ = writeln!(text, "    }}{}", if index + 1 < photographs.len() { "," } else { "" });
    }
    text.push_str("  ]\n}\n");
    text
}

fn numbers<'a>(numbers: impl Iterator<Item = &'a f64>, decimals: &[usize]) -> String {
    let numbers: Vec<_> = numbers.zip(decimals).map(|(number, &decimals)| format!("{number:.decimals$}")).collect();
    format!("[{}]", numbers.join(", "))
}
