//! Two cameras with unknown radial distortion, from points in both images.

use eliminant_generator::algebra::Random;
use nalgebra::{Matrix3, Rotation3, Vector2, Vector3};

use super::cameras::{Motion, distorted, image, two_cameras};
use super::{
    KnownInstance, Make, Maker, coordinates, largest_relative_error, projective_error, solved, uniform, vector,
};

pub(super) fn makers() -> Vec<Maker> {
    let largest: fn(&[f64], &[f64], &[f64]) -> f64 = |_, solution, truth| largest_relative_error(solution, truth);
    let maker = |name, make, error| Maker { name, make: Make::TwoCameras(make), error };
    vec![
        maker("fundamental_8pt_radial", fundamental_eight_points, projective::<1, 3>),
        maker("fundamental_8pt_radial_one_side", fundamental_eight_points_one_side, with_one::<0, 2>),
        maker("fundamental_9pt_two_radials", fundamental_nine_points, with_one::<1, 4>),
        maker("relpose_6pt_radial", six_points, with_one::<0, 3>),
        maker("relpose_7pt_focal_radial", seven_points, largest),
        maker("relpose_7pt_focal_radial_one_side", seven_points_one_side, projective::<1, 3>),
        maker("relpose_7pt_focal_radial_one_side_eliminated", seven_points_one_side_eliminated, projective::<0, 2>),
    ]
}

/// The error of the unknowns FIRST..END, a vector up to scale, and of each of the others.
fn projective<const FIRST: usize, const END: usize>(_: &[f64], solution: &[f64], truth: &[f64]) -> f64 {
    error_with::<FIRST, END>(vector, solution, truth)
}

/// The same where the other entry of the vector is 1.
fn with_one<const FIRST: usize, const END: usize>(_: &[f64], solution: &[f64], truth: &[f64]) -> f64 {
    error_with::<FIRST, END>(|unknowns| [unknowns, &[1.0]].concat(), solution, truth)
}

fn error_with<const FIRST: usize, const END: usize>(
    vector: fn(&[f64]) -> Vec<f64>,
    solution: &[f64],
    truth: &[f64],
) -> f64 {
    let [own, known] = [solution, truth].map(|x| vector(&x[FIRST..END]));
    let others = |x: &[f64]| [&x[..FIRST], &x[END..]].concat();
    projective_error(&own, &known).max(largest_relative_error(&others(solution), &others(truth)))
}

/// Two cameras and the distorted images of points.
struct Views {
    /// x2^T F x1 = 0 for the undistorted images.
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
    fn draw((random, motion): (&mut Random, Motion), count: usize, focal: [f64; 2], radials: [f64; 2]) -> Self {
        let (rotation, translation, points) = two_cameras((random, motion), count);
        let correspondence = |x: &Vector3<f64>| {
            let first: Vector2<f64> = distorted(image(x, focal[0]), radials[0]);
            let second: Vector2<f64> = distorted(image(&(rotation * x + translation), focal[1]), radials[1]);
            let ([a, b], [c, d]) = (first.into(), second.into());
            Correspondence { a, b, first: first.norm_squared(), c, d, second: second.norm_squared() }
        };
        let inverse = focal.map(|focal| Matrix3::from_diagonal(&Vector3::new(1.0 / focal, 1.0 / focal, 1.0)));
        let fundamental = inverse[1] * translation.cross_matrix() * rotation * inverse[0];
        Self { fundamental, points: points.iter().map(correspondence).collect() }
    }

    /// The first camera as the second, and the second as the first.
    fn exchanged(&self) -> Self {
        let exchange = |&Correspondence { a, b, first, c, d, second }: &Correspondence| Correspondence {
            a: c,
            b: d,
            first: second,
            c: a,
            d: b,
            second: first,
        };
        Self { fundamental: self.fundamental.transpose(), points: self.points.iter().map(exchange).collect() }
    }

    /// The first image turned about its centre.
    fn turned(&self, angle: f64) -> Self {
        let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), angle).into_inner();
        let turn_point = |point: &Correspondence| {
            let turned = turn * Vector3::new(point.a, point.b, 0.0);
            Correspondence { a: turned.x, b: turned.y, ..*point }
        };
        Self { fundamental: self.fundamental * turn.transpose(), points: self.points.iter().map(turn_point).collect() }
    }

    /// F with f23 = 1 where the second image is turned.
    fn with_second_turned(&self) -> Matrix3<f64> {
        let turned = self.exchanged().turned(TURN).exchanged().fundamental;
        turned / turned[(1, 2)]
    }

    /// The points of the first image, then those of the second.
    fn images(&self) -> Vec<f64> {
        let first = self.points.iter().flat_map(|point| [point.a, point.b]);
        first.chain(self.points.iter().flat_map(|point| [point.c, point.d])).collect()
    }

    /// leading unknowns = X others, row by row, where every point gives one equation (leading,
    /// others) . unknowns = 0.
    fn affine(&self, equation: impl Fn(&Correspondence) -> (Vec<f64>, Vec<f64>)) -> Vec<f64> {
        let (leading, others): (Vec<_>, Vec<_>) = self.points.iter().map(equation).unzip();
        let right: Vec<Vec<f64>> = others.iter().map(|row| row.iter().map(|x| -x).collect()).collect();
        solved(&leading, &right).concat()
    }
}

/// By how much solvers turn an image whatever its points are: (5, 12) / 13 becomes (1, 0).
const TURN: f64 = -1.176_005_207_095_135_2;

/// Barrel distortion.
fn radial(random: &mut Random, motion: Motion) -> f64 {
    let radial = -uniform(random, 0.05, 0.5);
    if motion == Motion::Undistorted { 0.0 } else { radial }
}

/// Image points of a norm of about 1 at most: what the cameras see is a sixth to a half of its
/// distance wide.
fn focal(random: &mut Random) -> f64 {
    uniform(random, 2.0, 4.0)
}

fn fundamental_eight_points(random: &mut Random, motion: Motion) -> KnownInstance {
    let (focal, radial) = ([focal(random), focal(random)], radial(random, motion));
    let views = Views::draw((random, motion), 8, focal, [radial; 2]);
    let third = coordinates(views.fundamental.column(2).as_slice());
    KnownInstance { data: views.images(), truths: vec![[vec![radial], third].concat()] }
}

fn fundamental_eight_points_one_side(random: &mut Random, motion: Motion) -> KnownInstance {
    let (focal, radial) = ([focal(random), focal(random)], radial(random, motion));
    let views = Views::draw((random, motion), 8, focal, [0.0, radial]);
    let f = views.exchanged().with_second_turned();
    KnownInstance { data: views.images(), truths: vec![vec![f[(0, 2)], f[(2, 2)], radial]] }
}

fn seven_points_one_side_eliminated(random: &mut Random, motion: Motion) -> KnownInstance {
    let (focal, radial) = (focal(random), radial(random, motion));
    let views = Views::draw((random, motion), 7, [focal, 1.0], [radial, 0.0]);
    let third = coordinates(views.fundamental.column(2).as_slice());
    KnownInstance { data: views.images(), truths: vec![[third, vec![radial]].concat()] }
}

fn fundamental_nine_points(random: &mut Random, motion: Motion) -> KnownInstance {
    let (focal, s, t) = ([focal(random), focal(random)], radial(random, motion), radial(random, motion));
    let views = Views::draw((random, motion), 9, focal, [t, s]);
    let f = views.with_second_turned();
    KnownInstance { data: views.images(), truths: vec![vec![s, f[(2, 0)], f[(2, 1)], f[(2, 2)]]] }
}

/// A solver takes its pick of which image is the first, and how the second one is turned: of eight
/// choices that with the smallest combinations.
fn chosen(views: &Views, equation: impl Fn(&Correspondence) -> (Vec<f64>, Vec<f64>)) -> Views {
    let choices = [views.exchanged(), views.exchanged().exchanged()].into_iter().flat_map(|exchanged| {
        let turns: [[f64; 2]; 4] = [[1.0, 0.0], [0.8, 0.6], [0.0, 1.0], [-0.8, 0.6]];
        turns.map(|[cos, sin]| exchanged.turned(-sin.atan2(cos)).exchanged())
    });
    let squares = |views: &Views| views.affine(&equation).iter().map(|x| x * x).sum::<f64>();
    choices.min_by(|a, b| squares(a).total_cmp(&squares(b))).expect("one of eight")
}

fn six_points(random: &mut Random, motion: Motion) -> KnownInstance {
    let radial = radial(random, motion);
    let views = Views::draw((random, motion), 6, [1.0; 2], [radial; 2]);
    let chosen = chosen(&views, |&Correspondence { a, b, first, c, d, second }: &Correspondence| {
        (
            vec![a * c, b * c, a * d, b * d, c * first, c],
            vec![d, d * first, a, a * second, b, b * second, first * second, first + second, 1.0],
        )
    });
    let transposed = chosen.turned(TURN).fundamental.transpose();
    let e = transposed / transposed[(1, 2)];
    KnownInstance { data: views.images(), truths: vec![vec![e[(0, 2)], e[(2, 1)], e[(2, 2)], radial]] }
}

fn seven_points(random: &mut Random, motion: Motion) -> KnownInstance {
    let (focal, radial) = (focal(random), radial(random, motion));
    let views = Views::draw((random, motion), 7, [focal; 2], [radial; 2]);
    let equation = |&Correspondence { a, b, first, c, d, second }: &Correspondence| {
        (
            vec![a * c, b * c, a * d, b * d, c * first, first * second, c],
            vec![d, d * first, a, a * second, b, b * second, first + second, 1.0],
        )
    };
    let chosen = chosen(&views, equation);
    // The solver turns the first image, and chooses the unit of the distortion, so that f31 =
    // radial f13 + 0 radial f23 + ...
    let f31 = &chosen.affine(equation)[6 * 8..];
    let (x, y) = (f31[3], f31[5]);
    let (own, unit) = (chosen.turned(-y.atan2(x)), x.hypot(y));
    let f = own.fundamental.transpose() / own.fundamental[(2, 2)];
    let truth = vec![1.0 / (focal * focal), f[(2, 1)], f[(0, 2)], f[(1, 2)], radial * unit];
    KnownInstance { data: views.images(), truths: vec![truth] }
}

/// The problem states x1^T F x2 = 0.
fn seven_points_one_side(random: &mut Random, motion: Motion) -> KnownInstance {
    let (focal, radial) = (focal(random), radial(random, motion));
    let views = Views::draw((random, motion), 7, [focal, 1.0], [radial, 0.0]);
    let third = coordinates(views.fundamental.column(2).as_slice());
    KnownInstance { data: views.images(), truths: vec![[vec![1.0 / (focal * focal)], third, vec![radial]].concat()] }
}
