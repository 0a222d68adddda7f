//! Two solvers of the catalogue, emitted by the build script of this crate.
//!
//! The template of `pose_35pt_focal` is its own: of those with at most 12 basis monomials the one
//! with the fewest rows. The catalogue has another, which the default options find. In a copy of
//! the problem's folder it was found by
//!
//! ```sh
//! eliminant search pose_35pt_focal.rs --prefer size --max-basis 12
//! ```

eliminant::include_solver!("pose_35pt_focal");
eliminant::include_solver!("two_conics");

use std::error::Error;

/// The size of the eigenvalue problem that this crate asks for.
const BASIS: usize = 12;
const POINTS: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [1.0, 0.2, -0.3], [-0.4, 0.9, 0.5], [0.6, -0.7, 0.8]];
/// The camera turns by the quaternion (1, X, Y, 0), and then by the angle ROLL about its optical
/// axis.
const X: f64 = 0.3;
const Y: f64 = -0.2;
const ROLL: f64 = 0.7;
const TRANSLATION: [f64; 3] = [0.1, -0.3, 4.0];
const FOCAL_LENGTH: f64 = 1.4;
/// The images are rounded to some 1e-16; geometry makes that up to 10,000 times larger.
const TOLERANCE: f64 = 1e-12;

/// The rotation of the camera.
fn rotation() -> [[f64; 3]; 3] {
    let length = 1.0 + X * X + Y * Y;
    let tilt = [
        [1.0 + X * X - Y * Y, 2.0 * X * Y, 2.0 * Y],
        [2.0 * X * Y, 1.0 - X * X + Y * Y, -2.0 * X],
        [-2.0 * Y, 2.0 * X, 1.0 - X * X - Y * Y],
    ]
    .map(|row| row.map(|entry| entry / length));
    let (sin, cos) = ROLL.sin_cos();
    let across = [0, 1, 2].map(|k| cos * tilt[0][k] - sin * tilt[1][k]);
    let down = [0, 1, 2].map(|k| sin * tilt[0][k] + cos * tilt[1][k]);
    [across, down, tilt[2]]
}

/// The image of a point.
fn project(point: [f64; 3]) -> [f64; 2] {
    let turned = rotation().map(|row| row.iter().zip(point).map(|(a, b)| a * b).sum::<f64>());
    let [across, down, depth] = [0, 1, 2].map(|k| turned[k] + TRANSLATION[k]);
    [FOCAL_LENGTH * across / depth, FOCAL_LENGTH * down / depth]
}

/// Whether every number of a pose is that of the camera; one that is not a number is not.
fn is_of_camera(pose: &pose_35pt_focal::Pose) -> bool {
    let turned = pose.rotation.iter().flatten().zip(rotation().into_iter().flatten()).map(|(a, b)| a - b);
    let moved = pose.translation.iter().zip(TRANSLATION).map(|(a, b)| a - b);
    turned.chain(moved).chain([pose.focal - FOCAL_LENGTH]).all(|difference| difference.abs() < TOLERANCE)
}

/// Which pose has a camera of unknown focal length that sees four points there?
fn poses() -> Result<(), Box<dyn Error>> {
    let images = POINTS.map(project);
    let horizontal = images.map(|image| image[0]);
    let vertical = [images[0][1], images[1][1], images[2][1]];
    // By the template of the catalogue this array has another size.
    let action: [[f64; BASIS]; BASIS] = pose_35pt_focal::action_matrix(&POINTS, &horizontal, &vertical)?;
    let poses = pose_35pt_focal::solve_for_pose(&POINTS, &horizontal, &vertical)?;
    println!("{} poses, by the eigenvalues of a {BASIS} x {} matrix:", poses.len(), action[0].len());
    for pose in &poses {
        let [x, y, z] = pose.translation;
        println!("  focal length {:9.6}, translation {x:9.6}, {y:9.6}, {z:9.6}", pose.focal);
    }
    match poses.iter().any(is_of_camera) {
        true => Ok(()),
        false => Err("none of these is the pose of the camera".into()),
    }
}

/// Where does the circle x^2 + y^2 = 25 meet the hyperbola x y = 12?
fn points() -> Result<(), Box<dyn Error>> {
    let circle = [1.0, 0.0, 1.0, 0.0, 0.0, -25.0];
    let hyperbola = [0.0, 1.0, 0.0, 0.0, 0.0, -12.0];
    let solutions = two_conics::solve(&circle, &hyperbola)?;
    println!("{} points:", solutions.len());
    for expected in [[3.0, 4.0], [4.0, 3.0], [-3.0, -4.0], [-4.0, -3.0]] {
        let is_it = |point: &[f64; 2]| (point[0] - expected[0]).hypot(point[1] - expected[1]) < TOLERANCE;
        let found = solutions.iter().map(|point| [point.x, point.y]).find(is_it);
        let [x, y] = found.ok_or_else(|| format!("{expected:?} is missing"))?;
        println!("  x {x:9.6}, y {y:9.6}");
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    poses()?;
    points()
}
