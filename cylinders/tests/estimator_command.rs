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

/// Points on one side of the can and others, and no points.
#[test]
fn points_are_evidence_if_there_are_any() {
    let mut scene = soda_can();
    let without = file("without_points.json", &scene);
    let (code, _, error) = command(&["--points", &without]);
    assert_eq!(code, 1);
    assert!(error.contains("without_points.json: the scene has no points"), "{error}");
    let refined = report(&["--refine", &without]);
    let numbers = |value: &Value| -> Vec<f64> {
        value.as_array().expect("an array").iter().map(|number| number.as_f64().expect("a number")).collect()
    };
    let (at, direction) = (numbers(&refined["axis_point"]), numbers(&refined["direction"]));
    let extent = numbers(&refined["extent"]);
    let across = [[direction[2], 0.0, -direction[0]], [0.0, direction[2], -direction[1]]];
    let length = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    let points: Vec<[f64; 3]> = (0..200)
        .map(|k| {
            let (turn, height) = (f64::from(k) * 0.7, extent[0] + (extent[1] - extent[0]) * f64::from(k % 20) / 20.0);
            let out = [0, 1, 2].map(|i| across[0][i] * turn.cos() + across[1][i] * turn.sin());
            let radius = if k % 2 == 0 { 33.0 } else { 40.0 + f64::from(k) };
            [0, 1, 2].map(|i| at[i] + direction[i] * height + out[i] * radius / length(out))
        })
        .collect();
    scene["points"] = json!(points);
    let with = file("with_points.json", &scene);
    for method in [&["--points"][..], &["--points", "--refine"], &["--points", "--robust"]] {
        let found = report(&[&[with.as_str()], method].concat());
        let evidence = &found["points"]["evidence"];
        let count = evidence["count"].as_f64().expect("a number");
        assert!(count > 50.0 && count < 101.0, "{found}");
        assert!(evidence["deviation"].as_f64().expect("a number") < 0.2);
        assert!((found["radius"].as_f64().expect("a number") - 33.0).abs() < 0.1);
    }
    // Outliers stay in the report, and do not move the cylinder.
    scene["views"][2]["lines_pixels"].as_array_mut().expect("lines").insert(0, json!([0.6, 0.8, -2500.0]));
    let wrong = file("with_points_and_a_wrong_line.json", &scene);
    let found = report(&["--robust", "--points", &wrong]);
    assert!((found["radius"].as_f64().expect("a number") - 33.0).abs() < 0.1);
    let residuals = found["residuals"].as_array().expect("residuals");
    assert_eq!(residuals.len(), 17);
    for line in residuals {
        let is_near = line["pixels"].as_f64().expect("a number").abs() < 5.0;
        assert_eq!(line["inlier"], json!(is_near), "{line}");
        assert_eq!(is_near, (&line["view"], &line["line"]) != (&json!(2), &json!(0)), "{line}");
    }
    let (_, text, _) = command(&["--points", &with]);
    assert!(text.contains("points used"), "{text}");
}

#[test]
fn the_report_is_complete() {
    let scene = file("complete.json", &soda_can());
    for method in [&[][..], &["--refine"], &["--robust"]] {
        let found = report(&[&[scene.as_str()], method].concat());
        let numbers = |value: &Value| -> Vec<f64> {
            value.as_array().expect("an array").iter().map(|number| number.as_f64().expect("a number")).collect()
        };
        // The sign of the direction is canonical.
        let direction = numbers(&found["direction"]);
        assert!(direction[2] > 0.9, "{direction:?}");
        let extent = numbers(&found["extent"]);
        assert!(extent[0] < extent[1]);
        assert_eq!((&found["ambiguous"], &found["warnings"]), (&json!(false), &json!([])));
        assert_eq!((found["independent_lines"].as_u64(), found.get("plausible")), (Some(16), None));
        let refinement = &found["refinement"];
        if method.is_empty() {
            assert!(found["section_rms"].is_number());
            continue;
        }
        let covariance: Vec<_> = refinement["covariance"].as_array().expect("rows").iter().map(numbers).collect();
        for row in 0..5 {
            for column in 0..5 {
                let size = (covariance[row][row] * covariance[column][column]).sqrt();
                assert!((covariance[row][column] - covariance[column][row]).abs() <= 1e-12 * size);
                assert!(covariance[row][column].abs() <= size * (1.0 + 1e-12));
            }
        }
        let number = |key: &str| refinement[key].as_f64().expect("a number");
        assert!((number("radius_deviation").powi(2) / covariance[4][4] - 1.0).abs() < 1e-12);
        let trace = covariance[0][0] + covariance[1][1];
        assert!((number("direction_deviation").powi(2) / trace - 1.0).abs() < 1e-12);
        for across in refinement["across"].as_array().expect("two vectors") {
            let dot: f64 = numbers(across).iter().zip(&direction).map(|(one, other)| one * other).sum();
            assert!(dot.abs() < 1e-12);
        }
        // Sixteen lines have 27 degrees of freedom, and `pixels` are the distances of `image_rms`.
        assert_eq!(number("degrees_of_freedom"), 27.0);
        assert!((number("noise").powi(2) * 27.0 / (number("image_rms").powi(2) * 32.0) - 1.0).abs() < 1e-9);
        let residuals = found["residuals"].as_array().expect("an array");
        let squares: f64 = residuals.iter().map(|line| line["pixels"].as_f64().expect("a number").powi(2)).sum();
        assert!(((squares / 16.0).sqrt() / number("image_rms") - 1.0).abs() < 1e-9);
    }
}

#[test]
fn an_ambiguous_result_lists_all_cylinders() {
    let mut scene = soda_can();
    let views = scene["views"].as_array_mut().expect("views");
    views.truncate(2);
    views[1]["lines_pixels"].as_array_mut().expect("lines").truncate(1);
    let path = file("ambiguous.json", &scene);
    let (code, output, error) = command(&["--json", "--refine", &path]);
    assert_eq!((code, error.lines().count()), (0, 2));
    assert!(error.starts_with("warning: the result is ambiguous: "), "{error}");
    let found: Value = serde_json::from_str(&output).expect("JSON");
    assert_eq!(found["ambiguous"], true);
    let plausible = found["plausible"].as_array().expect("an array");
    assert!(plausible.len() > 1);
    let radii: Vec<_> = plausible.iter().map(|one| one["radius"].as_f64().expect("a number")).collect();
    assert!(radii.iter().any(|radius| (radius / 33.0 - 1.0).abs() < 0.05), "{radii:?}");
    let (_, text, error) = command(&["--refine", &path]);
    assert_eq!(error, "");
    assert_eq!(text.matches("\nplausible ").count(), plausible.len(), "{text}");
    assert!(text.contains("\nwarning: the result is ambiguous"), "{text}");
}

/// The scene in other units and about another origin.
fn moved(scale: f64, shift: [f64; 3]) -> Value {
    let mut scene = soda_can();
    for view in scene["views"].as_array_mut().expect("views") {
        for row in view["camera_normalised"].as_array_mut().expect("rows") {
            let entry = |column: usize| row[column].as_f64().expect("a number");
            let moved = entry(3) * scale - (0..3).map(|column| entry(column) * shift[column]).sum::<f64>();
            row[3] = json!(moved);
        }
    }
    scene
}

#[test]
fn columns_stay_apart_and_small_radii_show_their_digits() {
    let utm = file("utm.json", &moved(0.001, [691_607.25, 5_334_760.5, 519.0]));
    let (code, text, error) = command(&["--refine", &utm]);
    assert_eq!((code, error.as_str()), (0, ""));
    for line in ["axis point", "at  ", "direction"] {
        let line = text.lines().find(|text| text.starts_with(line)).expect("a line");
        let numbers = line.split_whitespace().filter(|word| word.parse::<f64>().is_ok() && word.contains('.')).count();
        assert_eq!(numbers, 3, "{line}");
    }
    let tiny = file("tiny.json", &moved(1e-6 / 33.0, [0.0; 3]));
    let (_, text, _) = command(&["--refine", &tiny]);
    let radius = text.lines().find(|line| line.starts_with("radius")).expect("a line");
    let radius = radius.split_whitespace().nth(1).expect("a number");
    assert!(radius.len() >= 11 && radius.parse::<f64>().is_ok_and(|radius| (radius / 1e-6 - 1.0).abs() < 0.01));
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
    assert!(shared["cylinders"][0]["refinement"].is_null() && shared["shared_radius"].is_null());
    let refined = report(&["--parallel", "--refine", &path]);
    assert_eq!(direction(&refined, 0), direction(&refined, 1));
    assert_ne!(direction(&refined, 0), direction(&shared, 0));
    assert!(refined["cylinders"][0]["refinement"]["direction_deviation"].as_f64().expect("a number") > 0.0);
}

#[test]
fn cylinders_share_a_radius_or_it_is_known() {
    let mut scene = soda_can();
    for (index, view) in scene["views"].as_array_mut().expect("views").iter_mut().enumerate() {
        let label = ["even", "odd"][index % 2];
        view["cylinders"] = json!([label, label]);
    }
    let path = file("shared_radius.json", &scene);
    let shared = report(&["--shared-radius", "--parallel", &path]);
    let [radius, deviation] = ["radius", "radius_deviation"].map(|key| shared["shared_radius"][key].as_f64());
    let (radius, deviation) = (radius.expect("a number"), deviation.expect("a number"));
    assert!((radius - 33.0).abs() < 4.0 * deviation && deviation < 0.2, "{radius} {deviation}");
    for cylinder in shared["cylinders"].as_array().expect("cylinders") {
        assert_eq!(cylinder["radius"], radius);
        assert_eq!(cylinder["refinement"]["radius_deviation"], deviation);
    }
    let (_, text, _) = command(&["--shared-radius", &path]);
    assert!(text.starts_with("shared radius "), "{text}");
    let known = report(&["--radius", "33", &path]);
    assert!(known["shared_radius"].is_null());
    for cylinder in known["cylinders"].as_array().expect("cylinders") {
        assert!((cylinder["radius"].as_f64().expect("a number") - 33.0).abs() < 1e-9);
        assert_eq!(cylinder["refinement"]["radius_deviation"], 0.0);
    }
}

#[test]
fn the_side_of_one_sided_silhouettes_is_kept_or_refused() {
    let mut scene = soda_can();
    for view in scene["views"].as_array_mut().expect("views") {
        view["lines_pixels"].as_array_mut().expect("lines").truncate(1);
    }
    let path = file("one_side.json", &scene);
    let (left, right) = (command(&["--side", "left", "--json", &path]), command(&["--side", "right", "--json", &path]));
    let (good, bad, side) = if left.0 == 0 { (left, right, "left") } else { (right, left, "right") };
    assert_eq!((good.0, bad.0), (0, 1), "{} {}", good.2, bad.2);
    assert!(bad.2.contains("no cylinder in front of the cameras has all lines on its"), "{}", bad.2);
    let report: Value = serde_json::from_str(&good.1).expect("JSON");
    assert!((report["radius"].as_f64().expect("a number") / 33.0 - 1.0).abs() < 0.05);
    assert!(report["residuals"].as_array().expect("lines").iter().all(|line| line["side"] == side));
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
        (&["--robust", "--shared-radius", "a.json"], "cannot be used with"),
        (&["--radius", "1", "--shared-radius", "a.json"], "cannot be used with"),
        (&["--side", "left", "--parallel", "a.json"], "cannot be used with"),
        (&["--side", "above", "a.json"], "invalid value"),
        (&["--radius=-1", "a.json"], "not a number greater than 0"),
    ] {
        let (code, output, error) = command(arguments);
        assert_eq!((code, output.as_str()), (2, ""), "{arguments:?}");
        assert!(error.contains(expected), "{arguments:?}: {error}");
    }
}
