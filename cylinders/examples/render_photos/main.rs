//! Renders photographs of cylinders on a chequered floor, searches them, and compares what is found
//! with the truth: `render_photos FIRST_SEED COUNT [CYLINDERS [FOLDER]]`. With a folder, the
//! photographs and a scene file of the first seed are written to it.

use std::path::Path;
use std::time::Instant;
use std::{env, error, fs};

use eliminant_cylinders::distortion::Distortion;
use eliminant_cylinders::photos::{LineOptions, PhotoOptions, Seen, find_in_photographs, seen};
use eliminant_cylinders::rendering::{RenderedScene, RenderingSetup};
use eliminant_cylinders::{Cylinder, View};

/// Twelve photographs of so many cylinders.
fn setup(cylinders: usize) -> RenderingSetup {
    let distortion = Distortion::default();
    RenderingSetup { cylinders, images: 12, width: 960, height: 720, noise: 2.0, distortion }
}

fn main() -> Result<(), Box<dyn error::Error>> {
    let arguments: Vec<_> = env::args().skip(1).collect();
    let number = |index: usize, default: u64| arguments.get(index).map_or(Ok(default), |text| text.parse());
    let (first, count) = (number(0, 1)?, number(1, 1)?);
    let setup = setup(usize::try_from(number(2, 7)?)?);
    for seed in first..first + count {
        let scene = setup.scene(seed).ok_or("no room for the cylinders")?;
        if let Some(folder) = arguments.get(3).filter(|_| seed == first) {
            write(&scene, Path::new(folder))?;
        }
        let start = Instant::now();
        let seen = look(&scene)?;
        let detection = start.elapsed();
        let start = Instant::now();
        let views: Vec<View> = seen.iter().map(|seen| seen.view.clone()).collect();
        let found = find_in_photographs(&seen, None, &PhotoOptions::of(&views));
        let time = start.elapsed();
        let lines: usize = views.iter().map(|view| view.lines().len()).sum();
        let cylinders: Vec<Cylinder> =
            found.iter().flat_map(|found| &found.matching.cylinders).map(|found| found.cylinder).collect();
        let is_seen = |truth: &&Cylinder| cylinders.iter().any(|cylinder| is_same(cylinder, truth));
        let is_true = |found: &&Cylinder| scene.cylinders.iter().any(|truth| is_same(found, truth));
        println!(
            "seed {seed}: {lines} lines, {} of {} found, {} false; detection {:.2} s, search {:.2} s",
            scene.cylinders.iter().filter(is_seen).count(),
            scene.cylinders.len(),
            cylinders.len() - cylinders.iter().filter(is_true).count(),
            detection.as_secs_f64(),
            time.as_secs_f64(),
        );
    }
    Ok(())
}

fn look(scene: &RenderedScene) -> Result<Vec<Seen>, Box<dyn error::Error>> {
    let photographs = scene.photographs.iter().zip(&scene.images);
    Ok(photographs
        .map(|(photograph, image)| seen(photograph, image, &LineOptions::default()))
        .collect::<Result<_, _>>()?)
}

/// Within a twentieth of the radius in position and radius, and three thousandths in direction.
fn is_same(found: &Cylinder, truth: &Cylinder) -> bool {
    let apart = found.axis_point - truth.axis_at(truth.height(&found.axis_point));
    found.direction.cross(&truth.direction).norm() < 3e-3
        && apart.norm() < 0.05 * truth.radius
        && (found.radius - truth.radius).abs() < 0.05 * truth.radius
}

fn write(scene: &RenderedScene, folder: &Path) -> Result<(), Box<dyn error::Error>> {
    fs::create_dir_all(folder)?;
    let mut views = Vec::new();
    let mut calibration = None;
    for (photograph, image) in scene.photographs.iter().zip(&scene.images) {
        let (width, height) = (u32::try_from(image.width())?, u32::try_from(image.height())?);
        let file = fs::File::create(folder.join(&photograph.name))?;
        let mut encoder = png::Encoder::new(file, width, height);
        encoder.set_color(png::ColorType::Grayscale);
        let values: Vec<u8> = image.values().iter().map(|value| *value as u8).collect();
        encoder.write_header()?.write_image_data(&values)?;
        let camera = photograph.camera;
        let (rotation, translation) = (camera.rotation(), camera.translation());
        let row = |row: usize| [rotation[(row, 0)], rotation[(row, 1)], rotation[(row, 2)], translation[row]];
        calibration = camera.calibration().map(|known| *known.matrix());
        views.push(serde_json::json!({
            "image": photograph.name, "camera_normalised": [row(0), row(1), row(2)], "lines_pixels": [],
        }));
    }
    let k = calibration.ok_or("no photographs")?;
    let rows = [0, 1, 2].map(|row| [k[(row, 0)], k[(row, 1)], k[(row, 2)]]);
    let text = serde_json::to_string_pretty(&serde_json::json!({ "K": rows, "views": views }))?;
    fs::write(folder.join("scene.json"), text)?;
    Ok(())
}
