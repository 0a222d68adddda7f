//! Experiments through the command: their files exist and depend on the seed only, and their claims
//! hold.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;

/// Runs `cylinders` with its files in a folder of this test.
fn experiment(folder: &Path, threads: usize, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_cylinders"))
        .arg("experiment")
        .args(arguments)
        .arg("--out")
        .arg(folder)
        .env("RAYON_NUM_THREADS", threads.to_string())
        .output()
        .expect("the command runs")
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("experiments").join(name);
    // Files of an earlier run could be mistaken for files of this run.
    let _ = fs::remove_dir_all(&folder);
    folder
}

fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = fs::read_dir(folder).expect("the folder").map(|entry| entry.expect("an entry"));
    entries
        .map(|entry| (entry.file_name().into_string().expect("a name"), fs::read(entry.path()).expect("a file")))
        .collect()
}

/// Runs an experiment on one and on two threads; returns its summary.
fn check(name: &str, runs: &str, tables: &[&str], pictures: &[&str]) -> Value {
    let [one, two] = [1, 2].map(|threads| {
        let folder = folder(&format!("{name}-{threads}"));
        let output = experiment(&folder, threads, &[name, "--runs", runs, "--seed", "5"]);
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        assert!(output.stderr.is_empty(), "no progress bar where there is no terminal");
        let files = files(&folder);
        assert_eq!(files["summary.txt"], output.stdout);
        files
    });
    let mut expected: Vec<_> = tables.iter().map(|name| format!("{name}.csv")).collect();
    expected.extend(pictures.iter().flat_map(|name| ["svg", "png"].map(|format| format!("{name}.{format}"))));
    expected.extend(["summary.json", "summary.txt"].map(str::to_owned));
    expected.sort();
    assert_eq!(one.keys().cloned().collect::<Vec<_>>(), expected);
    for (file, content) in &one {
        assert!(content == &two[file], "{file} depends on the number of threads");
        assert!(!content.is_empty(), "{file} is empty");
    }
    serde_json::from_slice(&one["summary.json"]).expect("the summary is JSON")
}

/// The rows of a table of a summary in which these columns have these values.
fn rows<'a>(summary: &'a Value, table: &str, filter: &[(&str, Value)]) -> Vec<&'a Value> {
    let tables = summary["tables"].as_array().expect("tables");
    let table = tables.iter().find(|candidate| candidate["name"] == table).expect("the table");
    let rows = table["rows"].as_array().expect("rows").iter();
    rows.filter(|row| filter.iter().all(|(column, value)| row[column] == *value)).collect()
}

/// The number in a column of the only such row.
fn number(summary: &Value, table: &str, filter: &[(&str, Value)], column: &str) -> f64 {
    let rows = rows(summary, table, filter);
    assert_eq!(rows.len(), 1, "{table} {filter:?}");
    rows[0][column].as_f64().unwrap_or_else(|| panic!("{table} {filter:?}: no number in `{column}`"))
}

#[test]
fn noise_free_solutions_are_exact() {
    let summary = check("residuals", "2000", &["residual", "error"], &["residual", "solvers", "error"]);
    for method in ["minimal", "closed-form", "least-squares", "linear"] {
        let number = |table, column| number(&summary, table, &[("method", method.into())], column);
        assert!(number("residual", "50 %") < 1e-14, "{method}");
        assert!(number("error", "50 %") < 1e-12, "{method}");
        assert!(number("error", "above 1e-8") <= 2.0, "{method}: one in a thousand");
    }
}

#[test]
fn the_response_to_noise_is_nearly_linear() {
    let summary = check("noise", "300", &["translation", "radius", "linearity"], &["translation", "radius"]);
    for row in rows(&summary, "linearity", &[]) {
        assert!(row["1 - R^2"].as_f64().expect("a number") < 0.05, "{row}");
    }
    for error in ["translation", "radius"] {
        let median = |lines: usize, circle: &str, sigma: f64| {
            let row = [("lines", lines.into()), ("circle", circle.into()), ("sigma", sigma.into())];
            number(&summary, error, &row, "median")
        };
        assert!(median(10, "in front", 0.02) < median(6, "in front", 0.02), "{error}");
        assert!(median(6, "in front", 0.02) < median(4, "in front", 0.02), "{error}");
        assert!(median(4, "nearest", 0.02) < median(3, "nearest", 0.02), "{error}");
        for circle in ["nearest", "in front", "least cost"] {
            assert!(median(4, "nearest", 0.02) <= median(4, circle, 0.02), "{error}, {circle}");
            assert!(median(4, circle, 0.0) < 1e-8, "{error}, {circle}");
        }
    }
}

#[test]
fn proposed_and_navab_are_nearer_to_the_truth_than_linear() {
    let tables = ["table1", "details", "fixed", "fixed_sets"];
    let summary = check("table1", "200", &tables, &["noise_0.5", "noise_2", "noise_8"]);
    for pixels in [0.5, 2.0, 8.0] {
        for images in [3, 5, 10, 15] {
            let mean = |method: &str| {
                number(
                    &summary,
                    "table1",
                    &[("method", method.into()), ("pixels", pixels.into())],
                    &format!("{images} images"),
                )
            };
            assert!(mean("proposed") < 0.8 * mean("linear"), "{pixels} pixels, {images} images");
            assert!(mean("proposed") < 1.1 * mean("navab"), "{pixels} pixels, {images} images");
        }
        let row = [("method", "linear".into()), ("pixels", pixels.into()), ("images", 2.into())];
        assert_eq!(number(&summary, "details", &row, "none"), 1.0, "four lines are too few for a conic");
    }
    // Views among fixed photographs: the figures of the paper, but for the method of Navab, are
    // within a third of the median over sets of photographs.
    for images in [3, 5, 10, 15] {
        let number = |method: &str, column: &str| {
            number(&summary, "fixed_sets", &[("method", method.into()), ("images", images.into())], column)
        };
        for method in ["proposed", "linear"] {
            let ratio = number(method, "50 %") / number(method, "paper");
            assert!((0.67..1.5).contains(&ratio), "{method}, {images} images: {ratio}");
        }
        assert!(number("nearest", "50 %") <= number("proposed", "50 %"), "{images} images");
    }
}

#[test]
fn a_limited_range_makes_hyperbolas_of_linear_estimates_only() {
    let pictures = ["hyperbolas", "least_squares", "example"];
    let summary = check("conditioning", "100", &["conditioning"], &pictures);
    let number = |range: f64, sigma: f64, column: &str| {
        number(&summary, "conditioning", &[("range", range.into()), ("sigma", sigma.into())], column)
    };
    assert!(number(20.0, 0.01, "linear hyperbola") > 0.3);
    assert!(number(20.0, 0.005, "linear hyperbola") > number(20.0, 0.001, "linear hyperbola"));
    assert!(number(10.0, 0.002, "linear hyperbola") > number(60.0, 0.002, "linear hyperbola"));
    assert_eq!(number(360.0, 0.001, "linear hyperbola"), 0.0);
    assert!(number(20.0, 0.01, "least squares median error") < 0.1);
    for row in rows(&summary, "conditioning", &[]) {
        assert_eq!(row["least squares none"], 0.0, "{row}");
    }
}

#[test]
fn one_side_of_the_silhouette_is_enough() {
    let summary = check("one_sided", "200", &["one_sided", "ranges"], &["one_sided", "ranges", "example"]);
    for pixels in [0.25, 0.5, 1.0, 2.0, 4.0, 8.0] {
        let distance = |method: &str| {
            number(&summary, "one_sided", &[("method", method.into()), ("pixels", pixels.into())], "mean distance")
        };
        assert!(distance("proposed") < 0.8 * distance("linear"), "{pixels} pixels");
        assert!(distance("proposed") < 0.02 * pixels, "{pixels} pixels");
    }
    for range in [60.0, 90.0, 120.0] {
        let number = |method: &str, sigma: f64, column: &str| {
            let row = [("method", method.into()), ("range", range.into()), ("sigma", sigma.into())];
            number(&summary, "ranges", &row, column)
        };
        assert!(number("linear", 0.0001, "times") > 10.0, "{range} degrees");
        assert_eq!(number("proposed", 0.001, "no ellipse"), 0.0, "{range} degrees");
        if range < 100.0 {
            assert!(number("linear", 0.001, "no ellipse") > 0.05, "{range} degrees");
            // Without the side, a small circle among the lines costs less than the cylinder.
            assert!(number("in front", 0.0005, "times") > 10.0, "{range} degrees");
        }
    }
}

#[test]
fn seven_cylinders_are_found_among_clutter() {
    let parts = ["paper", "outlier_rate", "noise", "chosen_bound", "detection", "directions"];
    let summary = check("matching", "2", &parts, &["outlier_rate", "noise", "chosen_bound", "detection"]);
    let number = |column| number(&summary, "paper", &[("told", "number, direction".into())], column);
    assert!(number("outlier rate") >= 0.89);
    assert_eq!((number("all"), number("false (mean)")), (1.0, 0.0));
    // The bound, twice the default, is what the search gets.
    let at = |table, column| self::number(&summary, table, &[("noise / pixels", 3.0.into())], column);
    assert!(at("chosen_bound", "bound / pixels") > at("noise", "bound / pixels"));
    assert!(at("chosen_bound", "found (mean)") > at("noise", "found (mean)"));
}

#[test]
fn a_scene_file_is_solved_by_all_methods() {
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/soda_can.json");
    let folder = folder("real");
    let output = experiment(&folder, 2, &["real", scene.to_str().expect("a path")]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let files = files(&folder);
    assert!(files.contains_key("section.svg") && files.contains_key("silhouettes_7.png"));
    assert!(!files.contains_key("points.svg"), "the scene has no points");
    let summary = serde_json::from_slice(&files["summary.json"]).expect("the summary is JSON");
    for method in ["minimal", "closed-form", "linear", "navab", "least-squares", "refined"] {
        let radius = number(&summary, "methods", &[("method", method.into())], "radius");
        assert!((radius - 33.0).abs() < 1.0, "{method}: {radius}");
    }
    let pixels = |method: &str| number(&summary, "methods", &[("method", method.into())], "pixels");
    assert!(pixels("refined") <= pixels("least-squares"));
}

/// The pictures of the documents are those that the command writes with 2000 runs.
#[test]
fn committed_pictures_are_written_by_the_command() {
    let committed = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/experiments");
    let mut compared = 0;
    for name in ["residuals", "noise", "table1", "conditioning", "one_sided"] {
        let folder = folder(&format!("documents-{name}"));
        assert_eq!(experiment(&folder, 2, &[name, "--runs", "2000"]).status.code(), Some(0), "{name}");
        let written = files(&folder);
        for (file, content) in files(&committed.join(name)) {
            let command = format!("cylinders experiment {name} --runs 2000 --out {name}");
            assert!(written.get(&file) == Some(&content), "docs/experiments/{name}/{file} is not that of `{command}`");
            compared += 1;
        }
    }
    assert!(compared >= 8, "{compared} pictures");
}

/// Data that are not part of the project.
#[test]
fn pillars_are_in_front_of_both_cameras_and_drawn_over_the_photographs() {
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data/rollercoaster/scene.json");
    if !scene.exists() {
        eprintln!("skipped: {} is not there", scene.display());
        return;
    }
    let folder = folder("pillars");
    let output = experiment(&folder, 2, &["real", scene.to_str().expect("a path")]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let files = files(&folder);
    let summary = serde_json::from_slice(&files["summary.json"]).expect("the summary is JSON");
    for method in ["least-squares", "refined"] {
        let found = rows(&summary, "methods", &[("method", method.into())]);
        assert_eq!(found.len(), 5, "five pillars");
        assert!(found.iter().all(|row| row["in front"] == "yes"), "{found:?}");
    }
    for view in 0..2 {
        let overlay = String::from_utf8(files[&format!("overlay_{view}.svg")].clone()).expect("UTF-8");
        assert!(overlay.contains("data:image/jpeg;base64,"), "the photograph");
        // Both silhouettes of five pillars, given and found.
        assert_eq!(overlay.matches("<path").count(), 20);
    }
}

/// Data that are not part of the project.
#[test]
fn the_points_of_the_round_tower_lie_on_its_cylinder() {
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data/kungshuset.json");
    if !scene.exists() {
        eprintln!("skipped: {} is not there", scene.display());
        return;
    }
    let folder = folder("tower");
    assert_eq!(experiment(&folder, 2, &["real", scene.to_str().expect("a path")]).status.code(), Some(0));
    let summary = serde_json::from_slice(&files(&folder)["summary.json"]).expect("the summary is JSON");
    for method in ["linear", "navab", "least-squares", "refined"] {
        let number = |column| number(&summary, "methods", &[("method", method.into())], column);
        assert!(number("points near") > 2000.0, "{method}");
        // For a wrong fit the points would lie anywhere in the band of +-25 %.
        assert!(number("median").abs() < 0.03 && number("75 %") - number("25 %") < 0.1, "{method}");
        assert!(number("points within 5 %") > 0.7 * number("points near"), "{method}");
    }
}

#[test]
fn seeds_differ_and_repeat() {
    let run = |name: &str, seed| {
        let folder = folder(name);
        assert_eq!(experiment(&folder, 2, &["noise", "--runs", "20", "--seed", seed]).status.code(), Some(0));
        files(&folder)
    };
    let first = run("seed-1", "1");
    assert!(first == run("seed-1-again", "1"));
    assert!(first["radius.csv"] != run("seed-2", "2")["radius.csv"]);
}

#[test]
fn a_folder_that_cannot_be_made_is_at_fault() {
    let file = folder("no-folder");
    fs::create_dir_all(file.parent().expect("a parent")).expect("the folder of the tests");
    fs::write(&file, "no folder").expect("a file");
    let output = experiment(&file, 2, &["noise", "--runs", "1"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&output.stderr).contains("cannot write"));
}

#[test]
fn names_and_numbers_of_runs_are_checked() {
    for arguments in [&["nosie"] as &[&str], &["noise", "--runs", "0"], &["noise", "--runs", "many"]] {
        let output = experiment(&folder("usage"), 2, arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
    }
}

#[test]
fn a_scene_is_for_the_experiment_with_real_images_only() {
    for (arguments, message) in [
        (["noise", "scene.json"], "only the experiment `real`"),
        (["real", "no-such-scene.json"], "no-such-scene.json"),
    ] {
        let folder = folder("no-scene");
        let output = experiment(&folder, 2, &arguments);
        assert_eq!(output.status.code(), Some(1));
        assert!(String::from_utf8_lossy(&output.stderr).contains(message), "{arguments:?}");
        assert!(!folder.exists(), "nothing is half-written");
    }
}
