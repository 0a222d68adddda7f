//! Readers of the cylinders' observations: scenes, segments, models.

use std::time::Duration;

use eliminant_cylinders::colmap::{Encoding, Model, parse_colmap};
use eliminant_cylinders::distortion::Distortion;
use eliminant_cylinders::photograph::Photograph;
use eliminant_cylinders::{Calibration, Camera, ColmapError, Scene, Segments, View, parse_scene, parse_segments};
use nalgebra::{Matrix3, Matrix3x4, Point2};

use crate::mutate::Kind;
use crate::outcome::Outcome;
use crate::target::Target;

const JSON: [&str; 34] = [
    "\"K\":",
    "\"views\":",
    "\"points\":",
    "\"image\":",
    "\"camera_normalised\":",
    "\"camera_pixels\":",
    "\"lines_normalised\":",
    "\"lines_pixels\":",
    "\"segments_pixels\":",
    "\"cylinders\":",
    "null",
    "true",
    "{",
    "}",
    "[",
    "]",
    ",",
    ":",
    "\"",
    "[0,0,0]",
    "[1,0,0]",
    "[0,1,0]",
    "[0,0,1]",
    "[1,0,0,0]",
    "[[1,0,0,0],[0,1,0,0],[0,0,1,5]]",
    "[[3000,0,2000],[0,3000,1500],[0,0,1]]",
    "1e308",
    "-1e-308",
    "1e400",
    "\\u0000",
    "\\ud800",
    "\"a\"",
    "[null]",
    "[]",
];

const CSV: [&str; 18] = [
    "image",
    "x1",
    "y1",
    "x2",
    "y2",
    "cylinder",
    "line",
    "left.jpg",
    "right.jpg",
    "bent.jpg",
    ",",
    "\n",
    "\"",
    "\"\"",
    "\r\n",
    "nan",
    "inf",
    "1e308",
];

const COLMAP: [&str; 16] = [
    "SIMPLE_PINHOLE",
    "PINHOLE",
    "SIMPLE_RADIAL",
    "RADIAL",
    "OPENCV",
    "FULL_OPENCV",
    "# Number of cameras: 1\n",
    "# Number of images: 1, mean observations per image: 0\n",
    "# Number of points: 1, mean track length: 0\n",
    "#",
    "\n",
    " ",
    "0",
    "-1",
    "a.jpg",
    SEPARATOR,
];

/// Stands between the three files of a model in one input.
const SEPARATOR: &str = "\n%%%\n";

/// Segments in images of the models of the corpus.
const SEGMENTS: &str = "image,x1,y1,x2,y2\na.jpg,10,20,100,400\na.jpg,30,20,120,400\nb.jpg,1,2,3,4\n";

pub(super) fn targets() -> Vec<Target> {
    let bound = Duration::from_secs(1);
    let (scene_words, csv_words) = (Kind::Text(&JSON), Kind::Text(&CSV));
    vec![
        Target {
            name: "scene",
            what: "scene files: JSON to views, lines of each cylinder, segments added",
            kind: scene_words,
            longest: 8192,
            bound,
            run: scene,
        },
        Target {
            name: "segments",
            what: "CSV files: text to segments, fitted lines of three photographs",
            kind: csv_words,
            longest: 4096,
            bound,
            run: segments,
        },
        Target {
            name: "colmap",
            what: "COLMAP models, text and binary: photographs, distortion, views",
            kind: Kind::Bytes(&COLMAP),
            longest: 4096,
            bound,
            run: colmap,
        },
    ]
}

/// What a reader promises of views.
fn demand_views(outcome: &mut Outcome, views: &[View]) {
    for view in views {
        let count = view.lines().len();
        let is_whole = view.ends().len() == count && view.labels().len() == count && view.planes().count() == count;
        outcome.demand(is_whole, || "lines, ends, labels and planes differ in number".into());
        let lines = view.lines().iter().all(|line| (line.norm() - 1.0).abs() < 1e-9);
        let ends = view.ends().iter().flatten().flatten().all(|end| end.coords.iter().all(|x| x.is_finite()));
        outcome.demand(lines && ends, || format!("a line or its end is not finite: {view:?}"));
        let centre = view.camera().centre();
        outcome.demand(centre.coords.iter().all(|x| x.is_finite()), || format!("the centre is at {centre}"));
        outcome.count("lines", count);
    }
    outcome.count("views", views.len());
}

fn scene(input: &[u8]) -> Outcome {
    let mut outcome = Outcome::default();
    match parse_scene(&String::from_utf8_lossy(input), "scene.json") {
        Ok(scene) => {
            outcome.accepted = true;
            demand_views(&mut outcome, &scene.views);
            let lines: usize = scene.views.iter().map(|view| view.lines().len()).sum();
            let cylinders = scene.cylinders();
            let parts: usize = cylinders.iter().map(|cylinder| cylinder.lines.len()).sum();
            outcome.demand(parts == lines, || format!("{lines} lines, of cylinders {parts}"));
            outcome.count("cylinders", cylinders.len());
            outcome.count("points", scene.points.len());
            if let Ok(segments) = parse_segments(SEGMENTS.as_bytes(), "segments.csv") {
                match scene.with_segments(&segments) {
                    Ok(scene) => demand_views(&mut outcome, &scene.views),
                    Err(error) => outcome.see(&error.to_string()),
                }
            }
        }
        Err(error) => outcome.see(&error.to_string()),
    }
    outcome
}

/// Three photographs; the last is bent.
fn photographs() -> Vec<Photograph> {
    let calibration = Calibration::new(&Matrix3::new(3000.0, 0.0, 2000.0, 0.0, 3000.0, 1500.0, 0.0, 0.0, 1.0)).ok();
    let matrix = Matrix3x4::new(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 5.0);
    let camera = Camera::from_normalised(&matrix).ok();
    let calibrated = camera.zip(calibration).map(|(camera, calibration)| camera.with_calibration(calibration));
    let bent = Distortion::polynomial([-0.2, 0.05], [0.001, -0.002]);
    let named = |(name, camera, distortion): (&str, Option<Camera>, Distortion)| {
        camera.map(|camera| Photograph { name: name.to_owned(), camera, distortion })
    };
    let all = [
        ("left.jpg", calibrated, Distortion::default()),
        ("right.jpg", camera, Distortion::default()),
        ("bent.jpg", calibrated, bent),
    ];
    all.into_iter().filter_map(named).collect()
}

fn views_of(outcome: &mut Outcome, segments: &Segments, photographs: &[Photograph]) {
    match segments.views(photographs) {
        Ok(views) => {
            outcome.accepted = true;
            demand_views(outcome, &views);
        }
        Err(error) => outcome.see(&error.to_string()),
    }
}

fn segments(input: &[u8]) -> Outcome {
    let mut outcome = Outcome::default();
    match parse_segments(input, "segments.csv") {
        Ok(segments) => views_of(&mut outcome, &segments, &photographs()),
        Err(error) => outcome.see(&error.to_string()),
    }
    outcome
}

/// The first byte says how the files are written, `t` or `b`; [`SEPARATOR`] stands between them.
fn colmap(input: &[u8]) -> Outcome {
    let mut outcome = Outcome::default();
    let (encoding, rest) = match input.split_first() {
        Some((b'b', rest)) => (Encoding::Binary, rest),
        Some((_, rest)) => (Encoding::Text, rest),
        None => (Encoding::Text, input),
    };
    let [first, rest] = cut(rest);
    let [second, third] = cut(rest);
    let [cameras, images, points] = encoding.file_names();
    outcome.see(cameras);
    match parse_colmap(encoding, [(cameras, first), (images, second), (points, third)]) {
        Ok(model) => taken(&mut outcome, model),
        // The name of an unknown model is the input's own, and not in quotation marks.
        Err(ColmapError::UnsupportedModel { .. }) => outcome.see("unsupported model"),
        Err(error) => outcome.see(&format!("{cameras} {error}")),
    }
    outcome
}

fn taken(outcome: &mut Outcome, model: Model) {
    outcome.accepted = true;
    outcome.count("photographs", model.photographs.len());
    outcome.count("points", model.points.len());
    for photograph in &model.photographs {
        for pixel in [Point2::new(0.0, 0.0), Point2::new(2000.0, 1500.0), Point2::new(-1e9, 1e9)] {
            let ideal = photograph.undistort(&pixel);
            let is_finite = ideal.is_none_or(|ideal| ideal.coords.iter().all(|x| x.is_finite()));
            outcome.demand(is_finite, || format!("{pixel} comes from {ideal:?}"));
            outcome.see(if ideal.is_some() { "undistorted" } else { "not undistorted" });
        }
    }
    if let Ok(segments) = parse_segments(SEGMENTS.as_bytes(), "segments.csv") {
        match Scene::from_colmap(model, &segments) {
            Ok(scene) => demand_views(outcome, &scene.views),
            Err(error) => outcome.see(&error.to_string()),
        }
    }
}

/// The parts before and after the first separator.
fn cut(bytes: &[u8]) -> [&[u8]; 2] {
    let found = bytes.windows(SEPARATOR.len()).position(|window| window == SEPARATOR.as_bytes());
    found.map_or([bytes, &[]], |at| [&bytes[..at], &bytes[at + SEPARATOR.len()..]])
}
