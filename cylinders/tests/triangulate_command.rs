//! `cylinders triangulate`: exit codes and output streams are right, and both forms of the output
//! agree.

#![cfg(feature = "command")]

mod model;

use std::path::{Path, PathBuf};

use eliminant_cylinders::command::run;
use eliminant_cylinders::distortion::Distortion;
use eliminant_cylinders::read_scene;
use model::{TestImage, TestModel, folder};
use nalgebra::{Point2, UnitQuaternion};
use serde_json::Value;

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

    let report: Value = serde_json::from_str(&json.output).expect("JSON");
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
        (&["--colmap", "model"], "error: the following required arguments were not provided:\n  --segments <CSV>\n"),
        (
            &["--colmap", "model", "--segments", "s.csv", "a.json"],
            "error: the argument '--colmap <FOLDER>' cannot be used with '[SCENE]'\n",
        ),
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
        ("no_views.json", "{\"views\": []}", ": 0 silhouette line(s) given, copies counted once"),
    ] {
        let path = file(name, text).display().to_string();
        let outcome = command(&["--json", &path]);
        assert_eq!(outcome.code, 1);
        assert!(outcome.error.starts_with(&format!("error: {path}{expected}")), "{}", outcome.error);
        assert!(outcome.error.ends_with('\n'));
        let json: Value = serde_json::from_str(&outcome.output).expect("JSON");
        assert_eq!(Some(outcome.error.trim_end()), json["error"].as_str().map(|e| format!("error: {e}")).as_deref());
    }
}

/// The committed scene, each view twice, as a COLMAP model with a distorting lens and segments. The
/// can has the label `can`, and its second copy the label `again`.
#[test]
fn a_model_with_segments_gives_the_labelled_cylinders() {
    let scene = read_scene(Path::new(&soda_can())).expect("a scene");
    let lens = Distortion::polynomial([-0.1, 0.02], [0.001, -0.001]);
    let mut model = TestModel { cameras: vec![], images: vec![], points: vec![(1, [120.0, -40.0, 30.0], vec![])] };
    let parameters = vec![3000.0, 3000.0, 2000.0, 1500.0, -0.1, 0.02, 0.001, -0.001];
    model.cameras.push((1, "OPENCV", 4, parameters));
    let mut segments = "image,x1,y1,x2,y2,cylinder\n".to_owned();
    for (index, view) in scene.views.iter().enumerate() {
        let calibration = view.camera().calibration().expect("a calibration");
        let rotation = UnitQuaternion::from_matrix(view.camera().rotation());
        model.images.push(TestImage {
            id: index as u32 + 1,
            quaternion: [rotation.w, rotation.i, rotation.j, rotation.k],
            translation: (*view.camera().translation()).into(),
            camera: 1,
            name: format!("{index}.jpg"),
            observations: vec![],
        });
        for line in view.lines() {
            let [first, second] = [-0.3, 0.4].map(|along| {
                // Near the axis the silhouettes are upright in every image.
                let point = Point2::new(-(line.y * along + line.z) / line.x, along);
                calibration.point_to_pixels(&lens.distort(&point))
            });
            for label in ["can", "again"] {
                segments += &format!("{index}.jpg,{},{},{},{},{label}\n", first.x, first.y, second.x, second.y);
            }
        }
    }
    let segments = file("labelled.csv", &segments).display().to_string();
    let expected: Value = serde_json::from_str(&command(&["--json", &soda_can()]).output).expect("JSON");
    let radius = |report: &Value| report["radius"].as_f64().expect("a number");
    for (name, files) in [("command_text", model.text()), ("command_binary", model.binary())] {
        let folder = folder(name, &files).display().to_string();
        let outcome = command(&["--json", "--colmap", &folder, "--segments", &segments]);
        assert_eq!((outcome.code, outcome.error.as_str()), (0, ""));
        let json: Value = serde_json::from_str(&outcome.output).expect("JSON");
        let cylinders = json["cylinders"].as_array().expect("an array");
        assert_eq!(cylinders.len(), 2);
        for (cylinder, label) in cylinders.iter().zip(["again", "can"]) {
            assert_eq!(cylinder["label"], label);
            assert!((radius(cylinder) / radius(&expected) - 1.0).abs() < 1e-9, "{}", radius(cylinder));
            assert_eq!(cylinder["residuals"][3]["image"], "1.jpg");
            assert_eq!(cylinder["points"]["total"], 1);
        }
        // In the second view the lines of the two labels alternate.
        assert_eq!(cylinders[1]["residuals"][3]["line"], 2);

        let section = Path::new(env!("CARGO_TARGET_TMPDIR")).join("sections.of.svg");
        let drawn = ["again", "can"].map(|label| section.with_file_name(format!("sections.of-{label}.svg")));
        // The output of an earlier run.
        drawn.iter().for_each(|path| drop(std::fs::remove_file(path)));
        let drawing = ["--section", &section.display().to_string()];
        let text = command(&[&["--colmap", &folder, "--segments", &segments], drawing.as_slice()].concat());
        assert!(drawn.iter().all(|path| path.is_file()) && !section.exists(), "one for each cylinder");
        assert_eq!(text.output.matches("radius  ").count(), 2);
        assert!(text.output.starts_with("cylinder") && text.output.contains("   7.jpg\n"), "{}", text.output);
    }
}

#[test]
fn a_bad_model_or_file_of_segments_is_1() {
    let segments = file("unknown_image.csv", "image,x1,y1,x2,y2\nx.jpg,1,2,3,4\n").display().to_string();
    let outcome = command(&["--segments", &segments, &soda_can()]);
    assert_eq!((outcome.code, outcome.error), (1, format!("error: {segments}:2: there is no image `x.jpg`\n")));
    let outcome = command(&["--colmap", "no/such/folder", "--segments", &segments]);
    assert_eq!((outcome.code, outcome.error.starts_with("error: no/such/folder/cameras.txt: ")), (1, true));
}

/// Each kind of scene that determines no cylinder, made from the committed scene: it gives its
/// message and no output file.
#[test]
fn scenes_that_determine_no_cylinder_are_refused_and_nothing_is_written() {
    let text = std::fs::read_to_string(soda_can()).expect("the scene");
    let good: Value = serde_json::from_str(&text).expect("JSON");
    let views = good["views"].as_array().expect("an array");
    let line = |view: usize, line: usize| views[view]["lines_pixels"][line].clone();
    let with_lines = |view: usize, lines: Vec<Value>| {
        let mut view = views[view].clone();
        view["lines_pixels"] = lines.into();
        view
    };
    let upright = |x: f64| {
        serde_json::json!({
            "camera_normalised": [[1, 0, 0, -x], [0, 1, 0, 0], [0, 0, 1, 5]], "lines_normalised": [[1, 0, 0]]
        })
    };
    let cases = [
        (vec![views[0].clone()], "2 silhouette line(s) given, copies counted once; a cylinder needs at least three"),
        (
            vec![with_lines(0, vec![line(0, 0), line(0, 0)]), with_lines(1, vec![line(1, 0)])],
            "2 silhouette line(s) given, copies counted once; a cylinder needs at least three",
        ),
        (vec![views[2].clone(); 4], "all cameras stand at one place"),
        ([0.0, 1.0, 2.0, 3.0].map(upright).to_vec(), "all viewing planes are parallel"),
        (vec![with_lines(0, vec![serde_json::json!([0, 0, 1])])], "views[0].lines_pixels: line 0 has no direction"),
        (vec![with_lines(0, vec![serde_json::json!([1, Value::Null, 1])])], "not a scene: invalid type: null"),
    ];
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("never.json");
    let _ = std::fs::remove_file(&out);
    for (views, expected) in cases {
        let mut scene = good.clone();
        scene["views"] = views.into();
        let path = file("refused.json", &scene.to_string()).display().to_string();
        let outcome = command(&[&path, "--out", &out.display().to_string()]);
        assert_eq!((outcome.code, outcome.output.as_str()), (1, ""));
        assert!(
            outcome.error.starts_with(&format!("error: {path}")) && outcome.error.contains(expected),
            "{}",
            outcome.error
        );
        assert!(!out.exists(), "{expected}");
    }
}

#[test]
fn out_is_written_whole_or_not_at_all() {
    let out = file("out.json", "old");
    let path = out.display().to_string();
    assert_eq!(command(&["no/such/file.json", "--out", &path]).code, 1);
    assert_eq!(std::fs::read_to_string(&out).expect("a file"), "old");

    let outcome = command(&[&soda_can(), "--out", &path]);
    assert_eq!(outcome.code, 0);
    assert_eq!(std::fs::read_to_string(&out).expect("a file"), command(&[&soda_can(), "--json"]).output);

    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    for bad in [folder.join("no/such/folder/out.json"), folder.to_owned()] {
        let outcome = command(&[&soda_can(), "--out", &bad.display().to_string()]);
        assert_eq!((outcome.code, outcome.output.as_str()), (1, ""));
        assert!(outcome.error.starts_with(&format!("error: cannot write `{}`: ", bad.display())), "{}", outcome.error);
    }
    let left = std::fs::read_dir(folder).expect("a folder").filter_map(Result::ok);
    let left: Vec<_> =
        left.map(|entry| entry.file_name()).filter(|name| name.to_string_lossy().ends_with(".tmp")).collect();
    assert!(left.is_empty(), "{left:?}");
}

#[test]
fn drawings_are_written_whole_or_not_at_all() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("drawings");
    // The output of an earlier run.
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a writable folder for tests");
    let path = |name: &str| folder.join(name).display().to_string();
    let names = |folder: &Path| {
        let entries = std::fs::read_dir(folder).expect("a folder").filter_map(Result::ok);
        let mut names: Vec<_> = entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    };

    let outcome = command(&[&soda_can(), "--section", &path("section.jpg")]);
    assert_eq!((outcome.code, outcome.output.as_str()), (2, ""));
    assert!(outcome.error.contains("the name of a picture ends in .svg or .png"), "{}", outcome.error);
    assert_eq!(command(&["no/such/file.json", "--ply", &path("a.ply"), "--silhouettes", &path("images")]).code, 1);
    assert!(names(&folder).is_empty());

    let drawings = ["--ply", &path("a.ply"), "--section", &path("section.png"), "--silhouettes", &path("some/images")];
    let outcome = command(&[&[soda_can().as_str()], drawings.as_slice()].concat());
    assert_eq!((outcome.code, outcome.error.as_str()), (0, ""));
    assert_eq!(names(&folder), ["a.ply", "section.png", "some"]);
    assert_eq!(names(&folder.join("some/images")), (0..8).map(|view| format!("{view:03}.svg")).collect::<Vec<_>>());
    assert!(std::fs::read(path("a.ply")).expect("a file").starts_with(b"ply\n"));

    // A folder is given for a file, and a file for a folder.
    for arguments in [["--ply", &path("some")], ["--silhouettes", &path("a.ply")]] {
        let outcome = command(&[&soda_can(), arguments[0], arguments[1]]);
        assert_eq!((outcome.code, outcome.output.as_str()), (1, ""));
        assert!(outcome.error.starts_with(&format!("error: cannot write `{}`: ", arguments[1])), "{}", outcome.error);
    }
    assert_eq!(names(&folder), ["a.ply", "section.png", "some"]);

    // One of several outputs cannot be written: the others are not, whatever the order.
    for bad in [["--out", &path("some")], ["--ply", &path("some")], ["--section", &path("no/such/section.svg")]] {
        let good = [
            ["--out", &path("out.json")],
            ["--ply", &path("b.ply")],
            ["--section", &path("b.svg")],
            ["--silhouettes", &path("new/images")],
        ];
        let others = good.iter().filter(|argument| argument[0] != bad[0]).flatten().copied();
        let arguments: Vec<_> =
            [soda_can()].iter().map(String::as_str).chain(others).chain(bad).map(str::to_owned).collect();
        let outcome = command(&arguments.iter().map(String::as_str).collect::<Vec<_>>());
        assert_eq!((outcome.code, outcome.output.as_str()), (1, ""), "{}", outcome.error);
        assert_eq!(names(&folder), ["a.ply", "section.png", "some"], "{bad:?}");
    }
}

/// The example only passes on the result of `run`. Cargo builds the examples before it runs the
/// tests of a package; a run of this test alone may not find the example.
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
