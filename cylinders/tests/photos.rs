//! Photographs to cylinders: what stands in rendered photographs is found by their pixels and
//! cameras alone, by the library and by `cylinders photos`.

#![cfg(feature = "command")]

use std::fs;
use std::path::{Path, PathBuf};

use eliminant_cylinders::command::run;
use eliminant_cylinders::distortion::Distortion;
use eliminant_cylinders::photos::decode::{decode_photograph, encode_png};
use eliminant_cylinders::photos::{LineOptions, PhotoMatching, PhotoOptions, Seen, find_in_photographs, seen, snapped};
use eliminant_cylinders::rendering::{RenderedScene, RenderingSetup};
use eliminant_cylinders::{Cylinder, MatchError, View, parse_scene};
use nalgebra::{Point3, Rotation3, UnitQuaternion, Vector3};
use serde_json::{Value, json};

fn barrel() -> Distortion {
    Distortion::polynomial([-0.12, 0.02], [0.001, -0.0005])
}

fn rendered(cylinders: usize, distortion: Distortion, seed: u64) -> RenderedScene {
    let setup = RenderingSetup { cylinders, images: 8, width: 640, height: 480, noise: 2.0, distortion };
    setup.scene(seed).expect("a scene")
}

fn look(scene: &RenderedScene) -> Vec<Seen> {
    let look = |(photograph, image)| seen(photograph, image, &LineOptions::default()).expect("lines");
    scene.photographs.iter().zip(&scene.images).map(look).collect()
}

fn views(scene: &RenderedScene) -> Vec<View> {
    look(scene).into_iter().map(|seen| seen.view).collect()
}

fn found(scene: &RenderedScene) -> Result<PhotoMatching, MatchError> {
    find_in_photographs(&look(scene), None, &PhotoOptions::of(&views(scene)))
}

/// Within a twentieth of the radius in position and radius, and three thousandths in direction.
fn is_same(found: &Cylinder, truth: &Cylinder) -> bool {
    let apart = found.axis_point - truth.axis_at(truth.height(&found.axis_point));
    found.direction.cross(&truth.direction).norm() < 3e-3
        && apart.norm() < 0.05 * truth.radius
        && (found.radius - truth.radius).abs() < 0.05 * truth.radius
}

#[track_caller]
fn check(found: &[Cylinder], scene: &RenderedScene) {
    assert_eq!(found.len(), scene.cylinders.len());
    for truth in &scene.cylinders {
        assert!(found.iter().any(|found| is_same(found, truth)), "{truth:?} is not among {found:?}");
    }
}

#[test]
fn cylinders_on_a_chequered_floor_are_found_and_nothing_else() {
    let scene = rendered(4, Distortion::default(), 1);
    let found = found(&scene).expect("cylinders");
    check(&found.matching.cylinders.iter().map(|found| found.cylinder).collect::<Vec<_>>(), &scene);
}

/// As the example `render_photos` does for more seeds.
#[test]
fn seven_cylinders_in_twelve_photographs_are_found_and_nothing_else() {
    let distortion = Distortion::default();
    let setup = RenderingSetup { cylinders: 7, images: 12, width: 960, height: 720, noise: 2.0, distortion };
    let scene = setup.scene(1).expect("a scene");
    let found = found(&scene).expect("cylinders");
    check(&found.matching.cylinders.iter().map(|found| found.cylinder).collect::<Vec<_>>(), &scene);
}

#[test]
fn a_chequered_floor_without_cylinders_gives_none() {
    let scene = rendered(0, Distortion::default(), 2);
    assert!(views(&scene).iter().map(|view| view.lines().len()).sum::<usize>() > 50, "the floor has lines");
    let found = found(&scene);
    assert!(found.as_ref().map_or(0, |found| found.matching.cylinders.len()) == 0, "{found:?}");
}

#[test]
fn png_files_are_decoded_to_what_was_encoded() {
    let image = rendered(1, Distortion::default(), 3).images.swap_remove(0);
    let bytes = encode_png(&image).expect("a file");
    assert_eq!(decode_photograph(&bytes).expect("an image"), image);
    for length in [0, 1, 4, 40, bytes.len() / 2] {
        assert!(decode_photograph(&bytes[..length]).is_err(), "{length} bytes");
    }
    assert!(decode_photograph(b"\xff\xd8\xff\xe0 not a photograph").is_err());
}

fn command(arguments: &[&str]) -> (u8, String, String) {
    let (mut output, mut error) = (Vec::new(), Vec::new());
    let code = run(["cylinders", "photos"].iter().chain(arguments), &mut output, &mut error);
    let [output, error] = [output, error].map(|bytes| String::from_utf8(bytes).expect("UTF-8"));
    (code, output, error)
}

/// A new folder with the photographs.
fn folder(name: &str, scene: &RenderedScene) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a writable folder for tests");
    for (photograph, image) in scene.photographs.iter().zip(&scene.images) {
        fs::write(folder.join(&photograph.name), encode_png(image).expect("a file")).expect("written");
    }
    folder
}

/// Writes the cameras as a text model of COLMAP.
fn write_model(folder: &Path, scene: &RenderedScene) {
    let k = *scene.photographs[0].camera.calibration().expect("a calibration").matrix();
    let Distortion { radial: [k1, k2, ..], tangential: [p1, p2], .. } = scene.photographs[0].distortion;
    let (f, u, v) = (k[(0, 0)], k[(0, 2)], k[(1, 2)]);
    let mut images = String::new();
    for (index, photograph) in scene.photographs.iter().enumerate() {
        let rotation = Rotation3::from_matrix_unchecked(*photograph.camera.rotation());
        let q = UnitQuaternion::from_rotation_matrix(&rotation);
        let t = photograph.camera.translation();
        let pose = format!("{} {} {} {} {} {} {}", q.w, q.i, q.j, q.k, t.x, t.y, t.z);
        images += &format!("{} {pose} 1 {}\n\n", index + 1, photograph.name);
    }
    let cameras = format!("1 OPENCV 640 480 {f} {f} {u} {v} {k1} {k2} {p1} {p2}\n");
    for (name, text) in [("cameras.txt", cameras), ("images.txt", images), ("points3D.txt", String::new())] {
        fs::write(folder.join(name), text).expect("written");
    }
}

fn cylinders(json: &str) -> Vec<Cylinder> {
    let report: Value = serde_json::from_str(json).expect("JSON");
    let vector = |value: &Value| -> Vector3<f64> { Vector3::from_fn(|row, _| value[row].as_f64().expect("a number")) };
    let cylinder = |value: &Value| {
        let direction = nalgebra::Unit::new_normalize(vector(&value["direction"]));
        let point = Point3::from(vector(&value["axis_point"]));
        Cylinder::new(&point, direction, value["radius"].as_f64().expect("a radius"))
    };
    report["cylinders"].as_array().expect("cylinders").iter().map(cylinder).collect()
}

#[test]
fn photographs_with_distortion_and_a_model_give_cylinders_and_pictures() {
    let scene = rendered(3, barrel(), 4);
    let folder = folder("photos_model", &scene);
    write_model(&folder, &scene);
    let path = |name: &str| folder.join(name).display().to_string();
    let here = folder.display().to_string();
    let (overlays, ply, page) = (path("overlays"), path("cylinders.ply"), path("page.html"));
    let drawings = ["--silhouettes", &overlays, "--ply", &ply, "--report", &page];
    let arguments = [&["--colmap", &here, "--images", &here, "--json"], &drawings[..]].concat();
    let (code, output, error) = command(&arguments);
    assert_eq!(code, 0, "{error}");
    check(&cylinders(&output), &scene);
    assert_eq!(command(&arguments).1, output, "the same again");
    assert!(fs::read(&ply).expect("a file").starts_with(b"ply"));
    let pictures: Vec<_> =
        fs::read_dir(&overlays).expect("a folder").map(|file| file.expect("a file").path()).collect();
    assert_eq!(pictures.len(), scene.images.len());
    for picture in pictures {
        let text = fs::read_to_string(&picture).expect("UTF-8");
        let document = roxmltree::Document::parse(&text).expect("well-formed");
        let count = |name: &str| document.descendants().filter(|node| node.has_tag_name(name)).count();
        assert!(count("path") > 6, "{}", picture.display());
        let image = document.descendants().find(|node| node.has_tag_name("image")).expect("the photograph");
        assert!(image.attribute("href").expect("an address").starts_with("data:image/png;base64,iVBORw0KGgo"));
    }
    let page = fs::read_to_string(&page).expect("UTF-8");
    assert_eq!(page.matches("href=\"data:image/png;base64,").count(), scene.images.len());
    assert!(page.contains("3 cylinders") && page.matches("class=\"section\"").count() == 3);

    // A photograph is missing, or is none: nothing is written.
    fs::remove_dir_all(&overlays).expect("removed");
    fs::write(path("03.png"), "no photograph").expect("written");
    let (code, output, error) = command(&arguments);
    assert!(code != 0 && error.contains("03.png") && error.contains("neither a JPEG nor a PNG"), "{output}{error}");
    fs::remove_file(path("03.png")).expect("removed");
    let (code, output, error) = command(&arguments);
    assert!(code != 0 && error.contains("cannot read") && error.contains("03.png"), "{output}{error}");
    assert!(!Path::new(&overlays).exists());
}

/// The silhouettes of the first cylinder in all photographs, moved by some pixels, as a scene file.
fn marked(scene: &RenderedScene, shift: f64) -> String {
    let k = *scene.photographs[0].camera.calibration().expect("a calibration").matrix();
    let view = |photograph: &eliminant_cylinders::photograph::Photograph| {
        let camera = photograph.camera;
        let row = |row: usize| {
            let rotation = camera.rotation().row(row);
            [rotation[0], rotation[1], rotation[2], camera.translation()[row]]
        };
        let calibration = camera.calibration().expect("a calibration");
        let moved = |line: Vector3<f64>| -> [f64; 3] {
            let line = calibration.line_to_pixels(&line);
            let line = line / line.xy().norm();
            [line.x, line.y, line.z + shift]
        };
        let lines: Vec<_> = scene.cylinders[0].silhouette(&camera).expect("seen").map(moved).into();
        let labels = vec!["a"; lines.len()];
        json!({
            "image": photograph.name, "camera_normalised": [row(0), row(1), row(2)], "lines_pixels": lines,
            "cylinders": labels,
        })
    };
    let rows = [0, 1, 2].map(|row| [k[(row, 0)], k[(row, 1)], k[(row, 2)]]);
    json!({ "K": rows, "views": scene.photographs.iter().map(view).collect::<Vec<_>>() }).to_string()
}

#[test]
fn marked_lines_are_moved_to_the_edges() {
    let scene = rendered(1, Distortion::default(), 6);
    let text = marked(&scene, 3.0);
    let (mut distances, mut moved, mut marked) = (Vec::new(), 0, 0);
    for (view, edges) in parse_scene(&text, "").expect("a scene").views.iter().zip(views(&scene)) {
        let (snapped, count) = snapped(view, &edges).expect("a calibration");
        assert_eq!(snapped.labels(), view.labels());
        let calibration = view.camera().calibration().expect("a calibration");
        let silhouettes = scene.cylinders[0].silhouette(view.camera()).expect("seen");
        for (silhouette, ends) in silhouettes.iter().zip(snapped.ends()) {
            let line = calibration.line_to_pixels(silhouette);
            let distance = |end| line.dot(&calibration.point_to_pixels(&end).to_homogeneous()).abs() / line.xy().norm();
            distances.extend(ends.iter().flatten().map(|end| distance(*end)));
        }
        moved += count;
        marked += silhouettes.len();
    }
    assert_eq!(distances.len(), 2 * moved);
    distances.sort_by(f64::total_cmp);
    println!("{moved} of {marked} moved; distances {distances:.2?}");
    // Not every silhouette has a contrast. All were three pixels away.
    assert!(2 * moved > marked && distances[moved] < 0.5, "{moved} of {marked}: {distances:?}");

    let folder = folder("photos_snap", &scene);
    let (file, here) = (folder.join("scene.json").display().to_string(), folder.display().to_string());
    fs::write(&file, text).expect("written");
    let (code, output, error) = command(&[&file, "--images", &here, "--snap"]);
    assert_eq!(code, 0, "{error}");
    let warning = format!("{} of {marked} lines have no edge", marked - moved);
    assert_eq!(output.contains(&warning), moved < marked, "{output}{error}");
}
