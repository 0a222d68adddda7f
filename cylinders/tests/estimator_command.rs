//! `cylinders triangulate` with `--robust`, `--refine` and `--parallel`.

#![cfg(feature = "command")]

use std::path::Path;

use eliminant_cylinders::command::run;
use serde_json::{Value, json};

/// Exit status, output and error.
fn command(arguments: &[&str]) -> (u8, String, String) {
    let (mut output, mut error) = (Vec::new(), Vec::new());
    let code = run(["cylinders", "triangulate"].iter().chain(arguments), &mut output, &mut error);
    let [output, error] = [output, error].map(|bytes| String::from_utf8(bytes).expect("UTF-8"));
    (code, output, error)
}

fn report(arguments: &[&str]) -> Value {
    let (code, output, error) = command(&[arguments, &["--json"]].concat());
    assert_eq!((code, error.as_str()), (0, ""));
    serde_json::from_str(&output).expect("JSON")
}

fn soda_can() -> Value {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/soda_can.json");
    serde_json::from_str(&std::fs::read_to_string(path).expect("a scene")).expect("JSON")
}

/// Writes the scene to a file of this name and returns its path.
fn file(name: &str, scene: &Value) -> String {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, scene.to_string()).expect("a writable folder for tests");
    path.display().to_string()
}

/// The soda can with a wrong line before the lines of the third view and after the lines of the
/// sixth view.
fn with_wrong_lines(name: &str) -> String {
    let mut scene = soda_can();
    scene["views"][2]["lines_pixels"].as_array_mut().expect("lines").insert(0, json!([0.6, 0.8, -2500.0]));
    scene["views"][5]["lines_pixels"].as_array_mut().expect("lines").push(json!([1.0, 0.1, -700.0]));
    file(name, &scene)
}

#[test]
fn wrong_lines_are_outliers() {
    let scene = with_wrong_lines("robust.json");
    let clean = file("clean.json", &soda_can());
    let (robust, refined) = (report(&["--robust", &scene]), report(&["--refine", &clean]));
    assert_eq!(robust["consensus"]["inliers"], 16);
    assert_eq!(robust["consensus"]["lines"], 18);
    let outliers: Vec<_> =
        robust["residuals"].as_array().expect("an array").iter().filter(|line| line["inlier"] == false).collect();
    let places: Vec<_> = outliers.iter().map(|line| (&line["view"], &line["line"])).collect();
    assert_eq!(places, [(&json!(2), &json!(0)), (&json!(5), &json!(2))]);
    let [robust, refined] = [robust, refined].map(|report| report["radius"].as_f64().expect("a number"));
    assert!((robust / refined - 1.0).abs() < 1e-9, "{robust} {refined}");

    let (code, text, _) = command(&["--robust", &scene]);
    assert_eq!(code, 0);
    assert_eq!(text.matches("outlier").count(), 2, "{text}");
    assert!(text.contains("of 18 lines"), "{text}");
}

#[test]
fn the_same_seed_gives_the_same_output() {
    let scene = with_wrong_lines("seed.json");
    let output = |seed| command(&["--robust", "--confidence", "0.9999", "--seed", seed, &scene]).1;
    assert_eq!(output("5"), output("5"));
}

#[test]
fn refinement_has_deviations() {
    let scene = file("refine.json", &soda_can());
    let (plain, refined) = (report(&[&scene]), report(&["--refine", &scene]));
    assert_eq!(plain.get("refinement"), None);
    assert_eq!(refined["singular_values"], plain["singular_values"]);
    let number = |report: &Value, key: &str| report[key].as_f64().expect("a number");
    let deviation = number(&refined["refinement"], "radius_deviation");
    // The true radius is 33.
    assert!((number(&refined, "radius") - 33.0).abs() < 4.0 * deviation && deviation < 0.1, "{deviation}");
    assert_eq!(refined["refinement"]["unit"], "pixels");
    let rms = number(&refined["refinement"], "image_rms");
    // End points are off by half a pixel.
    assert!(rms > 0.2 && rms < 1.0, "{rms}");
    let (_, text, _) = command(&["--refine", &scene]);
    assert!(text.contains("deviations"), "{text}");
}

#[test]
fn parallel_cylinders_have_one_direction() {
    let mut scene = soda_can();
    // The views of even and odd number as two cylinders.
    for (index, view) in scene["views"].as_array_mut().expect("views").iter_mut().enumerate() {
        let label = ["even", "odd"][index % 2];
        view["cylinders"] = json!([label, label]);
    }
    let path = file("parallel.json", &scene);
    let (alone, shared) = (report(&[&path]), report(&["--parallel", &path]));
    let direction = |report: &Value, index: usize| report["cylinders"][index]["direction"].clone();
    assert_ne!(direction(&alone, 0), direction(&alone, 1));
    assert_eq!(direction(&shared, 0), direction(&shared, 1));
}

#[test]
fn few_lines_say_what_to_pass() {
    let mut scene = soda_can();
    let views = scene["views"].as_array_mut().expect("views");
    views.truncate(2);
    views[1]["lines_pixels"].as_array_mut().expect("lines").truncate(1);
    let path = file("few.json", &scene);
    let (code, output, error) = command(&["--robust", &path]);
    assert_eq!((code, output.as_str()), (1, ""));
    assert!(error.starts_with(&format!("error: {path}: 3 line(s) given")), "{error}");
    assert!(error.contains("pass at least four lines"), "{error}");
}

#[test]
fn wrong_usage_is_2() {
    for (arguments, expected) in [
        (&["--threshold", "2", "a.json"][..], "not provided:\n  --robust"),
        (&["--seed", "2", "a.json"], "not provided:\n  --robust"),
        (&["--robust", "--threshold=0", "a.json"], "not a number greater than 0"),
        (&["--robust", "--threshold=NaN", "a.json"], "not a number greater than 0"),
        (&["--robust", "--confidence=1", "a.json"], "not a number between 0 and 1"),
        (&["--robust", "--parallel", "a.json"], "cannot be used with"),
        (&["--refine", "--parallel", "a.json"], "cannot be used with"),
    ] {
        let (code, output, error) = command(arguments);
        assert_eq!((code, output.as_str()), (2, ""), "{arguments:?}");
        assert!(error.contains(expected), "{arguments:?}: {error}");
    }
}
