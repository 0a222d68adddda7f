//! Two cameras with unknown radial distortion, from points in both images.

use eliminant_generator::instance::Random;
use nalgebra::{Matrix3, Vector2, Vector3};

use super::cameras::{distorted, image, two_cameras};
use super::{KnownInstance, Maker, largest_relative_error, solved, uniform};

pub(super) fn makers() -> Vec<Maker> {
    let error = |_: &[f64], solution: &[f64], truth: &[f64]| largest_relative_error(solution, truth);
    let maker = |name, make| Maker { name, make, error };
    vec![
        maker("fundamental_8pt_radial", fundamental_eight_points),
        maker("fundamental_8pt_radial_one_side", fundamental_eight_points_one_side),
        maker("fundamental_9pt_two_radials", fundamental_nine_points),
        maker("relpose_7pt_focal_radial_one_side", seven_points_one_side),
        maker("relpose_7pt_focal_radial_one_side_eliminated", seven_points_one_side_eliminated),
    ]
}

/// Two cameras and the distorted images of points.
struct Views {
    /// x2^T F x1 = 0 for the undistorted images, f33 = 1.
    fundamental: Matrix3<f64>,
    points: Vec<Correspondence>,
}

/// The distorted images (a, b) and (c, d) of a point, and the squares of their norms.
struct Correspondence {
    a: f64,
    b: f64,
    first: f64,
    c: f64,
    d: f64,
    second: f64,
}

impl Views {
    /// Two cameras with these focal lengths and distortions, of which each sees so many points.
    fn draw(random: &mut Random, count: usize, focal: [f64; 2], radials: [f64; 2]) -> Self {
        let (rotation, translation, points) = two_cameras(random, count);
        let correspondence = |x: &Vector3<f64>| {
            let first: Vector2<f64> = distorted(image(x, focal[0]), radials[0]);
            let second: Vector2<f64> = distorted(image(&(rotation * x + translation), focal[1]), radials[1]);
            let ([a, b], [c, d]) = (first.into(), second.into());
            Correspondence { a, b, first: first.norm_squared(), c, d, second: second.norm_squared() }
        };
        let inverse = focal.map(|focal| Matrix3::from_diagonal(&Vector3::new(1.0 / focal, 1.0 / focal, 1.0)));
        let fundamental = inverse[1] * translation.cross_matrix() * rotation * inverse[0];
        Self { fundamental: fundamental / fundamental[(2, 2)], points: points.iter().map(correspondence).collect() }
    }

    /// leading unknowns = X others, row by row, where every point gives one equation (leading, others) . unknowns = 0.
    fn affine(&self, equation: impl Fn(&Correspondence) -> (Vec<f64>, Vec<f64>)) -> Vec<f64> {
        let (leading, others): (Vec<_>, Vec<_>) = self.points.iter().map(equation).unzip();
        let right: Vec<Vec<f64>> = others.iter().map(|row| row.iter().map(|x| -x).collect()).collect();
        solved(&leading, &right).concat()
    }
}

/// Barrel distortion.
fn radial(random: &mut Random) -> f64 {
    -uniform(random, 0.05, 0.5)
}

/// Image points of a norm of about 1 at most: what the cameras see is a sixth to a half of its distance wide.
fn focal(random: &mut Random) -> f64 {
    uniform(random, 2.0, 4.0)
}

fn fundamental_eight_points(random: &mut Random) -> KnownInstance {
    let (focal, radial) = ([focal(random), focal(random)], radial(random));
    let views = Views::draw(random, 8, focal, [radial; 2]);
    let data = views.affine(|&Correspondence { a, b, first, c, d, second }| {
        (
            vec![a * c, a * d, a, b * c, b * d, b, a * second, b * second],
            vec![c * first, d * first, first * second, c, d, first + second, 1.0],
        )
    });
    let f = views.fundamental;
    KnownInstance { data, truths: vec![vec![radial, f[(0, 2)], f[(1, 2)]]] }
}

fn fundamental_eight_points_one_side(random: &mut Random) -> KnownInstance {
    let (focal, radial) = ([focal(random), focal(random)], radial(random));
    let views = Views::draw(random, 8, focal, [0.0, radial]);
    let data = views.affine(|&Correspondence { a, b, c, d, second, .. }| {
        (vec![a * c, a * d, a, b * c, b * d, c, d, a * second], vec![b * second, second, b, 1.0])
    });
    KnownInstance { data, truths: vec![vec![views.fundamental[(2, 1)], radial]] }
}

fn seven_points_one_side_eliminated(random: &mut Random) -> KnownInstance {
    let (focal, radial) = (focal(random), radial(random));
    let views = Views::draw(random, 7, [focal, 1.0], [radial, 0.0]);
    let data = views.affine(|&Correspondence { a, b, first, c, d, .. }| {
        (vec![c * first, a * c, a * d, a, b * c, b * d, b], vec![d * first, c, d, first, 1.0])
    });
    let f = views.fundamental;
    KnownInstance { data, truths: vec![vec![f[(0, 2)], f[(1, 2)], radial]] }
}

fn fundamental_nine_points(random: &mut Random) -> KnownInstance {
    let (focal, s, t) = ([focal(random), focal(random)], radial(random), radial(random));
    let views = Views::draw(random, 9, focal, [t, s]);
    let data = views.affine(|&Correspondence { a, b, first, c, d, second }| {
        (
            vec![c * a, c * b, d * a, d * b, first, c, c * first, d * first, first * second],
            vec![a * second, b * second, second, a, b, d, 1.0],
        )
    });
    let f = views.fundamental;
    KnownInstance { data, truths: vec![vec![s, f[(2, 0)], f[(2, 1)], f[(1, 2)]]] }
}

/// The problem states x1^T F x2 = 0.
fn seven_points_one_side(random: &mut Random) -> KnownInstance {
    let (focal, radial) = (focal(random), radial(random));
    let views = Views::draw(random, 7, [focal, 1.0], [radial, 0.0]);
    let data = views.affine(|&Correspondence { a, b, first, c, d, .. }| {
        (vec![a * c, b * c, a * d, b * d, a, b, c], vec![c * first, d, d * first, first, 1.0])
    });
    let f = views.fundamental.transpose();
    KnownInstance { data, truths: vec![vec![1.0 / (focal * focal), f[(2, 0)], f[(2, 1)], radial]] }
}
