//! Quadric and dual quadric of a cylinder, silhouettes from the dual, sides and signs of lines:
//! random cylinders and cameras.

#[path = "../examples/make_scene/random.rs"]
mod random;

use std::f64::consts::{FRAC_PI_2, TAU};

use eliminant_cylinders::{Camera, Cylinder, Side, View, silhouette_of_dual_quadric};
use nalgebra::{Matrix3x4, Matrix4, Point3, Rotation3, Unit, Vector3, Vector4};
use random::Random;

const SCENES: usize = 2000;

/// Largest rounding error of a sum of products, relative to the norms of its factors: sixteen
/// terms, each with a few rounded factors.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

fn vector(random: &mut Random) -> Vector3<f64> {
    Vector3::from_fn(|_, _| random.normal())
}

fn cylinder(random: &mut Random) -> Cylinder {
    let point = Point3::from(vector(random) * 3.0);
    Cylinder::new(&point, Unit::new_normalize(vector(random)), random.uniform(0.3, 2.0))
}

/// An orthonormal frame `(u, v)` across the axis.
fn frame(cylinder: &Cylinder, random: &mut Random) -> (Vector3<f64>, Vector3<f64>) {
    let u = cylinder.direction.cross(&vector(random)).normalize();
    (u, cylinder.direction.cross(&u))
}

/// A camera with its centre at `distance` radii from the axis and any rotation, and the unit vector
/// from the axis to it.
fn camera(cylinder: &Cylinder, distance: f64, random: &mut Random) -> (Camera, Vector3<f64>) {
    let (outward, _) = frame(cylinder, random);
    let along = cylinder.direction.into_inner() * random.uniform(-3.0, 3.0);
    let centre = cylinder.axis_point + outward * (distance * cylinder.radius) + along;
    let rotation = Rotation3::from_scaled_axis(vector(random)).into_inner();
    let translation = -(rotation * centre.coords);
    let matrix = rotation.insert_column(3, 0.0);
    let matrix = Matrix3x4::from_fn(|row, column| if column == 3 { translation[row] } else { matrix[(row, column)] });
    (Camera::from_normalised(&matrix).expect("a camera"), outward)
}

/// `x^T M x`, relative to the norms.
fn form(matrix: &Matrix4<f64>, vector: &Vector4<f64>, expected: f64) -> f64 {
    (vector.dot(&(matrix * vector)) - expected).abs() / (matrix.norm() * vector.norm_squared())
}

#[test]
fn points_and_planes_of_the_surface_are_the_zeros_of_the_quadrics() {
    let mut random = Random::new(1);
    for scene in 0..SCENES {
        let cylinder = cylinder(&mut random);
        let (quadric, dual, radius) = (cylinder.quadric(), cylinder.dual_quadric(), cylinder.radius);
        let (u, v) = frame(&cylinder, &mut random);
        let angle = random.uniform(0.0, TAU);
        let normal = u * angle.cos() + v * angle.sin();
        let along = cylinder.direction.into_inner() * random.uniform(-5.0, 5.0);

        let point = cylinder.axis_point + normal * radius + along;
        assert!(form(&quadric, &point.to_homogeneous(), 0.0) < ROUNDING, "scene {scene}");
        // The gradient of the quadric is the tangent plane.
        let plane = Vector4::new(normal.x, normal.y, normal.z, -normal.dot(&point.coords));
        let gradient = quadric * point.to_homogeneous();
        let size = quadric.norm() * point.to_homogeneous().norm();
        assert!((gradient - plane * radius).norm() < ROUNDING * size, "scene {scene}");
        assert!(form(&dual, &plane, 0.0) < ROUNDING, "scene {scene}");

        // Off the surface both have the values that the documentation states.
        let off = random.uniform(-0.9, 3.0) * radius;
        let point = cylinder.axis_point + normal * (radius + off) + along;
        assert!((cylinder.distance(&point) - off).abs() < ROUNDING * point.to_homogeneous().norm(), "scene {scene}");
        let value = (radius + off).powi(2) - radius.powi(2);
        assert!(form(&quadric, &point.to_homogeneous(), value) < ROUNDING, "scene {scene}");
        assert!(form(&dual, &(plane - Vector4::w() * off), -value) < ROUNDING, "scene {scene}");
    }
}

#[test]
fn the_quadrics_are_inverse_but_for_the_direction_of_the_axis() {
    let mut random = Random::new(2);
    for scene in 0..SCENES {
        let cylinder = cylinder(&mut random);
        let (c, d, factor) = (cylinder.quadric(), cylinder.dual_quadric(), cylinder.radius.powi(2));
        assert!((c * d * c - c * factor).norm() < ROUNDING * c.norm().powi(2) * d.norm(), "scene {scene}");
        assert!((d * c * d - d * factor).norm() < ROUNDING * d.norm().powi(2) * c.norm(), "scene {scene}");
        let vertex = cylinder.direction.to_homogeneous();
        assert!(
            (c * vertex).norm() < ROUNDING * c.norm() && (d * vertex).norm() < ROUNDING * d.norm(),
            "scene {scene}"
        );
        assert_eq!((c, d), (c.transpose(), d.transpose()), "scene {scene}");
    }
}

#[test]
fn silhouettes_from_the_dual_quadric_are_those_from_the_tangent_planes() {
    let mut random = Random::new(3);
    for scene in 0..SCENES {
        let cylinder = cylinder(&mut random);
        let distance = random.uniform(1.1, 20.0);
        let (camera, outward) = camera(&cylinder, distance, &mut random);
        let expected = cylinder.silhouette(&camera).expect("outside");
        let dual = cylinder.dual_quadric() * random.uniform(0.1, 10.0) * if scene % 2 == 0 { 1.0 } else { -1.0 };
        let lines = silhouette_of_dual_quadric(&dual, &cylinder.direction, &camera).expect("outside");
        // The quadric contains products of world coordinates, so its rounding is relative to them.
        let size = (cylinder.axis_point - Point3::origin()).norm() + camera.translation().norm();
        let tolerance = 1e-12 * (size / cylinder.radius).powi(2).max(1.0);
        for (line, expected) in lines.iter().zip(&expected) {
            assert!((line - expected).norm() < tolerance, "scene {scene}: {:e}", (line - expected).norm());
        }

        // The lines are on the dual conic, and pass through points of the surface at which the line
        // of sight is tangent.
        let rotation = camera.rotation();
        let projection =
            Matrix3x4::from_fn(
                |row, column| {
                    if column == 3 { camera.translation()[row] } else { rotation[(row, column)] }
                },
            );
        let conic = projection * cylinder.dual_quadric() * projection.transpose();
        let (cosine, sideways) = (1.0 / distance, cylinder.direction.cross(&outward));
        let sine = (1.0 - cosine * cosine).sqrt();
        for (line, side) in expected.iter().zip([1.0, -1.0]) {
            let value = line.dot(&(conic * line)).abs();
            let terms = cylinder.dual_quadric().norm() * projection.norm_squared();
            assert!(value < ROUNDING * terms, "scene {scene}: {value:e}");
            // The first line is the right one: `w x outward` points right for who looks inward with
            // `w` up.
            let contact = cylinder.axis_point + (outward * cosine + sideways * (side * sine)) * cylinder.radius;
            let image = rotation * contact.coords + camera.translation();
            assert!(line.dot(&image).abs() < ROUNDING * size.max(1.0), "scene {scene}: {:e}", line.dot(&image));
        }

        let inside = random.uniform(0.0, 0.99);
        let (inside, _) = self::camera(&cylinder, inside, &mut random);
        assert!(cylinder.silhouette(&inside).is_none(), "scene {scene}");
        assert!(silhouette_of_dual_quadric(&dual, &cylinder.direction, &inside).is_none(), "scene {scene}");
    }
}

#[test]
fn residuals_tell_the_side_and_on_which_side_of_the_silhouette_the_line_is() {
    let mut random = Random::new(4);
    for scene in 0..SCENES {
        let cylinder = cylinder(&mut random);
        let distance = random.uniform(1.1, 20.0);
        let (camera, outward) = camera(&cylinder, distance, &mut random);
        // A plane along the axis at `angle` to the plane through the axis, `angle` towards the
        // right of the camera.
        let angle = random.uniform(-1.0, 1.0) * FRAC_PI_2;
        let right = cylinder.direction.cross(&outward);
        let sight = right * angle.sin() - outward * angle.cos();
        let sign = if scene % 2 == 0 { 3.0 } else { -0.5 };
        let line = camera.rotation() * cylinder.direction.cross(&sight) * sign;
        let view = View::from_normalised_lines(camera, &[line]).expect("a line");
        let residual = cylinder.residuals(7, &view).expect("outside")[0];

        assert_eq!((residual.view, residual.line), (7, 0));
        assert_eq!(residual.side, if angle > 0.0 { Side::Right } else { Side::Left }, "scene {scene}");
        let expected = angle.abs() - (1.0 / distance).asin();
        assert!((residual.signed_angle() - expected).abs() < 1e-12, "scene {scene}: {residual:?}");
        let expected = cylinder.radius * (distance * angle.abs().sin() - 1.0);
        assert!((residual.distance - expected).abs() < 1e-12 * distance, "scene {scene}: {residual:?}");
    }
}
