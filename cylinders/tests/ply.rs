//! PLY files, read back by a strict reader: they contain exactly what the header declares, and it
//! is the scene.

use std::collections::BTreeMap;
use std::path::Path;

use eliminant_cylinders::extent::visible_extent;
use eliminant_cylinders::ply::to_ply;
use eliminant_cylinders::{Calibration, Camera, Cylinder, CylinderLines, Scene, View, read_scene, triangulate};
use nalgebra::{Matrix3, Matrix3x4, Point3, Rotation3, Vector3};

/// Rows of an element: one list of numbers for each of its properties.
type Rows = Vec<Vec<Vec<f64>>>;

/// Reads every element of a PLY file in binary little endian. Panics if the file departs from the
/// format.
fn read(bytes: &[u8]) -> BTreeMap<String, Rows> {
    let end = b"end_header\n";
    let split = bytes.windows(end.len()).position(|window| window == end).expect("a header") + end.len();
    let header = std::str::from_utf8(&bytes[..split]).expect("ASCII");
    let mut lines = header.lines();
    assert_eq!(lines.next(), Some("ply"));
    assert_eq!(lines.next(), Some("format binary_little_endian 1.0"));

    let mut elements: Vec<(String, usize, Vec<Vec<&str>>)> = Vec::new();
    for line in lines.take_while(|line| *line != "end_header") {
        match line.split(' ').collect::<Vec<_>>().as_slice() {
            ["element", name, count] => {
                elements.push(((*name).to_owned(), count.parse().expect("a count"), Vec::new()))
            }
            ["property", types @ .., _] => elements.last_mut().expect("an element").2.push(types.to_vec()),
            _ => panic!("`{line}` is no line of a header"),
        }
    }

    let mut data = &bytes[split..];
    let mut take = |kind: &str| {
        let (number, size) = match kind {
            "uchar" => (f64::from(data[0]), 1),
            "int" => (f64::from(i32::from_le_bytes(data[..4].try_into().expect("four bytes"))), 4),
            "double" => (f64::from_le_bytes(data[..8].try_into().expect("eight bytes")), 8),
            _ => panic!("`{kind}` is no type"),
        };
        data = &data[size..];
        number
    };
    let mut property = |types: &Vec<&str>| match types.as_slice() {
        ["list", count, kind] => (0..take(count) as usize).map(|_| take(kind)).collect(),
        [kind] => vec![take(kind)],
        types => panic!("{types:?} is no property"),
    };
    let read = elements
        .iter()
        .map(|(name, count, types)| {
            (name.clone(), (0..*count).map(|_| types.iter().map(&mut property).collect()).collect())
        })
        .collect();
    assert!(data.is_empty(), "{} bytes too many", data.len());
    read
}

fn point(row: &[Vec<f64>]) -> Point3<f64> {
    Point3::new(row[0][0], row[1][0], row[2][0])
}

fn soda_can() -> (Scene, Vec<(CylinderLines, Cylinder)>) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/soda_can.json");
    let mut scene = read_scene(&path).expect("a scene");
    let lines = scene.cylinders().remove(0);
    let cylinder = triangulate(&lines.views).expect("a cylinder").cylinder;
    scene.points =
        vec![Point3::origin(), cylinder.axis_point + cylinder.direction.cross(&Vector3::x()).normalize() * 33.0];
    (scene, vec![(lines, cylinder)])
}

#[test]
fn the_file_is_the_scene() {
    let (scene, found) = soda_can();
    let bytes = to_ply(&scene, &found);
    assert_eq!(bytes, to_ply(&scene, &found));
    let file = read(&bytes);
    let (vertices, faces, edges) = (&file["vertex"], &file["face"], &file["edge"]);
    let points: Vec<_> = vertices.iter().map(|row| point(row)).collect();
    let cylinder = &found[0].1;

    // Points come first. The second one is on the surface and has its colour.
    assert_eq!(points[..2], scene.points);
    let surface = &faces[0][0];
    let colour = |index: usize| &vertices[index][3..];
    assert_ne!(colour(0), colour(1));
    assert_eq!(colour(1), colour(surface[0] as usize));

    // Triangles whose corners are on the surface and which are seen counter-clockwise from outside;
    // a closed band.
    let mut directed = BTreeMap::new();
    for face in faces {
        let [a, b, c] = *face[0].as_slice() else { panic!("{face:?} is no triangle") };
        let [p, q, r] = [a, b, c].map(|index| points[index as usize]);
        assert!([p, q, r].iter().all(|corner| cylinder.distance(corner).abs() < 1e-9));
        let middle = Point3::from((p.coords + q.coords + r.coords) / 3.0);
        let outward = middle - cylinder.axis_at(cylinder.height(&middle));
        assert!((q - p).cross(&(r - p)).dot(&outward) > 0.0);
        for edge in [[a, b], [b, c], [c, a]] {
            *directed.entry(edge.map(|index| index as usize)).or_insert(0) += 1;
        }
    }
    assert!(directed.values().all(|&count| count == 1), "two triangles run along an edge in the same direction");
    let border = directed.keys().filter(|[a, b]| !directed.contains_key(&[*b, *a])).count();
    assert_eq!(border, faces.len(), "the border: a circle at either end");
    let heights: Vec<_> =
        faces.iter().flat_map(|face| &face[0]).map(|&i| cylinder.height(&points[i as usize])).collect();
    let [low, high] = visible_extent(cylinder, &found[0].0.views, &scene.points).expect("it is seen");
    assert!(heights.iter().all(|&height| (height - low).abs().min((height - high).abs()) < 1e-9));

    // Each of the sixteen lines has a triangle, and each of the eight cameras a pyramid.
    assert_eq!(edges.len(), 16 * 3 + 8 * 8);
    assert_eq!(points.len(), 2 + faces.len() + 16 * 3 + 8 * 5);
    for edge in edges {
        let [a, b] = [edge[0][0], edge[1][0]].map(|index| index as usize);
        assert!(a != b && a < points.len() && b < points.len());
        assert_eq!(colour(a), colour(b));
    }
    for view in &scene.views {
        let centre = view.camera().centre();
        let at_centre = |edge: &&Vec<Vec<f64>>| {
            [edge[0][0], edge[1][0]].iter().any(|&index| (points[index as usize] - centre).norm() < 1e-9)
        };
        assert_eq!(edges.iter().filter(at_centre).count(), 2 * 2 + 4, "two triangles and a pyramid at each centre");
    }
}

/// A camera at `centre` that looks along `-z`, its image upright: 1000 x 800 pixels, focal length
/// 1000.
fn camera(centre: Point3<f64>) -> Camera {
    let rotation = Rotation3::from_axis_angle(&Vector3::x_axis(), std::f64::consts::PI).into_inner();
    let translation = -(rotation * centre.coords);
    let matrix = Matrix3x4::from_fn(|row, column| if column == 3 { translation[row] } else { rotation[(row, column)] });
    let calibration = Calibration::new(&Matrix3::new(1000.0, 0.0, 500.0, 0.0, 1000.0, 400.0, 0.0, 0.0, 1.0));
    Camera::from_normalised(&matrix).expect("a camera").with_calibration(calibration.expect("a calibration"))
}

fn view(cylinder: &Cylinder, camera: Camera) -> View {
    View::from_normalised_lines(camera, &cylinder.silhouette(&camera).expect("outside")).expect("lines")
}

#[test]
fn the_images_show_a_part_of_the_cylinder() {
    let upright = Cylinder::new(&Point3::origin(), Vector3::y_axis(), 1.0);
    let front = view(&upright, camera(Point3::new(0.0, 3.0, 10.0)));
    // The contact lines are 9.9 in front of the camera, and the image spans 0.8 of the depth.
    let expected = [3.0 - 0.4 * 9.9, 3.0 + 0.4 * 9.9];
    let extent = visible_extent(&upright, std::slice::from_ref(&front), &[]).expect("seen");
    assert!(extent.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-12), "{extent:?}");

    // The axis is horizontal in the image, so the width counts; then it is along the line of sight
    // and never leaves the image.
    let across = Cylinder::new(&Point3::origin(), Vector3::x_axis(), 1.0);
    let extent = visible_extent(&across, &[view(&across, camera(Point3::new(0.0, 0.0, 10.0)))], &[]).expect("seen");
    assert!((extent[1] - extent[0] - 9.9).abs() < 1e-12, "{extent:?}");
    let away = Cylinder::new(&Point3::new(0.0, 3.0, 0.0), Vector3::z_axis(), 1.0);
    let extent = visible_extent(&away, &[view(&away, camera(Point3::new(0.0, 0.0, 0.0)))], &[]).expect("seen");
    assert!((extent[0] + 9.0).abs() < 1e-12 && extent[1] < -5.0, "three distances from the axis at most: {extent:?}");

    // Points on the surface count before the images; points elsewhere do not count.
    let on_surface = |index: i32| Point3::new(1.0, f64::from(index) / 100.0, 0.0);
    let points: Vec<_> = (0..=100).map(on_surface).collect();
    let views = [front];
    assert_eq!(visible_extent(&upright, &views, &points), Some([0.01, 0.99]), "without one in a hundred at either end");
    let elsewhere: Vec<_> = points.iter().map(|point| point * 3.0).collect();
    assert_eq!(visible_extent(&upright, &views, &elsewhere), visible_extent(&upright, &views, &[]));
    assert_eq!(visible_extent(&upright, &[], &[]), None);
    let behind = Cylinder::new(&Point3::new(0.0, 0.0, 20.0), Vector3::y_axis(), 1.0);
    assert_eq!(visible_extent(&behind, &[view(&behind, camera(Point3::new(0.0, 0.0, 10.0)))], &[]), None);
}

/// The triangle of a line with end points ends at the end points on the surface.
#[test]
fn viewing_planes_end_at_the_end_points() {
    let cylinder = Cylinder::new(&Point3::origin(), Vector3::y_axis(), 1.0);
    let centre = Point3::new(0.0, 0.0, 10.0);
    let heights = [-0.5, 1.5];
    let infinite = view(&cylinder, camera(centre));
    // Contact points of the tangents from a point at distance 10 to the unit circle: 0.1 towards
    // it, sqrt(0.99) beside it.
    let beside = 0.99_f64.sqrt();
    let seen = |x: f64, y: f64| {
        let seen = infinite.camera().rotation() * Vector3::new(x, y, 0.1) + infinite.camera().translation();
        nalgebra::Point2::from(seen.xy() / seen.z)
    };
    let expected = [beside, -beside].map(|x| heights.map(|y| Point3::new(x, y, 0.1)));
    let with_ends = infinite.clone().with_ends([beside, -beside].map(|x| Some(heights.map(|y| seen(x, y)))).to_vec());
    let scene = Scene { views: vec![with_ends.expect("end points")], points: Vec::new() };
    let lines = scene.cylinders().remove(0);
    let file = read(&to_ply(&scene, &[(lines, cylinder)]));
    let points: Vec<_> = file["vertex"].iter().map(|row| point(row)).collect();
    let triangles = &points[points.len() - 6 - 5..points.len() - 5];
    for (triangle, ends) in triangles.chunks(3).zip(expected) {
        assert!((triangle[0] - centre).norm() < 1e-12);
        assert!((triangle[1] - ends[0]).norm() < 1e-9 && (triangle[2] - ends[1]).norm() < 1e-9, "{triangle:?}");
    }
    let surface: Vec<_> =
        file["face"].iter().flat_map(|face| &face[0]).map(|&index| points[index as usize].y).collect();
    assert!(surface.iter().all(|y| (y - heights[0]).abs().min((y - heights[1]).abs()) < 1e-9));
}
