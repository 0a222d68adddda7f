//! Cylinders in two or three photographs, from their edges and the even surface between them.

use std::path::Path;

use eliminant_cylinders::detection::GreyImage;
use eliminant_cylinders::distortion::Distortion;
use eliminant_cylinders::photograph::Photograph;
use eliminant_cylinders::photos::decode::decode_photograph;
use eliminant_cylinders::photos::{LineOptions, PhotoOptions, Seen, find_in_photographs, seen};
use eliminant_cylinders::random::Random;
use eliminant_cylinders::{Calibration, Camera, Cylinder, View, read_scene};
use nalgebra::{Matrix3, Matrix3x4, Point3, Rotation3, Unit, Vector3};

const SIZE: [usize; 2] = [800, 600];
const FOCAL: f64 = 900.0;

fn calibration() -> Matrix3<f64> {
    let [width, height] = SIZE.map(|size| size as f64 / 2.0);
    Matrix3::new(FOCAL, 0.0, width, 0.0, FOCAL, height, 0.0, 0.0, 1.0)
}

/// Cameras beside each other that look at the origin from a distance of 12.
fn photograph(index: usize, random: &mut Random) -> Photograph {
    let angle = 0.2 * index as f64 + random.uniform(-0.03, 0.03);
    let rotation = Rotation3::from_euler_angles(random.uniform(-0.1, 0.1), angle, random.uniform(-0.1, 0.1));
    let translation = Vector3::new(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), 12.0);
    let mut matrix = Matrix3x4::zeros();
    matrix.fixed_columns_mut::<3>(0).copy_from(rotation.matrix());
    matrix.set_column(3, &translation);
    let calibration = Calibration::new(&calibration()).expect("a calibration");
    let camera = Camera::from_normalised(&matrix).expect("a camera").with_calibration(calibration);
    Photograph { name: format!("{index}.png"), camera, distortion: Distortion::default() }
}

/// Pillars beside each other, each tilted, of a height of 7 about the plane z = 0.
fn pillars(random: &mut Random) -> Vec<Cylinder> {
    let pillar = |index: usize| {
        let direction = Vector3::new(random.uniform(-0.15, 0.15), 1.0, random.uniform(-0.15, 0.15));
        let foot = Point3::new(2.6 * index as f64 - 2.6, 0.0, random.uniform(-1.5, 1.5));
        Cylinder::new(&foot, Unit::new_normalize(direction), random.uniform(0.25, 0.5))
    };
    (0..3).map(pillar).collect()
}

/// Grey pillars, lit from the left, before a light sky, with noise. `flat` ones are as bright on
/// all sides.
fn image(photograph: &Photograph, pillars: &[Cylinder], flat: bool, random: &mut Random) -> GreyImage {
    let [width, height] = SIZE;
    let (camera, inverse) = (&photograph.camera, calibration().try_inverse().expect("a calibration"));
    let (centre, to_world) = (camera.centre(), camera.rotation().transpose());
    let light = Vector3::new(-0.7, 0.3, -0.5).normalize();
    let mut values = Vec::with_capacity(width * height);
    for pixel in 0..width * height {
        // Four rays smooth the edges.
        let sample = |sub: usize| {
            let x = (pixel % width) as f64 + 0.25 + 0.5 * (sub % 2) as f64;
            let y = (pixel / width) as f64 + 0.25 + 0.5 * (sub / 2) as f64;
            let ray = (to_world * inverse * Vector3::new(x, y, 1.0)).normalize();
            let hit = pillars.iter().filter_map(|pillar| hit(pillar, &centre, &ray));
            let nearest = hit.min_by(|a, b| a.0.total_cmp(&b.0));
            nearest.map_or(200.0, |(_, normal)| if flat { 100.0 } else { 100.0 + 60.0 * normal.dot(&light) })
        };
        values.push(((0..4).map(sample).sum::<f64>() / 4.0 + 2.0 * random.normal()) as f32);
    }
    GreyImage::new(width, height, values).expect("an image")
}

/// Distance and normal where a ray meets a pillar.
fn hit(pillar: &Cylinder, centre: &Point3<f64>, ray: &Vector3<f64>) -> Option<(f64, Vector3<f64>)> {
    let direction = pillar.direction.into_inner();
    let across = |v: Vector3<f64>| v - direction * direction.dot(&v);
    let (start, step) = (across(centre - pillar.axis_point), across(*ray));
    let (a, b) = (step.norm_squared(), step.dot(&start));
    let root = (b * b - a * (start.norm_squared() - pillar.radius.powi(2))).sqrt();
    let distance = (-b - root) / a;
    let point = centre + ray * distance;
    let is_seen = distance > 0.0 && point.y.abs() < 3.5;
    is_seen.then(|| (distance, (start + step * distance) / pillar.radius))
}

fn look(photographs: &[Photograph], images: &[GreyImage]) -> Vec<Seen> {
    let options = LineOptions::default();
    photographs
        .iter()
        .zip(images)
        .map(|(photograph, image)| seen(photograph, image, &options).expect("lines"))
        .collect()
}

fn found(seen: &[Seen]) -> Vec<Cylinder> {
    let views: Vec<View> = seen.iter().map(|seen| seen.view.clone()).collect();
    let found = find_in_photographs(seen, None, &PhotoOptions::of(&views));
    found.iter().flat_map(|found| &found.matching.cylinders).map(|found| found.cylinder).collect()
}

/// Whether radii agree to a tenth, axes to a fifth of the radius, and directions to a twentieth of
/// a radian.
fn is_same(found: &Cylinder, truth: &Cylinder) -> bool {
    let apart = found.distance(&truth.axis_point) + found.radius;
    (found.radius / truth.radius - 1.0).abs() < 0.1
        && apart < 0.2 * truth.radius
        && found.direction.cross(&truth.direction).norm() < 0.05
}

#[test]
fn tilted_pillars_are_found_in_two_and_three_photographs() {
    for count in [2, 3] {
        let (mut right, mut wrong) = (0, 0);
        for seed in 0..12 {
            let random = &mut Random::new(seed);
            let truth = pillars(random);
            let photographs: Vec<_> = (0..count).map(|index| photograph(index, random)).collect();
            let images: Vec<_> =
                photographs.iter().map(|photograph| image(photograph, &truth, false, random)).collect();
            let found = found(&look(&photographs, &images));
            right += truth.iter().filter(|truth| found.iter().any(|found| is_same(found, truth))).count();
            wrong += found.iter().filter(|found| !truth.iter().any(|truth| is_same(found, truth))).count();
        }
        println!("{count} photographs: {right} of 36 found, {wrong} others");
        assert!(right >= 33 && wrong == 0, "{count}: {right}, {wrong}");
    }
}

/// What is as bright all across it may be a flat band.
#[test]
fn flat_bands_are_not_taken_for_cylinders() {
    for seed in 0..4 {
        let random = &mut Random::new(seed);
        let truth = pillars(random);
        let photographs: Vec<_> = (0..2).map(|index| photograph(index, random)).collect();
        let images: Vec<_> = photographs.iter().map(|photograph| image(photograph, &truth, true, random)).collect();
        assert_eq!(found(&look(&photographs, &images)), [], "{seed}");
    }
}

/// The pillars of a roller-coaster in two photographs, given their cameras only. The scene has the
/// silhouettes of five, marked by hand.
#[test]
fn pillars_of_a_roller_coaster_are_found() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data/rollercoaster");
    let Ok(scene) = read_scene(&folder.join("scene.json")) else {
        println!("skipped: {} is not there", folder.display());
        return;
    };
    let photographs = scene.photographs().expect("names of images");
    let read = |photograph: &Photograph| {
        decode_photograph(&std::fs::read(folder.join(&photograph.name)).expect("a photograph")).expect("a photograph")
    };
    let images: Vec<_> = photographs.iter().map(read).collect();
    let found = found(&look(&photographs, &images));
    // Marked lines are within 8 pixels of the silhouettes of the cylinder that is found, where the
    // image shows them.
    let shows = |cylinder: &Cylinder, label: &str| {
        scene.views.iter().all(|view| {
            let calibration = view.camera().calibration().expect("a calibration");
            let in_pixels = |line: &Vector3<f64>| {
                let line = calibration.line_to_pixels(line);
                line / line.xy().norm()
            };
            let silhouettes = cylinder.silhouette(view.camera()).expect("a silhouette").map(|line| in_pixels(&line));
            let marked = view.lines().iter().zip(view.labels()).filter(|(_, of)| of.as_deref() == Some(label));
            marked.map(|(line, _)| in_pixels(line)).all(|line| {
                let meets = |silhouette: &Vector3<f64>, y: f64| {
                    let at = |line: &Vector3<f64>| -(line.y * y + line.z) / line.x;
                    (at(silhouette) - at(&line)).abs() < 8.0
                };
                silhouettes.iter().any(|silhouette| meets(silhouette, 500.0) && meets(silhouette, 900.0))
            })
        })
    };
    for label in ["p0", "p1", "p2", "p3", "p4"] {
        assert!(found.iter().any(|cylinder| shows(cylinder, label)), "{label} is not found");
    }
    // A straight part of the rail looks like a pillar.
    assert!(found.len() <= 6, "{} cylinders", found.len());
}
