//! COLMAP models written out by hand, byte for byte as COLMAP documents its formats, independently
//! of the writer of the other tests: <https://colmap.github.io/format.html>, and for the binary
//! files the order and the widths in which its own reader takes them.

use eliminant_cylinders::ColmapError;
use eliminant_cylinders::colmap::{Encoding, Model, parse_colmap};
use eliminant_cylinders::distortion::Distortion;
use nalgebra::{Matrix3, Point3, Vector3};

/// One camera of each supported model. Numbers are little-endian: 2560 is 0x40a4000000000000 as a
/// double.
const CAMERAS: &str = "
    0500000000000000                                         // five cameras
    01000000 00000000 000c000000000000 0009000000000000      // 1, SIMPLE_PINHOLE, 3072 x 2304
    000000000000a440 0000000000009840 0000000000009240       // f 2560, c (1536, 1152)
    02000000 01000000 000c000000000000 0009000000000000      // 2, PINHOLE
    000000000000a440 000000000002a440                        // f 2560, 2561
    0000000000009840 0000000000009240
    03000000 02000000 000c000000000000 0009000000000000      // 3, SIMPLE_RADIAL
    000000000000a440 0000000000009840 0000000000009240
    000000000000c0bf                                         // k -0.125
    04000000 03000000 000c000000000000 0009000000000000      // 4, RADIAL
    000000000000a440 0000000000009840 0000000000009240
    000000000000c0bf 000000000000a03f                        // k -0.125, 0.03125
    2a000000 04000000 000c000000000000 0009000000000000      // 42, OPENCV
    000000000000a440 000000000002a440
    0000000000009840 0000000000009240
    000000000000c0bf 000000000000a03f                        // k -0.125, 0.03125
    000000000000503f 00000000000060bf                        // p 2^-10, -2^-9
";

/// The poses are world to camera: quaternion w x y z, translation.
const IMAGES: &str = "
    0500000000000000                                         // five images
    07000000                                                 // 7
    000000000000e03f 000000000000e03f                        // rotation (1 + i + j + k) / 2: x to y to z to x
    000000000000e03f 000000000000e03f
    000000000000f03f 00000000000000c0 0000000000001440       // translation (1, -2, 5)
    01000000 612e6a706700                                    // camera 1, `a.jpg`
    0200000000000000                                         // two points
    0000000000804440 0000000000003940 7ee4000000000000       // (41, 25), point 58494
    0000000000804440 0000000000003940 ffffffffffffffff       // (41, 25), none
    02000000
    000000000000f03f 0000000000000000 0000000000000000 0000000000000000
    0000000000000000 0000000000000000 0000000000001440
    02000000 7375622f622e6a706700                            // camera 2, `sub/b.jpg`
    0000000000000000
    03000000
    000000000000f03f 0000000000000000 0000000000000000 0000000000000000
    0000000000000000 0000000000000000 0000000000001440
    03000000 632e6a706700                                    // camera 3, `c.jpg`
    0000000000000000
    04000000
    000000000000f03f 0000000000000000 0000000000000000 0000000000000000
    0000000000000000 0000000000000000 0000000000001440
    04000000 642e6a706700                                    // camera 4, `d.jpg`
    0000000000000000
    05000000
    000000000000f03f 0000000000000000 0000000000000000 0000000000000000
    0000000000000000 0000000000000000 0000000000001440
    2a000000 652e6a706700                                    // camera 42, `e.jpg`
    0000000000000000
";

const POINTS: &str = "
    0200000000000000                                         // two points
    7ee4000000000000                                         // 58494
    000000000000f83f 00000000000000c0 000000000000d03f       // (1.5, -2, 0.25)
    73797a 000000000000f43f                                  // colour, error 1.25
    0200000000000000                                         // track of two
    07000000 00000000 02000000 96000000                      // image 7, its first point; image 2
    0100000000000000
    0000000000000000 000000000000f03f 0000000000000840       // (0, 1, 3)
    000000 0000000000000000
    0000000000000000
";

/// The same model as text, with the comments that COLMAP writes. An image without points has an
/// empty line.
const TEXT: [&str; 3] = [
    "# Camera list with one line of data per camera:
#   CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]
# Number of cameras: 5
1 SIMPLE_PINHOLE 3072 2304 2560 1536 1152
2 PINHOLE 3072 2304 2560 2561 1536 1152
3 SIMPLE_RADIAL 3072 2304 2560 1536 1152 -0.125
4 RADIAL 3072 2304 2560 1536 1152 -0.125 0.03125
42 OPENCV 3072 2304 2560 2561 1536 1152 -0.125 0.03125 0.0009765625 -0.001953125
",
    "# Image list with two lines of data per image:
#   IMAGE_ID, QW, QX, QY, QZ, TX, TY, TZ, CAMERA_ID, NAME
#   POINTS2D[] as (X, Y, POINT3D_ID)
# Number of images: 5, mean observations per image: 0.40000000000000002
7 0.5 0.5 0.5 0.5 1 -2 5 1 a.jpg
41 25 58494 41 25 -1
2 1 0 0 0 0 0 5 2 sub/b.jpg

3 1 0 0 0 0 0 5 3 c.jpg

4 1 0 0 0 0 0 5 4 d.jpg

5 1 0 0 0 0 0 5 42 e.jpg

",
    "# 3D point list with one line of data per point:
#   POINT3D_ID, X, Y, Z, R, G, B, ERROR, TRACK[] as (IMAGE_ID, POINT2D_IDX)
# Number of points: 2, mean track length: 1
58494 1.5 -2 0.25 115 121 122 1.25 7 0 2 150
1 0 1 3 0 0 0 0
",
];

/// Bytes from hexadecimal digits; text after `//` is a comment.
fn bytes(text: &str) -> Vec<u8> {
    let lines = text.lines().map(|line| line.split("//").next().unwrap_or(line));
    let digits: Vec<_> = lines.flat_map(str::chars).filter(|character| !character.is_whitespace()).collect();
    let byte = |pair: &[char]| u8::from_str_radix(&pair.iter().collect::<String>(), 16).expect("two digits");
    digits.chunks(2).map(byte).collect()
}

fn binary() -> [(&'static str, Vec<u8>); 3] {
    [("cameras.bin", bytes(CAMERAS)), ("images.bin", bytes(IMAGES)), ("points3D.bin", bytes(POINTS))]
}

fn text() -> [(&'static str, Vec<u8>); 3] {
    let [cameras, images, points] = TEXT.map(|text| text.as_bytes().to_vec());
    [("cameras.txt", cameras), ("images.txt", images), ("points3D.txt", points)]
}

fn parse(encoding: Encoding, files: &[(&'static str, Vec<u8>); 3]) -> Result<Model, ColmapError> {
    parse_colmap(encoding, files.each_ref().map(|(name, content)| (*name, content.as_slice())))
}

fn check(model: &Model) {
    let names: Vec<_> = model.photographs.iter().map(|photograph| photograph.name.as_str()).collect();
    assert_eq!(names, ["a.jpg", "sub/b.jpg", "c.jpg", "d.jpg", "e.jpg"]);
    assert_eq!(model.points, [Point3::new(1.5, -2.0, 0.25), Point3::new(0.0, 1.0, 3.0)]);
    let (none, radial) = ([0.0, 0.0], [-0.125, 0.03125]);
    for (photograph, (focal, radial, tangential)) in model.photographs.iter().zip([
        (2560.0, none, none),
        (2561.0, none, none),
        (2560.0, [-0.125, 0.0], none),
        (2560.0, radial, none),
        (2561.0, radial, [1.0 / 1024.0, -1.0 / 512.0]),
    ]) {
        let calibration = photograph.camera.calibration().map(|calibration| *calibration.matrix());
        let expected = Matrix3::new(2560.0, 0.0, 1536.0, 0.0, focal, 1152.0, 0.0, 0.0, 1.0);
        assert_eq!(calibration, Some(expected), "{}", photograph.name);
        assert_eq!(photograph.distortion, Distortion::polynomial(radial, tangential), "{}", photograph.name);
    }
    // The first axis of the world is the second of the camera, and so on; the centre is -R^T t.
    let camera = &model.photographs[0].camera;
    let cyclic = Matrix3::new(0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0);
    assert!((camera.rotation() - cyclic).amax() < 1e-15);
    assert!((camera.translation() - Vector3::new(1.0, -2.0, 5.0)).amax() < 1e-15);
    assert!((camera.centre() - Point3::new(2.0, -5.0, -1.0)).amax() < 1e-15);
    assert_eq!(model.photographs[4].camera.rotation(), &Matrix3::identity());
}

#[test]
fn models_as_documented_are_read() {
    check(&parse(Encoding::Text, &text()).expect("a model"));
    check(&parse(Encoding::Binary, &binary()).expect("a model"));
}

#[test]
fn cut_at_any_byte_they_are_refused() {
    for (encoding, files) in [(Encoding::Text, text()), (Encoding::Binary, binary())] {
        for index in 0..3 {
            // An empty text file is a file without points, written by hand.
            let least = usize::from(encoding == Encoding::Text);
            for length in least..files[index].1.len() {
                let mut cut = files.clone();
                cut[index].1.truncate(length);
                let error = parse(encoding, &cut).expect_err("an error").to_string();
                assert!(files.iter().any(|(name, _)| error.starts_with(name)), "{error}");
            }
        }
    }
}

/// A model without meaning in a plane, and an unknown number.
#[test]
fn models_that_are_not_supported_are_refused_by_name() {
    for (number, name) in [(17u8, "EQUIRECTANGULAR"), (99, "number 99")] {
        let mut files = binary();
        files[0].1[12] = number;
        let error = parse(Encoding::Binary, &files).expect_err("an error");
        assert!(matches!(&error, ColmapError::UnsupportedModel { camera: 1, model, .. } if model == name), "{error}");
    }
}
