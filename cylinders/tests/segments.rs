//! Segments of a CSV file: fitted lines, labels and distortion, and the message for every defect.

#[path = "../examples/make_scene/random.rs"]
mod random;

use std::path::Path;

use eliminant_cylinders::colmap::Model;
use eliminant_cylinders::distortion::Distortion;
use eliminant_cylinders::photograph::Photograph;
use eliminant_cylinders::{Calibration, Camera, Scene, View, parse_scene, parse_segments, read_scene, triangulate};
use nalgebra::{Matrix3, Matrix3x4, Point2, Rotation2, Vector2, Vector3};
use random::Random;

const HEADER: &str = "image,x1,y1,x2,y2,cylinder,line\n";

fn photograph(name: &str, distortion: Distortion) -> Photograph {
    let calibration = Matrix3::new(1000.0, 0.0, 500.0, 0.0, 1100.0, 400.0, 0.0, 0.0, 1.0);
    let camera = Camera::from_normalised(&Matrix3x4::identity()).expect("a camera");
    let camera = camera.with_calibration(Calibration::new(&calibration).expect("a calibration"));
    Photograph { name: name.to_owned(), camera, distortion }
}

fn photographs() -> [Photograph; 2] {
    ["a.jpg", "b c.jpg"].map(|name| photograph(name, Distortion::default()))
}

#[track_caller]
fn views(text: &str) -> Vec<View> {
    parse_segments(text.as_bytes(), "s.csv").and_then(|segments| segments.views(&photographs())).expect("views")
}

/// A line of a view in pixels, its normal of unit length and its last entry not positive.
fn pixel_line(view: &View, index: usize) -> Vector3<f64> {
    let line = view.camera().calibration().expect("a calibration").line_to_pixels(&view.lines()[index]);
    line / line.xy().norm().copysign(-line.z)
}

#[test]
fn segments_become_lines_of_their_images() {
    // The file has columns in another order, an additional column, blanks, quotes, Windows line
    // breaks, and the byte order mark of spreadsheets.
    let text = "\u{feff}score, x1,y1 ,x2,y2,image\r\n0.5,100,-20,100,700,\"b c.jpg\"\r\n,0, 30.5,10 ,30.5,a.jpg\r\n1,0,0,30,40,a.jpg\r\n";
    let views = views(text);
    assert_eq!(views.iter().map(View::image).collect::<Vec<_>>(), [Some("a.jpg"), Some("b c.jpg")]);
    let lines = [(&views[0], 0), (&views[0], 1), (&views[1], 0)].map(|(view, index)| pixel_line(view, index));
    for (line, expected) in lines.iter().zip([[0.0, 1.0, -30.5], [0.8, -0.6, 0.0], [1.0, 0.0, -100.0]]) {
        let expected = Vector3::from(expected);
        assert!((line - expected).norm().min((line + expected).norm()) < 1e-9, "{line} {expected}");
    }
    assert_eq!(views[0].labels(), [None, None]);
}

#[test]
fn pieces_of_one_line_are_fitted_together() {
    let text = format!(
        "{HEADER}a.jpg,0,101,100,99,,left\na.jpg,5,5,6,7,,\nb c.jpg,0,0,1,9,,left\na.jpg,200,99,300,101,,left\n\
         a.jpg,7,7,8,9,,\na.jpg,0,0,0,9,can,left\n"
    );
    let views = views(&text);
    // Segments of the same name in another image or of another cylinder are separate lines, as are
    // segments without name.
    assert_eq!(views.iter().map(|view| view.lines().len()).collect::<Vec<_>>(), [4, 1]);
    assert_eq!(views[0].labels(), [None, None, None, Some("can".to_owned())]);
    // Least squares through (0, 101), (100, 99), (200, 99), (300, 101): y = 100 by symmetry.
    assert!((pixel_line(&views[0], 0) - Vector3::new(0.0, 1.0, -100.0)).norm() < 1e-9);
}

/// The sum of squared distances grows if the fitted line is turned or shifted.
#[test]
fn the_fitted_line_is_the_nearest() {
    let mut random = Random::new(1);
    for _ in 0..200 {
        let angle = random.uniform(0.0, 3.0);
        let mut text = HEADER.to_owned();
        let mut points = Vec::new();
        for piece in 0..4 {
            let ends = [0.0, 60.0].map(|along| {
                let along = along + 80.0 * f64::from(piece);
                let across = random.normal();
                Point2::new(
                    300.0 + along * angle.cos() - across * angle.sin(),
                    200.0 + along * angle.sin() + across * angle.cos(),
                )
            });
            text += &format!("a.jpg,{},{},{},{},,1\n", ends[0].x, ends[0].y, ends[1].x, ends[1].y);
            points.extend(ends);
        }
        let line = pixel_line(&views(&text)[0], 0);
        let cost =
            |line: &Vector3<f64>| points.iter().map(|point| line.dot(&point.to_homogeneous()).powi(2)).sum::<f64>();
        let middle = points.iter().map(|point| point.coords).sum::<Vector2<f64>>() / points.len() as f64;
        for (turn, shift) in [(1e-3, 0.0), (-1e-3, 0.0), (0.0, 0.1), (0.0, -0.1)] {
            let normal = Rotation2::new(turn) * line.xy();
            let other = normal.push(shift - normal.dot(&middle));
            assert!(cost(&other) > cost(&line) + 1e-6, "{turn} {shift}");
        }
    }
}

#[test]
fn wrong_files_are_located() {
    for (text, expected) in [
        ("", "s.csv:1: the header names the column `image` 0 times"),
        ("a.jpg,1,2,3,4\n", "s.csv:1: the header names the column `image` 0 times"),
        ("image,x1,y1,x2\n", "s.csv:1: the header names the column `y2` 0 times"),
        ("image,x1,x1,y1,x2,y2\n", "s.csv:1: the header names the column `x1` 2 times"),
        ("image,x1,y1,x2,y2\n\na.jpg,1,2,3\n", "s.csv:3: 4 columns where the header has 5"),
        (
            "image,x1,y1,x2,y2\na.jpg,1,2,3,4\na.jpg,1,2,3,four\n",
            "s.csv:3: column `y2` should be a finite number of pixels, not `four`",
        ),
        ("image,x1,y1,x2,y2\na.jpg,1,NaN,3,4\n", "s.csv:2: column `y1` should be a finite number of pixels, not `NaN`"),
        ("image,x1,y1,x2,y2\na.jpg,inf,2,3,4\n", "s.csv:2: column `x1` should be a finite number of pixels, not `inf`"),
        ("image,x1,y1,x2,y2\na.jpg,1,2,,4\n", "s.csv:2: column `x2` should be a finite number of pixels, not ``"),
        ("image,x1,y1,x2,y2\n ,1,2,3,4\n", "s.csv:2: column `image` should be the name of an image, not ``"),
        ("image,x1,y1,x2,y2\na.jpg,1,2,1,2\n", "s.csv:2: the segment has no length"),
        (
            "\u{feff}image,x1,y1,x2,y2\r\n\r\na.jpg,1,2,1,3\r\n\r\n\r\na.jpg,1,2,1,2\r\n",
            "s.csv:6: the segment has no length",
        ),
        ("image,x1,y1,x2,y2\n\"a\n.jpg\",1,2,3,4\na.jpg,1,2,1,2\n", "s.csv:4: the segment has no length"),
        ("image,x1,y1,x2,y2\na.jpg,1e-320,0,0,1e-320\n", "s.csv:2: the segment has no length"),
        ("image,x1,y1,x2,y2\na.jpg,1,2,3,4\nd.jpg,1,2,3,4\n", "s.csv:3: there is no image `d.jpg`"),
        (
            "image,x1,y1,x2,y2,line\na.jpg,0,0,0,9,l\na.jpg,0,0,9,0,l\n",
            "s.csv:2: the segments of line `l` do not lie on one line",
        ),
        (
            "image,x1,y1,x2,y2,line\na.jpg,1.7e308,0,1.6e308,0,l\na.jpg,1.7e308,0,-1.7e308,0,l\n",
            "s.csv:2: the segment is out of range",
        ),
    ] {
        let error = parse_segments(text.as_bytes(), "s.csv").and_then(|segments| segments.views(&photographs()));
        let message = error.expect_err("an error").to_string();
        assert!(message.starts_with(expected), "{text}: {message}");
    }
    let error = parse_segments(b"image,x1,y1,x2,y2\n\xff.jpg,1,2,3,4\n", "s.csv").expect_err("an error").to_string();
    assert_eq!(error, "s.csv:2: column 1 is not UTF-8 text");
}

/// A truncated number is still a number, so only truncation elsewhere can be noticed.
#[test]
fn a_file_cut_within_a_row_is_refused() {
    let text = "image,x1,y1,x2,y2\na.jpg,10,20,30,40\nb c.jpg,1,2,3,4\n";
    let (header, last_row) = (text.find('\n').expect("a break"), text.find("b c").expect("the row"));
    for length in 0..text.len() {
        let result = parse_segments(&text.as_bytes()[..length], "s.csv").and_then(|cut| cut.views(&photographs()));
        // The file ends after the header, within the last number of a row, or after that number.
        let complete = (header..=header + 1).contains(&length)
            || (last_row - 2..=last_row).contains(&length)
            || length == text.len() - 1;
        assert_eq!(result.is_ok(), complete, "{length}: {result:?}");
    }
}

#[test]
fn images_must_be_clear() {
    let segments = parse_segments(b"image,x1,y1,x2,y2\na.jpg,1,2,3,4\n", "s.csv").expect("segments");
    let twice = ["a.jpg", "a.jpg"].map(|name| photograph(name, Distortion::default()));
    let error = segments.views(&twice).expect_err("an error").to_string();
    assert_eq!(error, "s.csv:2: several images are named `a.jpg`");

    let camera = Camera::from_normalised(&Matrix3x4::identity()).expect("a camera");
    let uncalibrated = [Photograph { camera, ..photograph("a.jpg", Distortion::default()) }];
    let error = segments.views(&uncalibrated).expect_err("an error").to_string();
    assert_eq!(error, "s.csv:2: the camera of `a.jpg` has no calibration");

    // No point is seen further than two thirds of the focal length from the centre.
    let barrel = [photograph("a.jpg", Distortion::polynomial([-1.0 / 3.0, 0.0], [0.0, 0.0]))];
    let far = parse_segments(b"image,x1,y1,x2,y2\na.jpg,500,400,1400,400\n", "s.csv").expect("segments");
    let error = far.views(&barrel).expect_err("an error").to_string();
    assert!(error.starts_with("s.csv:2: the distortion of `a.jpg` cannot be removed at (1400, 400)"), "{error}");
}

#[test]
fn segments_join_the_lines_of_a_scene() {
    let text = "{\"K\": [[1000,0,500],[0,1000,400],[0,0,1]], \"views\": [\
        {\"camera_normalised\": [[1,0,0,0],[0,1,0,0],[0,0,1,5]], \"lines_pixels\": [[1,0,-3]]},\
        {\"image\": \"a.jpg\", \"camera_normalised\": [[1,0,0,1],[0,1,0,0],[0,0,1,5]], \"lines_pixels\": [[1,0,-3]]}]}";
    let segments = parse_segments(b"image,x1,y1,x2,y2,cylinder\na.jpg,7,0,7,9,can\n", "s.csv").expect("segments");
    let scene = parse_scene(text, "").expect("a scene").with_segments(&segments).expect("images of the scene");
    assert_eq!(scene.views[0].lines().len(), 1);
    assert_eq!(scene.views[1].labels(), [None, Some("can".to_owned())]);
    assert!((pixel_line(&scene.views[1], 1) - Vector3::new(1.0, 0.0, -7.0)).norm() < 1e-12);
}

/// Two points of a pixel line, as a lens with this distortion shows them.
fn seen(line: &Vector3<f64>, calibration: &Calibration, distortion: &Distortion) -> [Point2<f64>; 2] {
    let centre = Point2::new(2000.0, 1500.0);
    let foot = centre - line.xy() * line.dot(&centre.to_homogeneous());
    [-700.0, 900.0].map(|along| {
        let ideal = foot + Vector2::new(-line.y, line.x) * along;
        calibration.point_to_pixels(&distortion.distort(&calibration.point_to_normalised(&ideal)))
    })
}

/// With a distorting lens the same can is found if the distortion is removed, and another one
/// otherwise.
#[test]
fn distortion_is_taken_off() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/soda_can.json");
    let straight = read_scene(&path).expect("a scene").views;
    let expected = triangulate(&straight).expect("a cylinder").cylinder.radius;
    let lens = Distortion::polynomial([-0.15, 0.03], [0.002, -0.001]);
    let mut text = HEADER.to_owned();
    let mut photographs = Vec::new();
    for (index, view) in straight.iter().enumerate() {
        let calibration = view.camera().calibration().expect("a calibration");
        for line in 0..view.lines().len() {
            let [first, second] = seen(&pixel_line(view, line), calibration, &lens);
            text += &format!("{index}.jpg,{},{},{},{},,\n", first.x, first.y, second.x, second.y);
        }
        photographs.push(Photograph { name: format!("{index}.jpg"), camera: *view.camera(), distortion: lens });
    }
    let segments = parse_segments(text.as_bytes(), "").expect("segments");
    let error = |photographs: &[Photograph]| {
        let model = Model { photographs: photographs.to_vec(), points: Vec::new() };
        let scene = Scene::from_colmap(model, &segments).expect("a scene");
        (triangulate(&scene.views).expect("a cylinder").cylinder.radius - expected).abs() / expected
    };
    let with = error(&photographs);
    assert!(with < 1e-9, "radius off by {with:e}");
    photographs.iter_mut().for_each(|photograph| photograph.distortion = Distortion::default());
    let without = error(&photographs);
    assert!(without > 1e-3, "without undistortion the radius is off by {without:e} only");
}
