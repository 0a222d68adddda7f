//! `cylinders triangulate`: exit codes, where text goes, and that both forms of the output say the same.

#![cfg(feature = "command")]

use std::path::{Path, PathBuf};

use eliminant_solvers::cylinder::command::run;

/// What a run writes, and its exit status.
struct Outcome {
    code: u8,
    output: String,
    error: String,
}

fn command(arguments: &[&str]) -> Outcome {
    let (mut output, mut error) = (Vec::new(), Vec::new());
    let code = run(["cylinders", "triangulate"].iter().chain(arguments), &mut output, &mut error);
    let [output, error] = [output, error].map(|bytes| String::from_utf8(bytes).expect("UTF-8"));
    Outcome { code, output, error }
}

fn soda_can() -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("data/soda_can.json").display().to_string()
}

/// A file with this text, in the folder that cargo gives to tests.
fn file(name: &str, text: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, text).expect("a writable folder for tests");
    path
}

#[test]
fn a_good_scene_prints_its_cylinder() {
    let text = command(&[&soda_can()]);
    assert_eq!((text.code, text.error.as_str()), (0, ""));
    let json = command(&["--json", &soda_can()]);
    assert_eq!((json.code, json.error.as_str()), (0, ""));

    let report: serde_json::Value = serde_json::from_str(&json.output).expect("JSON");
    let radius = report["radius"].as_f64().expect("a number");
    assert!(text.output.contains(&format!("radius           {radius:14.7}\n")), "{}", text.output);
    let residuals = report["residuals"].as_array().expect("an array");
    assert_eq!(residuals.len(), 16);
    // Below the blank line and the heading of the table there is one row for each line.
    let (_, table) = text.output.split_once("\n\n").expect("a table");
    assert_eq!(table.lines().count(), 1 + residuals.len());
    for key in ["axis_point", "direction", "singular_values"] {
        assert_eq!(report[key].as_array().map(Vec::len), Some(3), "{key}");
    }
}

#[test]
fn help_is_no_error() {
    let outcome = command(&["--help"]);
    assert_eq!(outcome.code, 0);
    assert!(outcome.output.contains("Usage: cylinders triangulate"));
}

#[test]
fn wrong_usage_is_2() {
    for (arguments, expected) in [
        (&[][..], "error: the following required arguments were not provided:\n  <SCENE>\n"),
        (&["--jsom", "a.json"], "error: unexpected argument '--jsom' found\n"),
        (&["a.json", "b.json"], "error: unexpected argument 'b.json' found\n"),
    ] {
        let outcome = command(arguments);
        assert_eq!((outcome.code, outcome.output.as_str()), (2, ""));
        assert!(outcome.error.starts_with(expected) && outcome.error.contains("Usage:"), "{}", outcome.error);
    }
}

#[test]
fn a_bad_scene_is_1_and_names_the_file() {
    let missing = command(&["no/such/file.json"]);
    assert_eq!((missing.code, missing.output.as_str()), (1, ""));
    assert!(missing.error.starts_with("error: no/such/file.json: "), "{}", missing.error);

    let folder = env!("CARGO_MANIFEST_DIR");
    let outcome = command(&[folder]);
    assert_eq!(outcome.code, 1);
    assert!(outcome.error.starts_with(&format!("error: {folder}: ")), "{}", outcome.error);

    for (name, text, expected) in [
        ("not_json.json", "cylinder", ":1:1: not JSON: "),
        ("no_views.json", "{\"views\": []}", ": 0 silhouette line(s) given"),
    ] {
        let path = file(name, text).display().to_string();
        let outcome = command(&["--json", &path]);
        assert_eq!(outcome.code, 1);
        assert!(outcome.error.starts_with(&format!("error: {path}{expected}")), "{}", outcome.error);
        assert!(outcome.error.ends_with('\n'));
        let json: serde_json::Value = serde_json::from_str(&outcome.output).expect("JSON");
        assert_eq!(Some(outcome.error.trim_end()), json["error"].as_str().map(|e| format!("error: {e}")).as_deref());
    }
}

/// The example does nothing but pass on what `run` says. Cargo builds the examples before it runs the tests of a package;
/// a run of this test alone may find none.
#[test]
fn the_example_passes_it_on() {
    let test = std::env::current_exe().expect("a path");
    let example = test.parent().and_then(Path::parent).expect("the profile's folder").join("examples");
    let example = example.join(format!("triangulate{}", std::env::consts::EXE_SUFFIX));
    if !example.exists() {
        eprintln!("skipped: {} is not built", example.display());
        return;
    }
    let run = |arguments: &[&str]| std::process::Command::new(&example).args(arguments).output().expect("a run");
    let good = run(&[&soda_can()]);
    assert_eq!(good.status.code(), Some(0));
    assert_eq!(String::from_utf8_lossy(&good.stdout), command(&[&soda_can()]).output);
    assert_eq!(run(&["no/such/file.json"]).status.code(), Some(1));
    assert_eq!(run(&[]).status.code(), Some(2));
}
