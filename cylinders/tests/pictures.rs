//! Pictures have the same bytes each time, well-formed SVG, PNG of the declared size, and the right
//! content.

#![cfg(feature = "command")]

use std::path::Path;

use eliminant_cylinders::picture::{
    Axis, Band, Format, Histogram, Picture, Plot, SectionPicture, Series, SilhouettePicture,
};
use eliminant_cylinders::{Circle, Cylinder, CylinderLines, Scene, View, read_scene, triangulate};
use nalgebra::Point2;

/// The colours of results and of given lines.
const FOUND: [u8; 3] = [0, 114, 178];
const GIVEN: [u8; 3] = [213, 94, 0];

fn soda_can() -> (Scene, Vec<(CylinderLines, Cylinder)>) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/soda_can.json");
    let scene = read_scene(&path).expect("a scene");
    let lines = scene.cylinders().remove(0);
    let cylinder = triangulate(&lines.views).expect("a cylinder").cylinder;
    (scene, vec![(lines, cylinder)])
}

fn section() -> SectionPicture {
    let (_, found) = soda_can();
    SectionPicture::new("a < b & \"c\"".to_owned(), &found[0].1, &found[0].0.views)
}

fn plot() -> Plot {
    let point = |index: i32| f64::from(index) / 10.0;
    let series = |label: &str, factor: f64| Series {
        label: label.to_owned(),
        points: (0..=20).map(|index| [point(index), factor * point(index)]).collect(),
        band: Some(Band {
            label: format!("{label}, quartiles"),
            limits: (0..=20)
                .map(|index| [point(index), factor * point(index) * 0.5, factor * point(index) * 2.0])
                .collect(),
        }),
    };
    let (x, y) = (Axis::linear("σ < 2"), Axis::linear("error & more"));
    Plot { title: "Noise".to_owned(), x, y, series: vec![series("three lines", 1.0), series("six lines", 0.4)] }
}

fn histogram() -> Histogram {
    let sample = |factor: f64| (0..1000).map(|index| (factor * f64::from(index)).sin()).collect();
    let samples = vec![("a".to_owned(), sample(0.1)), ("b".to_owned(), vec![f64::NAN, 0.25, f64::INFINITY])];
    Histogram { title: "Sines".to_owned(), label: "sine".to_owned(), samples, bins: 20 }
}

fn svg(picture: &impl Picture) -> String {
    String::from_utf8(Format::Svg.render(picture).expect("a picture")).expect("UTF-8")
}

/// Width and rows of pixels.
fn png(picture: &impl Picture) -> (usize, Vec<[u8; 3]>) {
    let bytes = Format::Png.render(picture).expect("a picture");
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().expect("a PNG file");
    let mut pixels = vec![0; reader.output_buffer_size().expect("it fits into memory")];
    let info = reader.next_frame(&mut pixels).expect("an image");
    assert_eq!((info.color_type, info.bit_depth), (png::ColorType::Rgb, png::BitDepth::Eight));
    let (width, height) = picture.size();
    assert_eq!((info.width, info.height), (2 * width, 2 * height), "two pixels to the unit");
    (info.width as usize, pixels.chunks_exact(3).map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect())
}

/// All text of an SVG file.
fn texts(svg: &str) -> Vec<String> {
    let document = roxmltree::Document::parse(svg).expect("well-formed XML");
    document.descendants().filter_map(|node| node.text()).map(|text| text.trim().to_owned()).collect()
}

fn check(picture: &impl Picture, expected: &[&str]) {
    let text = svg(picture);
    assert_eq!(text, svg(picture), "the same bytes each time");
    let document = roxmltree::Document::parse(&text).expect("well-formed XML");
    let (width, height) = picture.size();
    let root = document.root_element();
    assert_eq!(root.attribute("width"), Some(width.to_string().as_str()));
    assert_eq!(root.attribute("viewBox"), Some(format!("0 0 {} {}", 4 * width, 4 * height).as_str()));
    let texts = texts(&text);
    for expected in expected {
        assert!(texts.iter().any(|text| text == expected), "`{expected}` in {texts:?}");
    }

    assert_eq!(Format::Png.render(picture).expect("a picture"), Format::Png.render(picture).expect("a picture"));
    let (_, pixels) = png(picture);
    for colour in [FOUND, [255; 3]] {
        assert!(pixels.contains(&colour), "{colour:?}");
    }
}

#[test]
fn every_picture_is_a_good_file_in_both_formats() {
    let (scene, found) = soda_can();
    check(&section(), &["a < b & \"c\"", "cylinder", "camera", "x / world units", "-400"]);
    let silhouettes = SilhouettePicture::new(&scene, &found, 3).expect("a view");
    check(&silhouettes, &["view 3", "line given", "silhouettes, axis", "y / pixels", "3000"]);
    assert!(SilhouettePicture::new(&scene, &found, scene.views.len()).is_none());
    check(&plot(), &["Noise", "σ < 2", "error & more", "three lines", "six lines, quartiles", "2.0"]);
    check(&histogram(), &["Sines", "sine", "a", "b (2 not finite)", "part of the sample"]);
}

#[test]
fn the_extension_says_the_format() {
    for (name, format) in [("a.svg", Format::Svg), ("b/c.PNG", Format::Png)] {
        assert_eq!(Format::of(Path::new(name)).expect("known"), format);
    }
    for name in ["a", "a.jpg", "svg", ".png", "a.svg/b"] {
        assert!(Format::of(Path::new(name)).is_err(), "{name}");
    }
}

#[test]
fn circles_are_round_and_lines_touch_them() {
    let (width, pixels) = png(&section());
    // The right one of the two squares has 560 units, without the legend.
    let blue = |&index: &usize| pixels[index] == FOUND && (1120..2240).contains(&(index % width));
    let blue: Vec<_> = (0..pixels.len()).filter(blue).map(|index| (index % width, index / width)).collect();
    let extent = |values: &mut dyn Iterator<Item = usize>| {
        let values: Vec<_> = values.collect();
        values.iter().max().expect("a circle") - values.iter().min().expect("a circle")
    };
    let (wide, high) = (extent(&mut blue.iter().map(|at| at.0)), extent(&mut blue.iter().map(|at| at.1)));
    assert!(wide > 400 && wide.abs_diff(high) <= 2, "{wide} x {high}");

    // The picture shows all sixteen lines of the scene, which pass within 1.5 units of the circle.
    let lines: Vec<_> = section().lines().collect();
    assert_eq!(lines.len(), 16);
    let (_, found) = soda_can();
    for line in lines {
        let distance = line.distance(&Point2::origin()).abs() - found[0].1.radius;
        assert!(distance.abs() < 0.01 * found[0].1.radius, "{distance}");
    }

    // Other circles are also drawn, even distant ones that are only partly in the picture.
    let other = |radius| Circle { centre: Point2::new(radius, 0.0), radius };
    let more = section().with_others(vec![other(50.0), other(1e5), other(1e12)]);
    check(&more, &["other stationary circle"]);
    assert!(svg(&more).matches("polyline").count() > svg(&section()).matches("polyline").count() + 3);
}

/// The ends of the lines of a colour, in the order in which they are drawn.
fn lines(svg: &str, colour: [u8; 3]) -> Vec<String> {
    let [red, green, blue] = colour;
    let stroke = format!("#{red:02X}{green:02X}{blue:02X}");
    let document = roxmltree::Document::parse(svg).expect("well-formed XML");
    let line =
        |node: &roxmltree::Node| node.tag_name().name() == "polyline" && node.attribute("stroke") == Some(&stroke);
    let ends = |node: roxmltree::Node| node.attribute("points").map(str::to_owned);
    document.descendants().filter(line).filter_map(ends).collect()
}

#[test]
fn silhouettes_lie_on_exact_lines() {
    let (mut scene, mut found) = soda_can();
    let (mut lines_of_cylinder, cylinder) = found.remove(0);
    for view in &mut scene.views {
        let exact = cylinder.silhouette(view.camera()).expect("outside");
        *view = View::from_normalised_lines(*view.camera(), &exact).expect("lines").with_image("a & b.jpg".to_owned());
    }
    lines_of_cylinder.views.clone_from(&scene.views);
    let picture = SilhouettePicture::new(&scene, &[(lines_of_cylinder, cylinder)], 0).expect("a view");
    let svg = svg(&picture);
    assert!(texts(&svg).iter().any(|text| text == "a & b.jpg"));
    // Legend entry, two silhouettes and the axis; legend entry and two lines.
    let (found, given) = (lines(&svg, FOUND), lines(&svg, GIVEN));
    assert_eq!((found.len(), given.len()), (4, 3));
    assert_eq!(found[1..3], given[1..]);
}

#[test]
fn lines_with_end_points_are_drawn_as_segments() {
    let (mut scene, found) = soda_can();
    let view = &scene.views[0];
    let calibration = *view.camera().calibration().expect("a calibration");
    // One line is inside the image, and one leaves it.
    let points = [[[1000.0, 500.0], [1000.0, 1000.0]], [[2000.0, 500.0], [2000.0, 9000.0]]];
    let segments = points.map(|ends| ends.map(Point2::from));
    scene.views[0] = View::from_pixel_segments(*view.camera(), &segments).expect("segments");
    let given = |scene: &Scene| {
        let svg = svg(&SilhouettePicture::new(scene, &found, 0).expect("a view"));
        let ends = |line: &String| -> Vec<f64> {
            line.split([' ', ',']).filter(|text| !text.is_empty()).map(|text| text.parse().expect("a number")).collect()
        };
        lines(&svg, GIVEN)[1..].iter().map(ends).collect::<Vec<_>>()
    };
    let drawn = given(&scene);
    let infinite: Vec<_> = points.iter().map(|[start, _]| nalgebra::Vector3::new(1.0, 0.0, -start[0])).collect();
    scene.views[0] = View::from_pixel_lines(*scene.views[0].camera(), &infinite).expect("lines");
    let across = given(&scene);
    // The image is 3000 pixels high: from top to bottom without end points.
    assert_eq!(calibration.matrix()[(1, 2)], 1500.0);
    let height = |line: &[f64]| (line[3] - line[1]).abs();
    let ratio = |index: usize| height(&drawn[index]) / height(&across[index]);
    assert!((ratio(0) - 500.0 / 3000.0).abs() < 0.002 && (ratio(1) - 2500.0 / 3000.0).abs() < 0.002, "{drawn:?}");
    assert!((0..2).all(|line| (drawn[line][0] - across[line][0]).abs() <= 1.0), "{drawn:?} {across:?}");
}

#[test]
fn what_has_no_place_is_left_out() {
    let mut with = plot();
    with.series[0].points.extend([[f64::NAN, 1.0], [1.0, f64::INFINITY]]);
    assert_eq!(svg(&with), svg(&plot()));

    // No zero on a logarithmic axis. Up to three decades have plain numbers, others powers of ten.
    let mut logarithmic = plot();
    logarithmic.x = Axis::logarithmic("x");
    logarithmic.y = Axis::logarithmic("y");
    let texts = texts(&svg(&logarithmic));
    assert!(["0.02", "0.1", "0.5", "1", "2"].iter().all(|tick| texts.iter().any(|text| text == tick)), "{texts:?}");
    logarithmic.series[0].points = vec![[1.0, 3e-6], [2.0, 4e2]];
    let texts = self::texts(&svg(&logarithmic));
    assert!(["1e-5", "1e0", "1e2"].iter().all(|tick| texts.iter().any(|text| text == tick)), "{texts:?}");
    assert!(!["1e-6", "1e3"].iter().any(|tick| texts.iter().any(|text| text == tick)), "outside of the data");

    for points in [vec![], vec![[0.0, 0.0]], vec![[-1e300, 5.0], [1e300, 5.0]], vec![[1e-300, 1e8], [2e-300, 2e8]]] {
        for axis in [Axis::linear, Axis::logarithmic] {
            let series = vec![Series { label: String::new(), points: points.clone(), band: None }];
            let (x, y) = (axis("x"), axis("y"));
            let picture = Plot { title: "edge".to_owned(), x, y, series };
            roxmltree::Document::parse(&svg(&picture)).expect("well-formed XML");
        }
    }
    for samples in [vec![], vec![("none".to_owned(), vec![])], vec![("one".to_owned(), vec![3.0])]] {
        let picture = Histogram { samples, bins: 0, ..histogram() };
        roxmltree::Document::parse(&svg(&picture)).expect("well-formed XML");
    }
}
