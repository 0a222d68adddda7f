//! Lines with end points: refined cylinders are better, there are more inliers, and residuals and
//! extents refer to the end points; also scene files with end points.

#[path = "../examples/make_scene/random.rs"]
mod random;
#[path = "../examples/make_scene/scene.rs"]
#[allow(dead_code, reason = "scene files are not written here")]
mod scene;
mod scenes;

use eliminant_cylinders::extent::visible_extent;
use eliminant_cylinders::{
    Calibration, Camera, Cylinder, DistanceUnit, Loss, Metric, RefineOptions, RobustOptions, Scene, Side, View,
    ViewError, parse_scene, parse_segments, refine, triangulate_robustly,
};
use nalgebra::{Matrix3, Matrix3x4, Point2, Point3, Vector2, Vector3};
use random::Random;
use scene::{Can, Photograph, Setup};
use scenes::{Motion, difference, refined, truth, without_calibration};

/// End points of a silhouette, pixels.
type Segment = [Point2<f64>; 2];

fn camera(setup: &Setup, photograph: &Photograph) -> Camera {
    let calibration = Calibration::new(&setup.calibration).expect("a calibration");
    Camera::from_normalised(&photograph.camera).expect("a camera").with_calibration(calibration)
}

/// The part of each contact line from `part[0]` to `part[1]` of the height of the can, as the
/// camera sees it, with noise.
fn segments(can: &Can, setup: &Setup, camera: &Camera, part: [f64; 2], random: &mut Random) -> [Segment; 2] {
    let direction = can.direction.into_inner();
    let outward = camera.centre() - can.base;
    let outward = outward - direction * direction.dot(&outward);
    let cosine = can.radius / outward.norm();
    let toward = outward.normalize();
    [1.0, -1.0].map(|side| {
        let sideways = direction.cross(&toward) * (side * (1.0 - cosine * cosine).sqrt());
        part.map(|part| {
            let point = can.base + (toward * cosine + sideways) * can.radius + direction * (part * can.height);
            let seen = setup.calibration * (camera.rotation() * point.coords + camera.translation());
            Point2::from(seen.xy() / seen.z + Vector2::new(random.normal(), random.normal()) * setup.noise)
        })
    })
}

/// Views of the soda can. Each shows both silhouettes along a part of the can that `part` chooses.
fn can_views(setup: &Setup, random: &mut Random, part: impl Fn(&mut Random) -> [f64; 2]) -> Vec<View> {
    let can = scene::soda_can();
    let view = |photograph: &Photograph, random: &mut Random| {
        let camera = camera(setup, photograph);
        let part = part(random);
        let segments = segments(&can, setup, &camera, part, random);
        View::from_pixel_segments(camera, &segments).expect("segments")
    };
    scene::photographs(&can, setup, random).iter().map(|photograph| view(photograph, random)).collect()
}

/// A random part of the can, from a twentieth to half of its height.
fn short(random: &mut Random) -> [f64; 2] {
    let length = random.uniform(0.05, 0.5);
    let start = random.uniform(0.0, 1.0 - length);
    [start, start + length]
}

fn without_ends(views: &[View]) -> Vec<View> {
    views.iter().map(|view| view.clone().with_ends(vec![None; view.lines().len()]).expect("lines")).collect()
}

#[test]
fn refinement_is_better_with_end_points_than_with_infinite_lines() {
    let (can, setup) = (scene::soda_can(), scene::soda_can_setup());
    let middle = can.base + can.direction.into_inner() * (can.height / 2.0);
    let errors = |found: &Cylinder| {
        let position = found.distance(&middle) + found.radius;
        [found.direction.cross(&can.direction).norm(), position, found.radius - can.radius]
    };
    let (mut with, mut without) = ([0.0; 3], [0.0; 3]);
    for seed in 0..200 {
        let views = can_views(&setup, &mut Random::new(seed), short);
        for (views, sum) in [(&views, &mut with), (&without_ends(&views), &mut without)] {
            let found = refined(views, &truth(&can)).cylinder;
            (0..3).for_each(|index| sum[index] += errors(&found)[index].powi(2) / 200.0);
        }
    }
    let [with, without] = [with, without].map(|sum| sum.map(f64::sqrt));
    println!("root mean square errors of direction [rad], axis [mm], radius [mm]: {with:.5?} with end points");
    println!("{without:.5?} without");
    for index in 0..3 {
        assert!(with[index] <= without[index], "{with:?} with end points, {without:?} without");
    }
}

#[test]
fn ransac_keeps_short_segments() {
    let setup = Setup { cameras: 15, noise: 1.0, ..scene::soda_can_setup() };
    let (mut with, mut without) = (0, 0);
    for seed in 0..20 {
        let views = can_views(&setup, &mut Random::new(seed), short);
        let options = RobustOptions::of(&views);
        let result = triangulate_robustly(&views, &options).expect("a cylinder");
        let near = |pixels: Option<f64>| pixels.is_some_and(|pixels| pixels < options.ransac.threshold);
        let inliers = result.residuals.iter().filter(|residual| near(residual.pixels)).count();
        assert_eq!(inliers, result.inliers.len(), "the residual that is reported is the one that decides");
        with += inliers;
        without += triangulate_robustly(&without_ends(&views), &options).expect("a cylinder").inliers.len();
    }
    println!("{with} of 600 silhouettes are inliers with end points, {without} without");
    // A line is lost if two independent distances of a pixel have a root mean square of three: once
    // in 8000 lines.
    assert!(with >= 598 && with > without, "{with} {without}");
}

#[test]
fn residuals_are_what_the_refinement_minimises() {
    let can = scene::soda_can();
    let views = can_views(&scene::soda_can_setup(), &mut Random::new(1), short);
    let result = refined(&views, &truth(&can));
    let residuals = |view: &View| result.cylinder.residuals(0, view).expect("outside");
    let residuals: Vec<_> = views.iter().flat_map(residuals).collect();
    let square: f64 = residuals.iter().map(|residual| residual.pixels.expect("a calibration").powi(2)).sum();
    assert!(((square / residuals.len() as f64).sqrt() - result.rms).abs() < 1e-12);
    assert!(result.rms > 0.3 && result.rms < 0.6, "noise of half a pixel: {}", result.rms);

    // Without a calibration there are no pixels, but the sides are the same.
    for (view, known) in views.iter().zip(residuals.chunks(2)) {
        let other = result.cylinder.residuals(0, &without_calibration(view)).expect("outside");
        assert!(other.iter().zip(known).all(|(other, known)| other.pixels.is_none() && other.side == known.side));
    }
}

#[test]
fn neither_world_nor_order_of_the_end_points_matter() {
    let mut random = Random::new(2);
    let (can, setup) = (scene::soda_can(), scene::soda_can_setup());
    for _ in 0..20 {
        let views = can_views(&setup, &mut random, short);
        for unit in [DistanceUnit::Pixels, DistanceUnit::Radians] {
            let options = RefineOptions { metric: Metric { unit, ..Metric::of(&views) }, loss: Loss::Quadratic };
            let original = refine(&views, &truth(&can), &options).expect("a cylinder");
            let motion = Motion::random(&mut random);
            let swapped = |view: &View| {
                let ends = view.ends().iter().map(|ends| ends.map(|[start, end]| [end, start])).collect();
                motion.view(view).with_ends(ends).expect("end points")
            };
            let moved: Vec<_> = views.iter().map(swapped).collect();
            let result = refine(&moved, &motion.cylinder(&truth(&can)), &options).expect("a cylinder");
            let expected = motion.cylinder(&original.cylinder);
            let off = difference(&result.cylinder, &expected, &motion.point(&original.reference));
            assert!(off < 1e-7, "{unit:?}: differs by {off:e}");
        }
    }
}

/// On a thin cylinder the plane of a short, slightly turned segment is nearer to the wrong tangent
/// plane.
#[test]
fn the_side_is_the_one_at_the_end_points() {
    let cylinder = Cylinder::new(&Point3::new(0.0, 0.0, 10.0), Vector3::y_axis(), 0.01);
    let calibration = Calibration::new(&Matrix3::new(1000.0, 0.0, 500.0, 0.0, 1000.0, 400.0, 0.0, 0.0, 1.0));
    let camera = Camera::from_normalised(&Matrix3x4::identity()).expect("a camera");
    let camera = camera.with_calibration(calibration.expect("a calibration"));
    let mut wrong = 0;
    // The image of the cylinder is two pixels wide; `y` points down, and so does the axis.
    for (x, side) in [(499.0, Side::Right), (501.0, Side::Left)] {
        for turn in [-0.8, 0.8] {
            let segment = [Point2::new(x - turn, 0.0), Point2::new(x + turn, 10.0)];
            let view = View::from_pixel_segments(camera, &[segment]).expect("a segment");
            let residual = cylinder.residuals(0, &view).expect("outside")[0];
            assert_eq!(residual.side, side);
            assert!((residual.pixels.expect("a calibration") - 0.8).abs() < 1e-3, "{residual:?}");
            let infinite = cylinder.residuals(0, &without_ends(&[view])[0]).expect("outside")[0];
            wrong += usize::from(infinite.side != side);
        }
    }
    assert!(wrong > 0, "the angle is enough here");
}

#[test]
fn the_extent_is_between_the_end_points() {
    let (can, exact) = (scene::soda_can(), Setup { noise: 0.0, ..scene::soda_can_setup() });
    let cylinder = truth(&can);
    let bottom = cylinder.height(&can.base);
    let off = |views: &[View], cylinder: &Cylinder, expected: [f64; 2]| {
        let extent = visible_extent(cylinder, views, &[]).expect("it is seen");
        (extent[0] - expected[0]).abs().max((extent[1] - expected[1]).abs())
    };
    let views = can_views(&exact, &mut Random::new(1), |_| [0.0, 1.0]);
    let error = off(&views, &cylinder, [bottom, bottom + can.height]);
    assert!(error < 1e-9, "off by {error:e}");
    // The images show more than the can.
    assert!(off(&without_ends(&views), &cylinder, [bottom, bottom + can.height]) > 50.0);

    // Half a pixel is 0.1 mm there.
    let noisy = can_views(&scene::soda_can_setup(), &mut Random::new(1), |_| [0.0, 1.0]);
    let found = refined(&noisy, &cylinder).cylinder;
    let bottom_found = found.height(&can.base);
    let error = off(&noisy, &found, [bottom_found, bottom_found + can.height]);
    println!("extent with noise: off by {error:.3} mm");
    assert!(error < 0.5, "off by {error} mm");

    // The extent covers the end points of all images, and points on the surface do not count.
    let mut pieces = can_views(&exact, &mut Random::new(1), |_| [0.0, 0.3]);
    pieces.extend(can_views(&exact, &mut Random::new(2), |_| [0.6, 0.9]));
    assert!(off(&pieces, &cylinder, [bottom, bottom + 0.9 * can.height]) < 1e-9);
    let side = cylinder.direction.cross(&Vector3::x()).normalize() * cylinder.radius;
    let points: Vec<_> = (0..100).map(|height| cylinder.axis_at(f64::from(height)) + side).collect();
    assert_eq!(visible_extent(&cylinder, &pieces, &points), visible_extent(&cylinder, &pieces, &[]));

    // A camera sees nothing behind it.
    let behind = Cylinder::new(&Point3::new(0.0, 0.0, -10.0), Vector3::y_axis(), 1.0);
    let ahead = Cylinder::new(&Point3::new(0.0, 0.0, 10.0), Vector3::y_axis(), 1.0);
    let camera = Camera::from_normalised(&Matrix3x4::identity()).expect("a camera");
    let lines = ahead.silhouette(&camera).expect("outside");
    let ends = lines.map(|line| Some([-0.2, 0.3].map(|y| Point2::new(-line.z / line.x, y))));
    let view = View::from_normalised_lines(camera, &lines).and_then(|view| view.with_ends(ends.to_vec()));
    let views = [view.expect("lines")];
    // At the depth 9.9 of the contact lines.
    assert!(off(&views, &ahead, [-0.2 * 9.9, 0.3 * 9.9]) < 1e-9);
    assert_eq!(visible_extent(&behind, &views, &[]), visible_extent(&behind, &without_ends(&views), &[]));
}

/// Writes numbers so that they are read back exactly.
fn numbers<'a>(numbers: impl IntoIterator<Item = &'a f64>) -> String {
    format!("{:?}", numbers.into_iter().collect::<Vec<_>>())
}

/// A scene file of views in pixels, with their segments and, on request, their lines.
fn json(views: &[View], lines: bool) -> String {
    let view = |view: &View| {
        let calibration = view.camera().calibration().expect("a calibration");
        let matrix =
            |row: usize| numbers(view.camera().rotation().row(row).iter().chain([&view.camera().translation()[row]]));
        let segment = |ends: &Option<Segment>| {
            let [start, end] = ends.expect("end points").map(|end| calibration.point_to_pixels(&end));
            numbers(start.iter().chain(end.iter()))
        };
        let segments: Vec<_> = view.ends().iter().map(segment).collect();
        let all: Vec<_> = view.lines().iter().map(|line| numbers(line.iter())).collect();
        let lines = if lines { format!("\"lines_normalised\": [{}], ", all.join(", ")) } else { String::new() };
        let rows = [0, 1, 2].map(matrix).join(", ");
        format!("{{\"camera_normalised\": [{rows}], {lines}\"segments_pixels\": [{}]}}", segments.join(", "))
    };
    let k = views[0].camera().calibration().expect("a calibration").matrix();
    let rows = [0, 1, 2].map(|row| numbers(k.row(row).iter())).join(", ");
    let views: Vec<_> = views.iter().map(view).collect();
    format!("{{\"K\": [{rows}], \"views\": [{}]}}", views.join(", "))
}

#[test]
fn scene_files_keep_end_points() {
    let views = can_views(&scene::soda_can_setup(), &mut Random::new(3), short);
    for lines in [false, true] {
        let read = parse_scene(&json(&views, lines), "scene.json").expect("a scene").views;
        for (read, view) in read.iter().zip(&views) {
            for line in 0..2 {
                let (one, other) = (read.ends()[line].expect("end points"), view.ends()[line].expect("end points"));
                assert!(one.iter().zip(&other).all(|(one, other)| (one - other).norm() < 1e-14));
                assert!(read.lines()[line].cross(&view.lines()[line]).norm() < 1e-12);
            }
        }
        let [expected, found] = [&views, &read].map(|views| refined(views, &truth(&scene::soda_can())).cylinder);
        assert!(difference(&found, &expected, &scene::soda_can().base) < 1e-9);
    }
}

#[test]
fn pieces_of_a_line_end_at_the_outermost() {
    let scene = "{\"K\": [[1000,0,500],[0,1000,400],[0,0,1]], \"views\": [{\"image\": \"a.jpg\", \
        \"camera_normalised\": [[1,0,0,0],[0,1,0,0],[0,0,1,5]], \"lines_pixels\": [[1,0,-3]]}]}";
    let text =
        "image,x1,y1,x2,y2,cylinder,line\na.jpg,200,99,300,101,b,left\na.jpg,7,0,7,9,a,\na.jpg,0,101,100,99,b,left\n";
    let segments = parse_segments(text.as_bytes(), "s.csv").expect("segments");
    let scene = parse_scene(scene, "").expect("a scene").with_segments(&segments).expect("images of the scene");
    let pixels = |scene: &Scene, label: &str| {
        let cylinders = scene.cylinders();
        let view = &cylinders.iter().find(|lines| lines.label.as_deref() == Some(label)).expect("lines").views[0];
        let calibration = view.camera().calibration().expect("a calibration");
        assert_eq!(view.ends().len(), 1);
        view.ends()[0].expect("end points").map(|end| calibration.point_to_pixels(&end))
    };
    assert_eq!(scene.views[0].ends()[0], None, "the line of the scene file");
    // The line of both pieces is y = 100.
    for (label, expected) in [("b", [[0.0, 100.0], [300.0, 100.0]]), ("a", [[7.0, 0.0], [7.0, 9.0]])] {
        let found = pixels(&scene, label);
        let near = found.iter().zip(expected).all(|(found, expected)| (found - Point2::from(expected)).norm() < 1e-9);
        assert!(near, "{label}: {found:?}");
    }
}

#[test]
fn end_points_are_checked() {
    let setup = scene::soda_can_setup();
    let view = can_views(&setup, &mut Random::new(4), short).remove(0);
    let good = view.ends()[0];
    let point = Point2::new(0.1, 0.2);
    let with_ends = |ends: [Option<Segment>; 2]| view.clone().with_ends(ends.to_vec());
    assert_eq!(with_ends([None, good]).map(|view| view.ends()[0]), Ok(None));
    assert_eq!(view.clone().with_ends(vec![good]), Err(ViewError::EndCount { lines: 2, ends: 1 }));
    assert_eq!(with_ends([good, Some([point; 2])]), Err(ViewError::NoLength { line: 1 }));
    for bad in [f64::NAN, f64::INFINITY] {
        let ends = Some([point, Point2::new(bad, 0.0)]);
        assert_eq!(with_ends([good, ends]), Err(ViewError::EndNotFinite { line: 1 }));
        let segment = [Point2::new(bad, 0.0), Point2::new(3.0, 4.0)];
        let result = View::from_pixel_segments(*view.camera(), &[segment]);
        assert_eq!(result, Err(ViewError::EndNotFinite { line: 0 }));
    }
    let nothing = [Point2::new(3.0, 4.0), Point2::new(3.0, 4.0005)];
    assert_eq!(View::from_pixel_segments(*view.camera(), &[nothing]), Err(ViewError::NoLength { line: 0 }));
    let uncalibrated = *without_calibration(&view).camera();
    assert_eq!(View::from_pixel_segments(uncalibrated, &[nothing]), Err(ViewError::NoCalibration));

    // Points beside the line are moved to it.
    let line = view.lines()[0];
    let moved = good.map(|ends| ends.map(|end| end + line.xy().normalize() * 0.01));
    let ends = with_ends([moved, None]).expect("end points").ends()[0].expect("end points");
    let expected = good.expect("end points");
    assert!(ends.iter().zip(&expected).all(|(end, expected)| (end - expected).norm() < 1e-15));
}
