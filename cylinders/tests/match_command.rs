//! `cylinders match`: exit codes and output streams are right, and both forms of the output agree.

#![cfg(feature = "command")]

use std::path::{Path, PathBuf};

use eliminant_cylinders::command::run;
use eliminant_cylinders::simulation::{ParallelScene, ParallelSetup};
use serde_json::{Value, json};

fn command(arguments: &[&str]) -> (u8, String, String) {
    let (mut output, mut error) = (Vec::new(), Vec::new());
    let code = run(["cylinders", "match"].iter().chain(arguments), &mut output, &mut error);
    let [output, error] = [output, error].map(|bytes| String::from_utf8(bytes).expect("UTF-8"));
    (code, output, error)
}

/// A file with this text, in the folder that cargo gives to tests.
fn file(name: &str, text: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, text).expect("a writable folder for tests");
    path
}

fn scene() -> ParallelScene {
    let setup = ParallelSetup { cylinders: 3, images: 8, noise: 0.5, detection: 0.9, outlier_rate: 0.8 };
    setup.scene(2).expect("a scene")
}

fn scene_file(name: &str) -> String {
    let view = |(index, view): (usize, &eliminant_cylinders::View)| {
        let camera = view.camera();
        let row = |row: usize| {
            let rotation = camera.rotation().row(row);
            [rotation[0], rotation[1], rotation[2], camera.translation()[row]]
        };
        let lines: Vec<[f64; 3]> = view.lines().iter().map(|&line| line.into()).collect();
        json!({ "image": format!("{index}.jpg"), "camera_normalised": [row(0), row(1), row(2)], "lines_normalised": lines })
    };
    let views: Vec<Value> = scene().views.iter().enumerate().map(view).collect();
    let text = json!({ "K": [[1000, 0, 800], [0, 1000, 600], [0, 0, 1]], "views": views }).to_string();
    file(name, &text).display().to_string()
}

fn parsed(text: &str) -> Value {
    serde_json::from_str(text).expect("JSON")
}

/// Whether nothing but lines are doubted: clutter lies within the threshold by chance.
fn doubts_lines_only((code, error): (u8, &str)) -> bool {
    code == 0 && error.lines().all(|line| line.starts_with("warning: ") && line.contains("does not fit the others"))
}

#[test]
fn text_and_json_report_the_cylinders() {
    let scene_file = scene_file("match_good.json");
    let out = file("match_out.json", "old").display().to_string();
    let (code, text, error) = command(&[&scene_file, "--out", &out]);
    assert!(doubts_lines_only((code, &error)), "{error}");
    let (code, output, error) = command(&[&scene_file, "--json"]);
    assert!(doubts_lines_only((code, &error)), "{error}");
    assert_eq!(std::fs::read_to_string(&out).expect("a file"), output);

    let report = parsed(&output);
    assert_eq!(report["directions"].as_array().map(Vec::len), Some(1));
    assert_eq!(report["cylinders"][0]["direction"], report["directions"][0]);
    assert_eq!(report["threshold"], json!(3.0));
    let warnings = report["warnings"].as_array().expect("an array");
    assert_eq!(warnings.len(), error.lines().count(), "{warnings:?}");
    let cylinders = report["cylinders"].as_array().expect("an array");
    assert_eq!(cylinders.len(), 3);
    let mut matches = 0;
    for cylinder in cylinders {
        let radius = cylinder["radius"].as_f64().expect("a number");
        assert!(text.contains(&format!("radius           {radius:14.7}\n")), "{text}");
        let expected = scene().cylinders.iter().map(|cylinder| (cylinder.radius - radius).abs()).fold(1.0, f64::min);
        assert!(expected < 0.03, "{radius}");
        matches += cylinder["matches"].as_array().expect("an array").len();
        assert_eq!(cylinder["matches"][0]["image"], format!("{}.jpg", cylinder["matches"][0]["view"]));
    }
    // Each cylinder is refined on its matches, with standard deviations that explain its error.
    for cylinder in cylinders {
        let refined = &cylinder["refined"];
        let [radius, deviation] = [&refined["radius"], &refined["refinement"]["radius_deviation"]]
            .map(|number| number.as_f64().expect("a number"));
        assert_eq!(refined["residuals"].as_array().map(Vec::len), cylinder["matches"].as_array().map(Vec::len));
        let error = scene().cylinders.iter().map(|truth| (truth.radius - radius).abs()).fold(1.0, f64::min);
        assert!(deviation > 0.0 && deviation < 0.01 && error < 5.0 * deviation, "{radius} {deviation}");
    }
    let unmatched = report["unmatched"].as_array().expect("an array").len();
    assert_eq!(report["lines"], matches + unmatched);
}

#[test]
fn what_is_found_is_drawn() {
    let scene_file = scene_file("match_drawn.json");
    let place = |name: &str| Path::new(env!("CARGO_TARGET_TMPDIR")).join(name).display().to_string();
    let (ply, section, folder) = (place("match_drawn.ply"), place("match_drawn.svg"), place("match_drawn"));
    let (code, _, error) = command(&[&scene_file, "--ply", &ply, "--section", &section, "--silhouettes", &folder]);
    assert!(doubts_lines_only((code, &error)), "{error}");
    assert!(std::fs::read(&ply).expect("a file").starts_with(b"ply"));
    for number in 1..=3 {
        let picture = std::fs::read_to_string(place(&format!("match_drawn-{number}.svg"))).expect("a picture");
        assert!(picture.contains("<svg"));
    }
    assert_eq!(std::fs::read_dir(&folder).expect("a folder").count(), 8);
}

/// A PNG file of one pixel that claims to be 1600 x 1200: only its header is read.
const PHOTOGRAPH: &[u8] = b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\x06\x40\0\0\x04\xb0\x08\0\0\0\0";

#[test]
fn the_report_and_the_silhouettes_show_the_photographs_that_are_found() {
    let scene_file = scene_file("match_report.json");
    let place = |name: &str| Path::new(env!("CARGO_TARGET_TMPDIR")).join("match_report").join(name);
    let _ = std::fs::remove_dir_all(place(""));
    std::fs::create_dir_all(place("photographs")).expect("a writable folder for tests");
    for index in 0..3 {
        std::fs::write(place(&format!("photographs/{index}.jpg")), PHOTOGRAPH).expect("written");
    }
    let [page, pictures, photographs] =
        ["page.html", "pictures", "photographs"].map(|name| place(name).display().to_string());
    let (code, _, error) =
        command(&[&scene_file, "--report", &page, "--silhouettes", &pictures, "--images", &photographs]);
    assert!(doubts_lines_only((code, &error)), "{error}");
    let page = std::fs::read_to_string(page).expect("a page");
    assert!(page.contains("3 cylinders") && page.contains("cylinders match"), "title and command");
    assert_eq!(page.matches("<figure>").count(), 8);
    assert_eq!(page.matches("href=\"data:image/png;base64,").count(), 3);
    // A table of three cylinders, and one of the lines of each.
    assert_eq!(page.matches("<table>").count(), 4);
    let mut with_photograph = 0;
    for file in std::fs::read_dir(pictures).expect("a folder") {
        let text = std::fs::read_to_string(file.expect("a file").path()).expect("UTF-8");
        let document = roxmltree::Document::parse(&text).expect("well-formed");
        if document.descendants().any(|node| node.has_tag_name("image")) {
            with_photograph += 1;
            assert_eq!(document.root_element().attribute("viewBox"), Some("0 0 1600 1200"));
            let is_silhouette = |node: &roxmltree::Node| node.attribute("class") == Some("found");
            assert_eq!(document.descendants().filter(is_silhouette).count() % 2, 0);
            assert!(document.descendants().any(|node| is_silhouette(&node)));
        }
    }
    assert_eq!(with_photograph, 3);
}

#[test]
fn options_reach_the_search() {
    let scene_file = scene_file("match_options.json");
    let cylinders = |arguments: &[&str]| {
        let (code, output, error) = command(&[&[scene_file.as_str(), "--json"], arguments].concat());
        assert!(doubts_lines_only((code, &error)), "{error}");
        parsed(&output)["cylinders"].as_array().expect("an array").len()
    };
    assert_eq!(cylinders(&["--count", "1"]), 1);
    let direction = scene().direction;
    let text = format!("{},{},{}", -2.0 * direction.x, -2.0 * direction.y, -2.0 * direction.z);
    assert_eq!(cylinders(&["--direction", &text, "--threshold", "2.5"]), 3);
    assert!(cylinders(&["--first-image", "--least-support", "8"]) >= 1);
}

#[test]
fn what_is_wrong_is_said() {
    let scene_file = scene_file("match_bad.json");
    for (arguments, expected) in [
        (&["--threshold", "500"][..], "the threshold must be positive and less than a tenth of a radian"),
        (&["--least-support", "99"], "no cylinder has 99 of the "),
    ] {
        let (code, output, error) = command(&[&[scene_file.as_str()], arguments].concat());
        assert_eq!((code, output.as_str()), (1, ""));
        assert!(error.starts_with(&format!("error: {scene_file}: {expected}")), "{error}");
    }
    for direction in ["0,0,0", "1,2", "1,x,2", "NaN,1,1"] {
        assert_eq!(command(&[&scene_file, "--direction", direction]).0, 2, "{direction}");
    }
    assert_eq!(command(&[&scene_file, "--directions", "2", "--count", "3"]).0, 2);
    for usage in [["--threshold", "0"], ["--least-support", "3"], ["--least-support", "x"], ["--count", "0"]] {
        let (code, output, error) = command(&[&[scene_file.as_str()], usage.as_slice()].concat());
        assert_eq!((code, output.as_str()), (2, ""), "{error}");
        assert!(error.contains(usage[0]), "{error}");
    }
    assert_eq!(command(&["no/such/file.json"]).0, 1);
    let empty = file("match_empty.json", "{\"views\": []}").display().to_string();
    assert_eq!(command(&[&empty]).0, 1);
}
