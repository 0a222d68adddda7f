//! Poses of least squares: in the loop on truncated Sampson errors, at the end on a loss that fits
//! the noise.
//!
//! The rotation is moved by a rotation vector, the translation within its tangent plane: five
//! numbers, which are zero at the start.

use inlier::core::{LocalOptimizer, Scoring};
use inlier::types::DataMatrix;
use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt};
use nalgebra::storage::Owned;
use nalgebra::{DVector, Dyn, Matrix3, Matrix3x2, OMatrix, Rotation3, U5, Unit, Vector3, Vector5};

use crate::noise::Noise;
use crate::pose::{Pose, in_front};
use crate::score::{Msac, Score, within};

/// A fit in the loop takes correspondences within this multiple of the threshold, and the last ones
/// within the second: some enter while the pose moves.
const REACH: f64 = 2.2;
const LAST_REACH: f64 = 3.0;
/// Fits at the end, each for the noise at the pose before.
const LAST_FITS: usize = 2;

/// What an error, in thresholds, counts.
#[derive(Clone, Debug)]
enum Loss {
    /// Its square, and at most one: the cost of the loop.
    Truncated,
    /// The negative logarithm of its density.
    Noise(Noise),
}

impl Loss {
    /// The number whose square is the loss, and its derivative.
    fn root(&self, index: usize, error: f64) -> (f64, f64) {
        match self {
            Self::Truncated if error.abs() < 1.0 => (error, 1.0),
            Self::Truncated => (error.signum(), 0.0),
            Self::Noise(noise) => noise.root(index, error),
        }
    }
}

/// The local optimisation of the loop.
pub struct LocalFit<'a>(pub &'a Msac);

impl LocalOptimizer<Matrix3<f64>, Score> for LocalFit<'_> {
    fn run(
        &mut self,
        data: &DataMatrix,
        inliers: &[usize],
        model: &Matrix3<f64>,
        best_score: &Score,
    ) -> (Matrix3<f64>, Score, Vec<usize>) {
        let unchanged = (*model, *best_score, inliers.to_vec());
        let Some(pose) = Pose::from_essential(model, data, inliers) else { return unchanged };
        let threshold = self.0.threshold();
        let points = points(data, &pose, REACH * threshold);
        let essential = fit(pose, &points, threshold, Loss::Truncated).essential();
        let mut inliers = Vec::new();
        let score = self.0.score(data, &essential, &mut inliers);
        (essential, score, inliers)
    }
}

/// The pose that fits the noise best, near a pose that is good already.
pub fn last_fit(mut pose: Pose, data: &DataMatrix, threshold: f64) -> Pose {
    for _ in 0..LAST_FITS {
        let mut points = points(data, &pose, LAST_REACH * threshold);
        // Wrong correspondences have any parallax, right ones those of the scene.
        points.sort_by(|a, b| parallax(&pose, a).total_cmp(&parallax(&pose, b)));
        let errors = Fit::new(pose, &points, threshold, Loss::Truncated).errors();
        pose = fit(pose, &points, threshold, Loss::Noise(Noise::of(&errors, LAST_REACH)));
    }
    pose
}

/// The standard deviations of the angles of rotation and translation, in degrees, that least
/// squares has on these correspondences at a focal length of one, with noise of this standard
/// deviation: roots of traces of the covariance.
pub fn deviations(pose: &Pose, points: &[[f64; 4]], noise: f64) -> Option<[f64; 2]> {
    let jacobian = Fit::new(*pose, points, 1.0, Loss::Truncated).jacobian()?;
    let covariance = (jacobian.tr_mul(&jacobian)).try_inverse()? * noise.powi(2);
    let traces = [covariance.fixed_view::<3, 3>(0, 0).trace(), covariance.fixed_view::<2, 2>(3, 3).trace()];
    Some(traces.map(|trace| trace.sqrt().to_degrees()))
}

/// The square of the sine of the angle between the rays to a point.
fn parallax(pose: &Pose, &[a, b, c, d]: &[f64; 4]) -> f64 {
    let (first, second) = (pose.rotation * Vector3::new(a, b, 1.0), Vector3::new(c, d, 1.0));
    first.cross(&second).norm_squared() / (first.norm_squared() * second.norm_squared())
}

/// The correspondences with Sampson errors below the reach that are in front of both cameras.
fn points(data: &DataMatrix, pose: &Pose, reach: f64) -> Vec<[f64; 4]> {
    let essential = pose.essential();
    let rows = within(data, &essential, reach).filter(|&row| in_front(pose, data, row));
    rows.map(|row| [0, 1, 2, 3].map(|column| data[(row, column)])).collect()
}

fn fit(pose: Pose, points: &[[f64; 4]], threshold: f64, loss: Loss) -> Pose {
    if points.len() < 5 {
        return pose;
    }
    let least_squares = LevenbergMarquardt::new().with_ftol(1e-8).with_xtol(1e-8).with_gtol(1e-8).with_patience(4);
    least_squares.minimize(Fit::new(pose, points, threshold, loss)).0.pose()
}

/// The problem of least squares.
struct Fit<'a> {
    start: Pose,
    tangent: Matrix3x2<f64>,
    parameters: Vector5<f64>,
    points: &'a [[f64; 4]],
    threshold: f64,
    loss: Loss,
}

impl<'a> Fit<'a> {
    fn new(start: Pose, points: &'a [[f64; 4]], threshold: f64, loss: Loss) -> Self {
        let normal = start.translation.into_inner();
        let first = Unit::new_normalize(normal.cross(&Vector3::ith(normal.iamin(), 1.0))).into_inner();
        let tangent = Matrix3x2::from_columns(&[first, normal.cross(&first)]);
        Self { start, tangent, parameters: Vector5::zeros(), points, threshold, loss }
    }

    fn pose(&self) -> Pose {
        let p = &self.parameters;
        let rotation = Rotation3::new(p.fixed_rows::<3>(0).into_owned()) * self.start.rotation;
        let translation = Unit::new_normalize(*self.start.translation + self.tangent * p.fixed_rows::<2>(3));
        Pose { rotation, translation }
    }

    /// The derivatives of the essential matrix by the parameters.
    fn essential_derivatives(&self) -> [Matrix3<f64>; 5] {
        let pose = self.pose();
        let turn = left_jacobian(&self.parameters.fixed_rows::<3>(0).into_owned());
        let moved = *self.start.translation + self.tangent * self.parameters.fixed_rows::<2>(3);
        let t = pose.translation.into_inner();
        let aside = (Matrix3::identity() - t * t.transpose()) * self.tangent / moved.norm();
        let of_rotation = |k: usize| {
            pose.translation.cross_matrix() * turn.column(k).into_owned().cross_matrix() * pose.rotation.matrix()
        };
        let of_translation = |k: usize| aside.column(k).into_owned().cross_matrix() * pose.rotation.matrix();
        [of_rotation(0), of_rotation(1), of_rotation(2), of_translation(0), of_translation(1)]
    }

    /// Sampson errors, with sign, in thresholds.
    fn errors(&self) -> Vec<f64> {
        let essential = self.pose().essential();
        self.points.iter().map(|point| Sampson::new(&essential, point).error / self.threshold).collect()
    }
}

impl LeastSquaresProblem<f64, Dyn, U5> for Fit<'_> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, U5>;
    type ParameterStorage = Owned<f64, U5>;

    fn set_params(&mut self, parameters: &Vector5<f64>) {
        self.parameters = *parameters;
    }

    fn params(&self) -> Vector5<f64> {
        self.parameters
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        let errors = self.errors().into_iter().enumerate().map(|(row, error)| self.loss.root(row, error).0);
        Some(DVector::from_iterator(self.points.len(), errors))
    }

    fn jacobian(&self) -> Option<OMatrix<f64, Dyn, U5>> {
        let essential = self.pose().essential();
        let derivatives = self.essential_derivatives();
        let mut jacobian = OMatrix::<f64, Dyn, U5>::zeros(self.points.len());
        for (row, point) in self.points.iter().enumerate() {
            let sampson = Sampson::new(&essential, point);
            let gradient = sampson.gradient(point);
            let slope = self.loss.root(row, sampson.error / self.threshold).1 / self.threshold;
            for (column, derivative) in derivatives.iter().enumerate() {
                jacobian[(row, column)] = slope * gradient.dot(derivative);
            }
        }
        Some(jacobian)
    }
}

/// The Sampson error of a correspondence and what it is made of.
struct Sampson {
    error: f64,
    length: f64,
    line: Vector3<f64>,
    back: Vector3<f64>,
}

impl Sampson {
    #[inline(always)]
    fn new(essential: &Matrix3<f64>, &[a, b, c, d]: &[f64; 4]) -> Self {
        let (first, second) = (Vector3::new(a, b, 1.0), Vector3::new(c, d, 1.0));
        let (line, back) = (essential * first, essential.tr_mul(&second));
        let length = (line.xy().norm_squared() + back.xy().norm_squared()).sqrt();
        Self { error: second.dot(&line) / length, length, line, back }
    }

    /// The derivatives of the error by the elements of the essential matrix.
    #[inline(always)]
    fn gradient(&self, &[a, b, c, d]: &[f64; 4]) -> Matrix3<f64> {
        let (first, second) = (Vector3::new(a, b, 1.0), Vector3::new(c, d, 1.0));
        let relative = self.error / self.length;
        let line = Vector3::new(second.x - relative * self.line.x, second.y - relative * self.line.y, 1.0);
        let back = Vector3::new(self.back.x, self.back.y, 0.0) * relative;
        (line * first.transpose() - second * back.transpose()) / self.length
    }
}

/// The rotation vector by which a rotation turns further when its own rotation vector changes.
fn left_jacobian(vector: &Vector3<f64>) -> Matrix3<f64> {
    let (angle, cross) = (vector.norm(), vector.cross_matrix());
    let (first, second) = match angle < 1e-4 {
        true => (0.5, 1.0 / 6.0),
        false => ((1.0 - angle.cos()) / angle.powi(2), (angle - angle.sin()) / angle.powi(3)),
    };
    Matrix3::identity() + cross * first + cross * cross * second
}

#[cfg(test)]
mod tests {
    use levenberg_marquardt::differentiate_numerically;

    use super::*;

    #[test]
    fn derivatives_are_those_of_differences() {
        let points = [[0.1, 0.2, 0.15, 0.1], [-0.3, 0.1, -0.2, 0.15], [0.25, -0.3, 0.4, -0.2], [-0.1, -0.2, 0.0, -0.3]];
        let start = Pose {
            rotation: Rotation3::new(Vector3::new(0.1, -0.2, 0.05)),
            translation: Unit::new_normalize(Vector3::new(0.8, 0.1, -0.3)),
        };
        let noise = Noise { deviation: 0.4, outliers: vec![0.0, 0.01, 0.2, 3.0] };
        for loss in [Loss::Truncated, Loss::Noise(noise)] {
            let name = format!("{loss:?}");
            let mut problem = Fit::new(start, &points, 0.2, loss);
            for parameters in [Vector5::zeros(), Vector5::new(0.02, -0.1, 0.05, 0.1, -0.2)] {
                problem.set_params(&parameters);
                let expected = differentiate_numerically(&mut problem).unwrap();
                let error = (problem.jacobian().unwrap() - &expected).amax() / expected.amax();
                assert!(error < 1e-6, "{name}: {error}");
            }
        }
    }
}
