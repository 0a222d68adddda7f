//! Silhouette lines and cameras in, cylinder out: accuracy, invariance, real and committed scenes,
//! refused scenes.

#[path = "../examples/make_scene/random.rs"]
mod random;
#[path = "../examples/make_scene/scene.rs"]
mod scene;

use std::f64::consts::TAU;
use std::path::Path;

use eliminant_cylinders::{
    Calibration, Camera, CircleError, Cylinder, DirectionError, TriangulateError, Triangulation, View, ViewError,
    read_scene, triangulate,
};
use nalgebra::{Matrix3, Matrix3x4, Point3, Rotation3, Unit, Vector3};
use random::Random;
use scene::{Can, Photograph, Setup};

/// Views of photographs, with lines and residuals in pixels.
fn views(setup: &Setup, photographs: &[Photograph]) -> Vec<View> {
    let view = |photograph: &Photograph| {
        let camera = Camera::from_normalised(&photograph.camera)?;
        let camera = camera.with_calibration(Calibration::new(&setup.calibration)?);
        View::from_pixel_lines(camera, &photograph.lines)
    };
    photographs.iter().map(view).collect::<Result<_, ViewError>>().expect("valid views")
}

fn random_direction(random: &mut Random) -> Unit<Vector3<f64>> {
    Unit::new_normalize(Vector3::from_fn(|_, _| random.normal()))
}

/// A cylinder anywhere near the origin and three to eight cameras around it.
fn random_scene(random: &mut Random, noise: f64) -> (Can, Setup) {
    let base = Point3::from(Vector3::from_fn(|_, _| random.uniform(-5.0, 5.0)));
    let radius = random.uniform(0.5, 2.0);
    let height = random.uniform(2.0, 8.0);
    let focal = random.uniform(500.0, 4000.0);
    let calibration = Matrix3::new(focal, 2.0, 0.5 * focal, 0.0, 1.01 * focal, 0.4 * focal, 0.0, 0.0, 1.0);
    let cameras = random.uniform(3.0, 9.0) as usize;
    let setup = Setup { calibration, cameras, distance: (6.0, 20.0), elevation: 8.0, noise };
    (Can { base, direction: random_direction(random), radius, height }, setup)
}

fn truth(can: &Can) -> Cylinder {
    Cylinder::new(&can.base, can.direction, can.radius)
}

/// Distance of the point `at` from the axis.
fn axis_distance(cylinder: &Cylinder, at: &Point3<f64>) -> f64 {
    cylinder.distance(at) + cylinder.radius
}

/// Angle between two axes, radians.
fn axis_angle(left: &Cylinder, right: &Cylinder) -> f64 {
    left.direction.cross(&right.direction).norm().asin()
}

/// Largest of the relative errors of radius and axis position (against the radius) and the angle
/// between the axes.
fn error(found: &Cylinder, can: &Can) -> f64 {
    let radius = (found.radius - can.radius).abs() / can.radius;
    let position = axis_distance(found, &can.base) / can.radius;
    radius.max(position).max(axis_angle(found, &truth(can)))
}

#[test]
fn noise_free_scenes_give_the_cylinder() {
    let mut random = Random::new(10);
    let mut errors: Vec<f64> = (0..2000)
        .map(|index| {
            let (can, setup) = random_scene(&mut random, 0.0);
            let views = views(&setup, &scene::photographs(&can, &setup, &mut random));
            let result = triangulate(&views).unwrap_or_else(|error| panic!("scene {index}: {error}"));
            assert_eq!(result.residuals.len(), 2 * setup.cameras);
            for residual in &result.residuals {
                assert!(residual.distance.abs() < 1e-9 && residual.angle < 1e-9, "scene {index}: {residual:?}");
                assert!(residual.pixels.is_some_and(|pixels| pixels < 1e-5), "scene {index}: {residual:?}");
            }
            error(&result.cylinder, &can)
        })
        .collect();
    errors.sort_by(f64::total_cmp);
    let (median, worst) = (errors[errors.len() / 2], errors[errors.len() - 1]);
    println!("relative error: median {median:.1e}, worst {worst:.1e}");
    assert!(worst < 1e-9, "worst {worst:e}");
    assert!(median < 1e-12, "median {median:e}");
}

/// The simplest scene: a cylinder along an axis of the world, and cameras on a ring in equal steps.
#[test]
fn cameras_in_equal_steps_around_the_cylinder() {
    let can = Can { base: Point3::origin(), direction: Vector3::y_axis(), radius: 1.0, height: 1.0 };
    for cameras in 2..=24 {
        for distance in [1.5, 5.0, 100.0] {
            let view = |index: usize| {
                let turn = Rotation3::from_axis_angle(&Vector3::y_axis(), TAU * index as f64 / cameras as f64);
                let camera =
                    Camera::from_normalised(&turn.matrix().insert_column(3, 0.0).map_with_location(
                        |row, column, entry| if (row, column) == (2, 3) { distance } else { entry },
                    ));
                let camera = camera.expect("a camera");
                View::from_normalised_lines(camera, &truth(&can).silhouette(&camera).expect("outside")).expect("lines")
            };
            let result = triangulate(&(0..cameras).map(view).collect::<Vec<_>>());
            let result = result.unwrap_or_else(|error| panic!("{cameras} cameras at {distance}: {error}"));
            let error = error(&result.cylinder, &can);
            assert!(error < 1e-12 * distance, "{cameras} cameras at {distance}: off by {error:e}");
        }
    }
}

fn data(name: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("data").join(name)
}

#[test]
fn the_committed_scene_is_what_its_generator_writes() {
    let setup = scene::soda_can_setup();
    let photographs = scene::photographs(&scene::soda_can(), &setup, &mut Random::new(scene::SODA_CAN_SEED));
    let committed = std::fs::read_to_string(data("soda_can.json")).expect("data/soda_can.json");
    assert!(
        committed == scene::json(&setup, &photographs),
        "data/soda_can.json is stale: cargo run -p eliminant-cylinders --example make_scene > cylinders/data/soda_can.json"
    );
}

/// Displacement in space of one silhouette end point by the noise of the set-up, at the largest
/// distance: an upper estimate for a result that averages over many end points.
fn end_point_deviation(setup: &Setup) -> f64 {
    let distance = setup.distance.1.hypot(setup.elevation);
    setup.noise * distance / setup.calibration[(0, 0)]
}

/// Distance of the axis from the middle of the can, errors of radius and of direction.
fn soda_can_errors(result: &Triangulation, can: &Can) -> [f64; 3] {
    let middle = can.base + can.direction.into_inner() * (can.height / 2.0);
    let cylinder = &result.cylinder;
    [axis_distance(cylinder, &middle), cylinder.radius - can.radius, axis_angle(cylinder, &truth(can))]
}

#[test]
fn the_committed_scene_gives_its_can_within_the_noise() {
    let (can, setup) = (scene::soda_can(), scene::soda_can_setup());
    let scene = read_scene(&data("soda_can.json")).expect("a scene");
    let result = triangulate(&scene.views).expect("a cylinder");
    let deviation = end_point_deviation(&setup);
    let [position, radius, angle] = soda_can_errors(&result, &can);
    assert!(position < deviation, "axis off by {position}");
    assert!(radius.abs() < deviation, "radius off by {radius}");
    assert!(angle < deviation / can.height, "direction off by {angle}");
    for residual in &result.residuals {
        assert!(residual.pixels.is_some_and(|pixels| pixels < 4.0 * setup.noise), "{residual:?}");
    }
}

#[test]
fn noise_gives_no_bias() {
    let (can, setup) = (scene::soda_can(), scene::soda_can_setup());
    let deviation = end_point_deviation(&setup);
    let runs = 400;
    let radii: Vec<f64> = (0..runs)
        .map(|seed| {
            let views = views(&setup, &scene::photographs(&can, &setup, &mut Random::new(1000 + seed)));
            let errors = soda_can_errors(&triangulate(&views).expect("a cylinder"), &can);
            // In a sample of this size hardly any error exceeds four standard deviations, each well
            // below `deviation`.
            assert!(errors[0] < 2.0 * deviation && errors[2] < 2.0 * deviation / can.height, "seed {seed}: {errors:?}");
            errors[1]
        })
        .collect();
    let count = runs as f64;
    let mean = radii.iter().sum::<f64>() / count;
    let variance = radii.iter().map(|radius| (radius - mean).powi(2)).sum::<f64>() / (count - 1.0);
    println!("radius error: mean {mean:.2e}, standard deviation {:.2e}", variance.sqrt());
    assert!(variance.sqrt() < deviation, "standard deviation {}", variance.sqrt());
    assert!(mean.abs() < 4.0 * (variance / count).sqrt(), "mean error of the radius {mean}");
}

/// Photographs of a round tower, published by others, beside the checkout. They are optional.
#[test]
fn a_real_tower() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data/kungshuset.json");
    if !path.exists() {
        eprintln!("skipped: {} is not there", path.display());
        return;
    }
    let scene = read_scene(&path).expect("a scene");
    let result = triangulate(&scene.views).expect("a cylinder");
    let cylinder = &result.cylinder;
    assert_eq!(result.residuals.len(), 6);
    // The tower is slightly conical: five of the six planes, and the sparse points, lean by about
    // half a degree. A cylinder cannot fit this, so the limit is twice that angle.
    for residual in &result.residuals {
        assert!(residual.distance.abs() < 0.05 * cylinder.radius, "{residual:?}");
        assert!(residual.angle.to_degrees() < 1.0, "{residual:?}");
    }
    // The cameras see one side of the tower: no points are inside, and a third of them are on its
    // surface.
    let distances = scene.points.iter().map(|point| cylinder.distance(point) / cylinder.radius);
    let near = distances.clone().filter(|distance| distance.abs() < 0.05).count();
    let inside = distances.filter(|&distance| distance < -0.2).count();
    println!("{near} of {} points near the surface, {inside} inside", scene.points.len());
    assert!(3 * near > scene.points.len(), "{near} points near the surface");
    assert!(100 * inside < scene.points.len(), "{inside} points inside");
}

/// Applies `X -> scale * rotation * X + shift` to the world: `[R t]` becomes
/// `[R Q^T, scale t - R Q^T shift]`.
fn move_world(view: &View, rotation: &Rotation3<f64>, shift: &Vector3<f64>, scale: f64) -> View {
    let camera = view.camera();
    let turned = camera.rotation() * rotation.inverse().matrix();
    let translation = camera.translation() * scale - turned * shift;
    let matrix = turned.insert_column(3, 0.0)
        + Matrix3x4::from_fn(|row, column| if column == 3 { translation[row] } else { 0.0 });
    let moved = Camera::from_normalised(&matrix).expect("a camera");
    View::from_normalised_lines(moved, view.lines()).expect("lines")
}

#[test]
fn the_world_frame_does_not_matter_even_with_noise() {
    let mut random = Random::new(20);
    for _ in 0..200 {
        let (can, setup) = random_scene(&mut random, 0.5);
        let views = views(&setup, &scene::photographs(&can, &setup, &mut random));
        let original = triangulate(&views).expect("a cylinder");

        let rotation = Rotation3::from_axis_angle(&random_direction(&mut random), random.uniform(0.0, 3.0));
        let shift = Vector3::from_fn(|_, _| random.uniform(-20.0, 20.0));
        let scale = random.uniform(0.01, 100.0);
        let moved: Vec<_> = views.iter().map(|view| move_world(view, &rotation, &shift, scale)).collect();
        let result = triangulate(&moved).expect("a cylinder");

        let expected = Can {
            base: Point3::from(rotation * original.cylinder.axis_point.coords * scale + shift),
            direction: rotation * original.cylinder.direction,
            radius: original.cylinder.radius * scale,
            height: 1.0,
        };
        let difference = error(&result.cylinder, &expected);
        assert!(difference < 1e-8, "differs by {difference:e}");
    }
}

#[test]
fn order_and_signs_do_not_matter() {
    let mut random = Random::new(30);
    for _ in 0..200 {
        let (can, setup) = random_scene(&mut random, 0.5);
        let mut photographs = scene::photographs(&can, &setup, &mut random);
        let original = triangulate(&views(&setup, &photographs)).expect("a cylinder").cylinder;
        photographs.reverse();
        for photograph in &mut photographs {
            photograph.lines.reverse();
            photograph.lines[0] *= -random.uniform(0.1, 10.0);
            photograph.camera *= -random.uniform(0.1, 10.0);
        }
        let result = triangulate(&views(&setup, &photographs)).expect("a cylinder").cylinder;
        let expected =
            Can { base: original.axis_point, direction: original.direction, radius: original.radius, height: 1.0 };
        let difference = error(&result, &expected);
        assert!(difference < 1e-9, "differs by {difference:e}");
    }
}

#[test]
fn silhouettes_of_the_result_are_the_lines() {
    let mut random = Random::new(40);
    let (can, setup) = random_scene(&mut random, 0.0);
    let views = views(&setup, &scene::photographs(&can, &setup, &mut random));
    for view in &views {
        let silhouette = truth(&can).silhouette(view.camera()).expect("a camera outside");
        for line in view.lines() {
            let nearest = silhouette.iter().map(|other| line.cross(other).norm()).fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-12, "off by {nearest:e}");
        }
    }
    let inside =
        Matrix3x4::identity() - Matrix3x4::from_fn(|row, column| if column == 3 { can.base[row] } else { 0.0 });
    assert_eq!(truth(&can).silhouette(&Camera::from_normalised(&inside).expect("a camera")), None);
}

// Scenes that determine no cylinder.

/// The views of a noise-free scene.
fn good_views(seed: u64) -> (Can, Vec<View>) {
    let mut random = Random::new(seed);
    let (can, setup) = random_scene(&mut random, 0.0);
    let photographs = scene::photographs(&can, &setup, &mut random);
    (can, views(&setup, &photographs))
}

fn with_lines(view: &View, lines: &[Vector3<f64>]) -> View {
    View::from_normalised_lines(*view.camera(), lines).expect("lines")
}

#[test]
fn too_few_lines() {
    let (_, views) = good_views(50);
    assert_eq!(triangulate(&[]), Err(TriangulateError::TooFewLines { lines: 0 }));
    assert_eq!(triangulate(&views[..1]), Err(TriangulateError::TooFewLines { lines: 2 }));
}

#[test]
fn three_lines_leave_several_circles() {
    let (_, mut views) = good_views(51);
    views.truncate(2);
    views[1] = with_lines(&views[1], &views[1].lines()[..1]);
    let Err(TriangulateError::Circle(CircleError::Ambiguous { circles })) = triangulate(&views) else {
        panic!("{:?}", triangulate(&views));
    };
    assert_eq!(circles, 4, "incircle and three excircles");
}

#[test]
fn repeated_lines_are_not_new_lines() {
    let (_, mut views) = good_views(52);
    views.truncate(2);
    let line = views[0].lines()[0];
    views[0] = with_lines(&views[0], &[line, line * -2.0]);
    views[1] = with_lines(&views[1], &views[1].lines()[..1]);
    assert_eq!(triangulate(&views), Err(TriangulateError::TooFewLines { lines: 2 }));
}

#[test]
fn cameras_at_one_place() {
    let (can, views) = good_views(53);
    let repeated = vec![views[0].clone(), views[0].clone(), views[0].clone()];
    assert_eq!(triangulate(&repeated), Err(TriangulateError::SingleViewpoint));

    // A camera further along the axis sees the same tangent planes.
    let shift = can.direction.into_inner() * 3.0;
    let above = move_world(&views[0], &Rotation3::identity(), &shift, 1.0);
    assert_eq!(triangulate(&[views[0].clone(), above]), Err(TriangulateError::SingleViewpoint));
}

#[test]
fn parallel_planes() {
    // Cameras in a row look along z at vertical lines, all in the image centre: planes parallel to
    // x = 0.
    let view = |x: f64| {
        let camera = Matrix3x4::new(1.0, 0.0, 0.0, -x, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 5.0);
        let camera = Camera::from_normalised(&camera).expect("a camera");
        View::from_normalised_lines(camera, &[Vector3::new(1.0, 0.0, 0.0)]).expect("a line")
    };
    let result = triangulate(&[view(-1.0), view(0.0), view(1.0), view(2.0)]);
    assert!(matches!(result, Err(TriangulateError::Direction(DirectionError::ParallelPlanes { .. }))), "{result:?}");
}

#[test]
fn planes_without_a_common_direction() {
    let camera = Camera::from_normalised(&Matrix3x4::identity()).expect("a camera");
    let lines = [Vector3::new(1.0, 0.0, 0.2), Vector3::new(0.0, 1.0, 0.1), Vector3::new(1.0, 1.0, -1.5)];
    let view = View::from_normalised_lines(camera, &lines).expect("lines");
    let result = triangulate(&[view]);
    assert!(matches!(result, Err(TriangulateError::Direction(DirectionError::NoCommonDirection { .. }))), "{result:?}");
}

#[test]
fn a_line_across_the_axis() {
    let mut random = Random::new(54);
    let (can, setup) = (scene::soda_can(), scene::soda_can_setup());
    let mut views = views(&setup, &scene::photographs(&can, &setup, &mut random));
    // The plane across the axis, in place of the second silhouette of the fourth view.
    let across = views[3].camera().rotation() * can.direction.into_inner();
    views[3] = with_lines(&views[3], &[views[3].lines()[0], across]);
    assert_eq!(triangulate(&views), Err(TriangulateError::AcrossAxis { view: 3, line: 1 }));
}

#[test]
fn lines_along_the_axis_instead_of_silhouettes() {
    let (can, views) = good_views(55);
    let axis = |view: &View| {
        let camera = view.camera();
        let [near, far] = [can.base, can.base + can.direction.into_inner()]
            .map(|point| camera.rotation() * point.coords + camera.translation());
        with_lines(view, &[near.cross(&far)])
    };
    let views: Vec<_> = views.iter().map(axis).collect();
    assert_eq!(triangulate(&views), Err(CircleError::Concurrent.into()));
}

#[test]
fn a_camera_inside() {
    // The cross-section is horizontal. Lines touch the unit circle from cameras around it. One
    // camera is in its centre, and its single line cannot be a tangent.
    let view = |centre: Vector3<f64>, normals: &[Vector3<f64>]| {
        let camera = Matrix3x4::from_columns(&[Vector3::x(), Vector3::y(), Vector3::z(), -centre]);
        let camera = Camera::from_normalised(&camera).expect("a camera");
        View::from_normalised_lines(camera, normals).expect("lines")
    };
    let tangent = |angle: f64| {
        let normal = Vector3::new(angle.cos(), 0.0, angle.sin());
        view(normal + Vector3::new(-angle.sin(), 0.0, angle.cos()) * 3.0, &[normal])
    };
    let mut views: Vec<_> = (0..7).map(|index| tangent(0.9 * index as f64)).collect();
    views.push(view(Vector3::zeros(), &[Vector3::new(1.0, 0.0, 0.3)]));
    let result = triangulate(&views);
    assert!(matches!(result, Err(TriangulateError::CameraInside { view: 7, .. })), "{result:?}");
}

#[test]
fn values_out_of_range() {
    let (_, mut views) = good_views(56);
    for factor in [1e200, 1e306, 1e-200, 1e-306] {
        let far = |view: &View| move_world(view, &Rotation3::identity(), &Vector3::zeros(), factor);
        // The result is a cylinder or an error, never a panic or NaN.
        if let Ok(result) = triangulate(&views.iter().map(far).collect::<Vec<_>>()) {
            assert!(result.cylinder.radius.is_finite() && result.cylinder.radius > 0.0, "{result:?}");
        }
    }
    views[0] = move_world(&views[0], &Rotation3::identity(), &Vector3::new(1e300, 0.0, 0.0), 1.0);
    assert!(triangulate(&views).is_err());
}
