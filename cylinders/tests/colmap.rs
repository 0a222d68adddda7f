//! COLMAP models: text and binary files give the same model, and every defect of a file gives an
//! error.

mod model;

use std::fs;

use eliminant_cylinders::colmap::{Encoding, Location, Model, parse_colmap};
use eliminant_cylinders::distortion::Distortion;
use eliminant_cylinders::{ColmapError, ViewError, read_colmap};
use model::{Files, TestImage, TestModel, folder};
use nalgebra::{Matrix3, Point2, Point3, Rotation3, Vector2, Vector3};
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::{Rng, SeedableRng};

/// A model with every camera model, an image without points, a name with a blank, and a point
/// without track.
fn test_model() -> TestModel {
    let image = |id, camera, name: &str, observations: &[(f64, f64, i64)]| TestImage {
        id,
        // 90 degrees about z, times two.
        quaternion: [2f64.sqrt(), 0.0, 0.0, 2f64.sqrt()],
        translation: [1.5, -2.25, 5.0 + f64::from(id)],
        camera,
        name: name.to_owned(),
        observations: observations.to_vec(),
    };
    TestModel {
        cameras: vec![
            (1, "SIMPLE_PINHOLE", 0, vec![3000.0, 2000.0, 1500.0]),
            (2, "PINHOLE", 1, vec![3000.0, 3010.0, 2000.0, 1500.0]),
            (30, "SIMPLE_RADIAL", 2, vec![3000.0, 2000.0, 1500.0, -0.1]),
            (4, "RADIAL", 3, vec![3000.0, 2000.0, 1500.0, -0.1, 0.02]),
            (5, "OPENCV", 4, vec![3000.0, 3010.0, 2000.0, 1500.0, -0.1, 0.02, 0.001, -0.002]),
        ],
        images: vec![
            image(7, 30, "left side.jpg", &[(10.5, 20.25, 3), (11.0, 12.0, -1)]),
            image(2, 1, "b.jpg", &[]),
            image(3, 5, "sub/c.jpg", &[(1.0, 2.0, 3)]),
            image(4, 2, "d.jpg", &[]),
            image(5, 4, "e.jpg", &[]),
        ],
        points: vec![(3, [1.0, 2.0, 3.5], vec![(7, 0), (3, 0)]), (9, [-1.0, 0.0, 1e-3], vec![])],
    }
}

fn parse(files: &Files) -> Result<Model, ColmapError> {
    let encoding = if files[0].0.ends_with(".bin") { Encoding::Binary } else { Encoding::Text };
    parse_colmap(encoding, files.each_ref().map(|(name, content)| (*name, content.as_slice())))
}

/// The same files, with the content of one replaced.
fn with(files: &Files, index: usize, content: Vec<u8>) -> Files {
    let mut files = files.clone();
    files[index].1 = content;
    files
}

#[test]
fn text_and_binary_give_the_same_model() {
    let text = read_colmap(&folder("colmap_text", &test_model().text())).expect("a model");
    let binary = read_colmap(&folder("colmap_binary", &test_model().binary())).expect("a model");
    assert_eq!(text, binary);

    let names: Vec<_> = text.photographs.iter().map(|photograph| photograph.name.as_str()).collect();
    assert_eq!(names, ["left side.jpg", "b.jpg", "sub/c.jpg", "d.jpg", "e.jpg"]);
    assert_eq!(text.points, [Point3::new(1.0, 2.0, 3.5), Point3::new(-1.0, 0.0, 1e-3)]);
    let quarter = Rotation3::from_axis_angle(&Vector3::z_axis(), std::f64::consts::FRAC_PI_2);
    for (photograph, (focal, distortion)) in text.photographs.iter().zip([
        (3000.0, Distortion::polynomial([-0.1, 0.0], [0.0, 0.0])),
        (3000.0, Distortion::default()),
        (3010.0, Distortion::polynomial([-0.1, 0.02], [0.001, -0.002])),
        (3010.0, Distortion::default()),
        (3000.0, Distortion::polynomial([-0.1, 0.02], [0.0, 0.0])),
    ]) {
        let camera = &photograph.camera;
        assert!((camera.rotation() - quarter.matrix()).amax() < 1e-15);
        assert!((camera.translation().xy() - Vector2::new(1.5, -2.25)).amax() < 1e-14);
        let expected = Matrix3::new(3000.0, 0.0, 2000.0, 0.0, focal, 1500.0, 0.0, 0.0, 1.0);
        assert_eq!(
            camera.calibration().map(|calibration| *calibration.matrix()),
            Some(expected),
            "{}",
            photograph.name
        );
        assert_eq!(photograph.distortion, distortion, "{}", photograph.name);
    }
    assert!((text.photographs[0].camera.translation().z - 12.0).abs() < 1e-14);
}

/// The distortion, by the formulas of the model, of the ideal pixel (2600, 1200).
#[test]
fn photographs_take_their_distortion_off() {
    let model = parse(&test_model().binary()).expect("a model");
    let photograph = &model.photographs[2];
    let (u, v) = (600.0 / 3000.0, -300.0 / 3010.0);
    let s: f64 = u * u + v * v;
    let radial = 1.0 - 0.1 * s + 0.02 * s * s;
    let (p1, p2) = (0.001, -0.002);
    let seen = Point2::new(
        3000.0 * (u * radial + 2.0 * p1 * u * v + p2 * (s + 2.0 * u * u)) + 2000.0,
        3010.0 * (v * radial + p1 * (s + 2.0 * v * v) + 2.0 * p2 * u * v) + 1500.0,
    );
    let found = photograph.undistort(&seen).expect("inside the image");
    assert!((seen - Point2::new(2600.0, 1200.0)).norm() > 1.0);
    assert!((found - Point2::new(2600.0, 1200.0)).norm() < 1e-9, "{found}");
    assert_eq!(model.photographs[1].undistort(&seen), Some(seen), "a camera without distortion");
}

#[test]
fn where_there_are_both_the_binary_files_are_read() {
    let folder = folder("colmap_both", &test_model().text());
    let mut other = test_model();
    other.points.clear();
    for (name, content) in other.binary() {
        fs::write(folder.join(name), content).expect("written");
    }
    assert_eq!(read_colmap(&folder).expect("a model").points, []);
}

#[test]
fn a_model_without_points_is_read() {
    for (name, files) in [("points3D.txt", test_model().text()), ("points3D.bin", test_model().binary())] {
        let folder = folder("colmap_no_points", &files);
        fs::remove_file(folder.join(name)).expect("removed");
        let model = read_colmap(&folder).expect("a model");
        assert_eq!((model.photographs.len(), model.points.len()), (5, 0));
    }
}

#[test]
fn a_file_that_is_missing_is_named() {
    for name in ["cameras.txt", "images.txt"] {
        let folder = folder("colmap_missing", &test_model().text());
        fs::remove_file(folder.join(name)).expect("removed");
        let error = read_colmap(&folder).expect_err("an error");
        assert!(matches!(&error, ColmapError::Read { file, .. } if file.ends_with(name)), "{error}");
    }
}

/// The names and lengths of all truncated files with which the model is accepted. Checks that
/// messages name a file.
fn cut_at_every_byte(files: &Files) -> Vec<(&'static str, usize)> {
    let mut accepted = Vec::new();
    for (index, (name, content)) in files.iter().enumerate() {
        for length in 0..content.len() {
            match parse(&with(files, index, content[..length].to_vec())) {
                Ok(_) => accepted.push((*name, length)),
                Err(error) => assert!(files.iter().any(|(name, _)| error.to_string().starts_with(name)), "{error}"),
            }
        }
    }
    accepted
}

#[test]
fn a_binary_file_cut_at_any_byte_is_refused() {
    assert_eq!(cut_at_every_byte(&test_model().binary()), []);
}

#[test]
fn a_text_file_cut_at_any_byte_is_refused() {
    // A model written by hand may have an empty file of points.
    let accepted = cut_at_every_byte(&test_model().text());
    assert_eq!(accepted, [("points3D.txt", 0)]);
}

#[test]
fn cut_files_tell_where() {
    let binary = test_model().binary();
    let cut = |index: usize, length: usize| {
        parse(&with(&binary, index, binary[index].1[..length].to_vec())).expect_err("an error").to_string()
    };
    assert!(cut(0, 5).ends_with("cameras.bin: byte 5: the file is cut short: it ends in the count of cameras"));
    let length = binary[0].1.len();
    let message = cut(0, length - 1);
    let expected = format!("byte {}: the file is cut short: it ends in record 5 of its cameras", length - 1);
    assert!(message.ends_with(&expected), "{message}");
    let text = test_model().text();
    let images = String::from_utf8(text[1].1.clone()).expect("UTF-8");
    let lines: Vec<_> = images.split_inclusive('\n').collect();
    let short = with(&text, 1, lines[..5].concat().into_bytes());
    let message = parse(&short).expect_err("an error").to_string();
    assert!(
        message.ends_with("images.txt:5: the file is cut short: it ends in image 2, before the line of its points")
    );
    let short = with(&text, 1, lines[..6].concat().into_bytes());
    let message = parse(&short).expect_err("an error").to_string();
    let expected = "images.txt:2: 5 images are announced, but there are 2: the file is cut short or damaged";
    assert!(message.ends_with(expected), "{message}");
}

#[test]
fn counts_that_the_file_cannot_hold_are_refused() {
    let binary = test_model().binary();
    // The count of observations of the first image stands after the count of images, its pose and
    // its name.
    let observations = 8 + 4 + 56 + 4 + "left side.jpg".len() + 1;
    let track = 8 + 8 + 24 + 3 + 8;
    for (index, at) in [(0, 0), (1, 0), (1, observations), (2, 0), (2, track)] {
        let count = u64::from_le_bytes(binary[index].1[at..at + 8].try_into().expect("eight bytes"));
        assert!((1..10).contains(&count), "a count at byte {at} of {}", binary[index].0);
        for wrong in [count - 1, count + 1, 1 << 20, 1 << 60, u64::MAX / 24, u64::MAX] {
            let mut content = binary[index].1.clone();
            content[at..at + 8].copy_from_slice(&wrong.to_le_bytes());
            let error = parse(&with(&binary, index, content)).expect_err("an error");
            assert!(error.to_string().contains(&format!("{}: byte ", binary[index].0)), "{error}");
            if wrong >= 1 << 20 {
                let ColmapError::Count { at: Location::Byte { byte, .. }, count, .. } = error else {
                    panic!("{error}");
                };
                assert_eq!((byte, count), (at, wrong));
            }
        }
    }
    let mut longer = binary[2].1.clone();
    longer.push(0);
    let error = parse(&with(&binary, 2, longer)).expect_err("an error");
    assert!(matches!(error, ColmapError::Trailing { records: "points", .. }), "{error}");
}

/// Bytes changed at random give a model or an error, never a panic or a huge allocation.
#[test]
fn damaged_files_do_no_harm() {
    let mut random = Xoshiro256PlusPlus::seed_from_u64(1);
    for (kind, files) in [("text", test_model().text()), ("binary", test_model().binary())] {
        let mut refused = 0;
        for run in 0..3000 {
            let mut damaged = files[run % 3].1.clone();
            for _ in 0..1 + random.next_u64() % 3 {
                let at = random.next_u64() as usize % damaged.len();
                damaged[at] = random.next_u64() as u8;
            }
            refused += usize::from(parse(&with(&files, run % 3, damaged)).is_err());
        }
        println!("{kind}: {refused} of 3000 refused");
        assert!(refused > 0);
    }
}

/// Single defects of a good model, in text and in binary files.
fn refused(change: impl Fn(&mut TestModel)) -> [ColmapError; 2] {
    let mut model = test_model();
    change(&mut model);
    [model.text(), model.binary()].map(|files| parse(&files).expect_err("an error"))
}

#[test]
fn unsupported_camera_models_are_named() {
    for error in refused(|model| model.cameras[3] = (4, "EQUIRECTANGULAR", 17, vec![1.0; 2])) {
        let ColmapError::UnsupportedModel { camera: 4, model, .. } = &error else {
            panic!("{error}");
        };
        assert_eq!(model, "EQUIRECTANGULAR");
    }
    let [text, binary] = refused(|model| model.cameras[0] = (1, "PANORAMA", 99, vec![]));
    assert!(text.to_string().contains("cameras.txt:3: camera 1 has the model PANORAMA; "), "{text}");
    assert!(binary.to_string().contains("cameras.bin: byte 8: camera 1 has the model number 99;"), "{binary}");
}

#[test]
fn values_that_make_no_camera_are_refused() {
    for error in refused(|model| model.cameras[1].3[2] = f64::NAN) {
        assert!(error.to_string().ends_with("camera 2 has a parameter that is not a finite number"), "{error}");
    }
    for error in refused(|model| model.cameras[0].3[0] = 0.0) {
        assert!(matches!(error, ColmapError::Invalid { source: ViewError::NotACalibration, .. }), "{error}");
    }
    for quaternion in [[0.0; 4], [f64::NAN, 0.0, 0.0, 1.0], [f64::INFINITY, 0.0, 0.0, 1.0]] {
        for error in refused(|model| model.images[3].quaternion = quaternion) {
            assert!(error.to_string().ends_with("image `d.jpg` has a rotation that is zero or not finite"), "{error}");
        }
    }
    for error in refused(|model| model.images[0].translation[1] = f64::INFINITY) {
        assert!(matches!(error, ColmapError::Invalid { source: ViewError::CameraNotFinite, .. }), "{error}");
    }
    for error in refused(|model| model.points[1].1[0] = f64::NAN) {
        assert!(error.to_string().ends_with("point 9 has a coordinate that is not a finite number"), "{error}");
    }
    for error in refused(|model| model.images[1].camera = 17) {
        assert!(matches!(error, ColmapError::UnknownCamera { camera: 17, .. }), "{error}");
        assert!(error.to_string().contains("image `b.jpg` has camera 17, which is not in the model"), "{error}");
    }
    for error in refused(|model| model.cameras[2].0 = 1) {
        assert!(error.to_string().ends_with("camera 1 occurs twice"), "{error}");
    }
    for error in refused(|model| model.images[1].id = 7) {
        assert!(error.to_string().ends_with("image 7 occurs twice"), "{error}");
    }
    for error in refused(|model| model.images[2].name = "b.jpg".to_owned()) {
        assert!(error.to_string().ends_with("image named `b.jpg` occurs twice"), "{error}");
    }
    for error in refused(|model| model.images.clear()) {
        assert!(matches!(error, ColmapError::NoImages { .. }), "{error}");
    }
}

#[test]
fn names_are_utf_8() {
    for (files, place) in [(test_model().text(), "images.txt:5: "), (test_model().binary(), "images.bin: byte ")] {
        let at = files[1].1.windows(5).position(|bytes| bytes == b"b.jpg").expect("the name");
        let mut content = files[1].1.clone();
        content[at] = 0xff;
        let error = parse(&with(&files, 1, content)).expect_err("an error");
        assert!(matches!(error, ColmapError::NotUtf8 { .. }) && error.to_string().contains(place), "{error}");
    }
}

#[test]
fn text_by_hand_is_read_and_its_mistakes_are_located() {
    let files = |cameras: &str, images: &str, points: &str| -> Files {
        [("cameras.txt", cameras), ("images.txt", images), ("points3D.txt", points)]
            .map(|(name, text)| (name, text.as_bytes().to_vec()))
    };
    // No comments, Windows line breaks, no break at the end, no points.
    let camera = "1 PINHOLE 640 480 500 500 320 240";
    let good = files(camera, "\r\n1 1 0 0 0 0 0 5 1 a.jpg\r\n\r\n", "");
    let model = parse(&good).expect("a model");
    assert_eq!((model.photographs.len(), model.points.len()), (1, 0));

    let image = "1 1 0 0 0 0 0 5 1 a.jpg\n\n";
    for (cameras, images, points, expected) in [
        (
            "1 PINHOLE 640 480 500 500 320",
            image,
            "",
            "cameras.txt:1: camera 1 has 3 parameters; its model PINHOLE has 4",
        ),
        (
            "1 PINHOLE 640 480 500 f 320 240",
            image,
            "",
            "cameras.txt:1: a parameter of the camera should be a number, not `f`",
        ),
        ("1 PINHOLE 640", image, "", "cameras.txt:1: the height should be a number of pixels, not ``"),
        ("-1 PINHOLE", image, "", "cameras.txt:1: the id of the camera should be a number, not `-1`"),
        (
            camera,
            "1 1 0 0 0 0 0 5 1\n\n",
            "",
            "images.txt:1: the file is cut short: it ends in image 1, before its name",
        ),
        (camera, "1 1 0 0 0 0 zero 5 1 a.jpg\n\n", "", "images.txt:1: TY should be a number, not `zero`"),
        (
            camera,
            "1 1 0 0 0 0 0 5 1 a.jpg\n2 1 0 0 0 0 0 5 1 b.jpg\n",
            "",
            "images.txt:2: 10 fields; the points of an image have three each, in a line of their own that may be empty",
        ),
        (camera, "", "", "images.txt: there are no images"),
        (
            camera,
            "# Number of images: many\n",
            "",
            "images.txt:1: the number of records should be a number, not `many`",
        ),
        (camera, "# Image list\n", "", "images.txt:1: the file is cut short: it ends in the comments at its start"),
        (
            camera,
            image,
            "1 0 0 0 1 2 3\n",
            "points3D.txt:1: 7 fields; a point has eight, and two more for each image that shows it",
        ),
        (camera, image, "1 0 0 z 1 2 3 0\n", "points3D.txt:1: Z should be a number, not `z`"),
        (
            camera,
            image,
            "# Number of points: 2, mean track length: 0\n1 0 0 0 1 2 3 0\n",
            "points3D.txt:1: 2 points are announced, but there are 1: the file is cut short or damaged",
        ),
    ] {
        let error = parse(&files(cameras, images, points)).expect_err("an error").to_string();
        assert!(error.ends_with(expected), "{error}");
    }
}
