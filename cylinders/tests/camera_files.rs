//! Cameras of other programs: `transforms.json` and Bundler's files that are written from known
//! cameras give these cameras again, and bad files are refused with file, place and reason.

use std::path::Path;

use eliminant_cylinders::colmap::Model;
use eliminant_cylinders::distortion::{Distortion, Projection};
use eliminant_cylinders::{
    Calibration, PixelOrigin, Scene, View, parse_bundler, parse_segments, parse_transforms, read_scene, triangulate,
};
use nalgebra::{Matrix3, Point2, Vector3};
use serde_json::{Value, json};

/// The committed scene: eight views, two lines each, calibration 3000, (2000, 1500).
fn views() -> Vec<View> {
    read_scene(&Path::new(env!("CARGO_MANIFEST_DIR")).join("data/soda_can.json")).expect("a scene").views
}

fn calibration() -> Calibration {
    Calibration::new(&Matrix3::new(2900.0, 0.0, 2000.0, 0.0, 2900.0, 1500.0, 0.0, 0.0, 1.0)).expect("a calibration")
}

/// Camera to world in the axes of OpenGL, with this scale of the rotation.
fn transform(view: &View, scale: f64) -> Value {
    let (rotation, centre) = (view.camera().rotation().transpose(), view.camera().centre());
    let row = |row: usize| {
        let scaled = rotation.row(row) * scale;
        json!([scaled[0], -scaled[1], -scaled[2], centre[row]])
    };
    json!([row(0), row(1), row(2), [0, 0, 0, 1]])
}

fn transforms(views: &[View], intrinsics: &Value, scale: f64) -> Value {
    let frame = |(index, view): (usize, &View)| json!({ "file_path": format!("images/{index}.jpg"), "transform_matrix": transform(view, scale) });
    let mut file = intrinsics.clone();
    file["frames"] = views.iter().enumerate().map(frame).collect::<Vec<_>>().into();
    file
}

/// Segments of all lines as the lens shows them, in images with these names.
fn segments(views: &[View], lens: &Distortion, name: impl Fn(usize) -> String) -> String {
    let mut text = "image,x1,y1,x2,y2\n".to_owned();
    for (index, view) in views.iter().enumerate() {
        for line in view.lines() {
            let [first, second] = [-0.3, 0.4].map(|along| {
                let point = Point2::new(-(line.y * along + line.z) / line.x, along);
                calibration().point_to_pixels(&lens.distort(&point))
            });
            text += &format!("{},{},{},{},{}\n", name(index), first.x, first.y, second.x, second.y);
        }
    }
    text
}

fn check(model: Model, csv: &str, lens: &Distortion) {
    let views = views();
    for (photograph, view) in model.photographs.iter().zip(&views) {
        assert!((photograph.camera.rotation() - view.camera().rotation()).amax() < 1e-12);
        let scale = view.camera().translation().norm();
        assert!((photograph.camera.translation() - view.camera().translation()).norm() < 1e-12 * scale);
        assert_eq!(photograph.camera.calibration(), Some(&calibration()));
        assert_eq!(photograph.distortion, *lens);
    }
    let segments = parse_segments(csv.as_bytes(), "s.csv").expect("segments");
    let scene = Scene::from_colmap(model, &segments).expect("a scene");
    let [found, expected] = [&scene.views, &views].map(|views| triangulate(views).expect("a cylinder").cylinder);
    assert!((found.radius / expected.radius - 1.0).abs() < 1e-6, "{} {}", found.radius, expected.radius);
}

#[test]
fn transforms_give_the_cameras() {
    let lens = Distortion::polynomial([-0.1, 0.02], [0.001, -0.001]);
    let intrinsics = json!({
        "fl_x": 2900, "fl_y": 2900, "cx": 2000, "cy": 1500, "w": 4000, "h": 3000,
        "k1": -0.1, "k2": 0.02, "p1": 0.001, "p2": -0.001, "aabb_scale": 16,
    });
    let csv = segments(&views(), &lens, |index| format!("images/{index}.jpg"));
    for scale in [1.0, 2.5] {
        let text = transforms(&views(), &intrinsics, scale).to_string();
        check(parse_transforms(&text, "t.json").expect("a model"), &csv, &lens);
    }
    // A fisheye, by the field of view, and with intrinsics of each frame.
    let lens = Distortion {
        projection: Projection::Equidistant,
        radial: [0.05, -0.01, 0.004, -0.001, 0.0, 0.0],
        ..Distortion::default()
    };
    let mut file =
        transforms(&views(), &json!({ "fl_x": 1, "w": 4000, "h": 3000, "camera_model": "OPENCV_FISHEYE" }), 1.0);
    for frame in file["frames"].as_array_mut().expect("frames") {
        for (key, value) in [("fl_x", 2900.0), ("k1", 0.05), ("k2", -0.01), ("k3", 0.004), ("k4", -0.001)] {
            frame[key] = value.into();
        }
    }
    let csv = segments(&views(), &lens, |index| format!("images/{index}.jpg"));
    check(parse_transforms(&file.to_string(), "t.json").expect("a model"), &csv, &lens);
    // The field of view in place of the focal length.
    let angle = json!({ "camera_angle_x": 2.0 * (2000.0_f64 / 2900.0).atan(), "w": 4000, "h": 3000 });
    let model = parse_transforms(&transforms(&views(), &angle, 1.0).to_string(), "t.json").expect("a model");
    let found = model.photographs[0].camera.calibration().expect("a calibration").matrix() - calibration().matrix();
    assert!(found.amax() < 1e-9);
}

/// Makes a good file a bad one.
type Change<'a> = &'a dyn Fn(&mut Value);

#[test]
fn bad_transforms_are_refused() {
    let good = transforms(&views(), &json!({ "fl_x": 2900, "w": 4000, "h": 3000 }), 1.0);
    let changed = |change: Change<'_>| {
        let mut file = good.clone();
        change(&mut file);
        parse_transforms(&file.to_string(), "t.json").expect_err("an error").to_string()
    };
    let cases: [(Change<'_>, &str); 7] = [
        (&|file| file["frames"] = json!([]), "t.json: `frames` is empty"),
        (&|file| file["frames"] = Value::Null, "t.json: invalid type: null"),
        (&|file| file["fl_x"] = Value::Null, "t.json: frames[0] (images/0.jpg): no focal length: `fl_x` is needed"),
        (&|file| file["w"] = Value::Null, "t.json: frames[0] (images/0.jpg): no principal point"),
        (&|file| file["k4"] = 0.5.into(), "t.json: frames[0] (images/0.jpg): `k4` is 0.5"),
        (
            &|file| file["frames"][2]["camera_model"] = "FISH".into(),
            "t.json: frames[2] (images/2.jpg): the camera model FISH",
        ),
        (
            &|file| {
                file["frames"][1]["transform_matrix"] = json!([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, -1, 0], [0, 0, 0, 1]])
            },
            "t.json: frames[1] (images/1.jpg): the left 3x3 part",
        ),
    ];
    for (change, expected) in cases {
        let error = changed(change);
        assert!(error.starts_with(expected), "{error}");
    }
    assert!(parse_transforms("{", "t.json").expect_err("an error").to_string().contains("line 1 column 1"));
}

/// A bundle with the cameras, the second of which was not found, and one point.
fn bundle(views: &[View]) -> String {
    let mut text = format!("# Bundle file v0.3\n{} 1\n", views.len() + 1);
    let turn = Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, -1.0));
    for (index, view) in views.iter().enumerate() {
        let (rotation, translation) = (turn * view.camera().rotation(), turn * view.camera().translation());
        text += "2900 -0.1 0.02\n";
        for row in rotation.row_iter() {
            text += &format!("{} {} {}\n", row[0], row[1], row[2]);
        }
        text += &format!("{} {} {}\n", translation.x, translation.y, translation.z);
        if index == 0 {
            text += "0 0 0\n0 0 0\n0 0 0\n0 0 0\n0 0 0\n";
        }
    }
    text + "1 2 3\n10 20 30\n2 0 5 1.5 -2.5 1 7 0 0\n"
}

#[test]
fn bundles_give_the_cameras() {
    let lens = Distortion::polynomial([-0.1, 0.02], [0.0; 2]);
    let names: Vec<_> = (0..9).map(|index| format!("{index}.jpg")).collect();
    // The image `1.jpg` has no camera.
    let csv = segments(&views(), &lens, |index| names[if index == 0 { 0 } else { index + 1 }].clone());
    let text = bundle(&views());
    let sizes: String = names.iter().map(|name| format!("{name} 4000 3000\n")).collect();
    let focals: String = names.iter().map(|name| format!("{name} 0 2900.5\n")).collect();
    for (list, size) in [(sizes.as_str(), None), (focals.as_str(), Some([4000.0, 3000.0]))] {
        let model = parse_bundler(("b.out", &text), ("list.txt", list), size).expect("a model");
        assert_eq!(model.points.len(), 1);
        check(model, &csv, &lens);
    }
    let refused = |text: &str, list: &str| {
        parse_bundler(("b.out", text), ("list.txt", list), None).expect_err("an error").to_string()
    };
    assert!(refused(&text, &focals).starts_with("list.txt:1: the size of `0.jpg` is not known"));
    assert!(refused(&text, "a.jpg\n").starts_with("list.txt: 1 images for 9 cameras"));
    assert!(refused("# Bundle file v0.4\n", &sizes).starts_with("b.out:1: the first line should be"));
    let damaged = text.replacen("2900", "nan", 1);
    assert!(refused(&damaged, &sizes).starts_with("b.out:3: the focal length or distortion should be a finite number"));
    // Cut anywhere before its last field, the file is refused.
    for length in (20..text.trim_end().len() - 1).step_by(7) {
        let error = refused(&text[..length], &sizes);
        assert!(
            error.starts_with("b.out:") || error.starts_with("list.txt:") || error.starts_with("b.out: camera"),
            "{error}"
        );
    }
}

#[test]
fn segments_may_be_separated_otherwise_and_counted_from_centres() {
    let model = || {
        parse_transforms(&transforms(&views(), &json!({ "fl_x": 2900, "w": 4000, "h": 3000 }), 1.0).to_string(), "t")
    };
    let csv = segments(&views(), &Distortion::default(), |index| format!("images/{index}.jpg"));
    let scene = |csv: &str, origin| {
        let segments = parse_segments(csv.as_bytes(), "s.csv").expect("segments").with_pixel_origin(origin);
        Scene::from_colmap(model().expect("a model"), &segments).expect("a scene")
    };
    let expected = scene(&csv, PixelOrigin::Corner);
    for other in [csv.replace(',', ";"), csv.replace(',', "\t"), csv.replacen("image,x1,y1", "IMAGE,X1,Y1", 1)] {
        assert_eq!(scene(&other, PixelOrigin::Corner), expected);
    }
    assert_eq!(scene(&format!("\u{feff}{csv}"), PixelOrigin::Corner), expected);
    let centred = scene(&csv, PixelOrigin::Centre);
    let [from, to] =
        [&expected, &centred].map(|scene| calibration().point_to_pixels(&scene.views[0].ends()[0].expect("ends")[0]));
    assert!((to - from - nalgebra::Vector2::new(0.5, 0.5)).norm() < 1e-9);
}
