//! The optional last step: minimises the distances between the given lines and the silhouettes over
//! all parameters of the cylinder at once, and estimates their uncertainty.
//!
//! ```text
//!   minimise  sum_i rho(|e_i|^2 / 2)   over the axis (4, orthonormal Plücker form) and the radius
//! ```
//!
//! with the distances `e_i` of two points of each line and the loss `rho`, by Levenberg-Marquardt
//! with the weights `rho'` (iteratively reweighted). The unit of the coordinates is the mean
//! distance of the cameras from the axis. Their origin is at that distance beside the part of the
//! axis that the lines see.

use nalgebra::{Matrix5, Point3, SMatrix, SVector, Unit, Vector3};
use thiserror::Error;

use super::plucker::OrthonormalLine;
use super::triangulate::is_single_viewpoint;
use crate::numerics::levenberg_marquardt::{LeastSquares, Linearised, minimise};
use crate::observations::copies::IndependentLines;
use crate::observations::view::View;
use crate::space::cylinder::Cylinder;
use crate::space::silhouette_distance::{CylinderTangent, MeasuredLine, Metric, MetricError};

/// Limit on the steps of Levenberg-Marquardt.
const STEPS: usize = 200;

/// The cylinder is not determined if the smallest eigenvalue of the normal matrix, with its
/// diagonal scaled to one, is at most this: some combination of parameters has less than a
/// millionth of the influence of each alone.
const UNDETERMINED: f64 = 1e-12;

/// The radius counts as zero if it is at most this, relative to the mean distance of the cameras
/// from the axis. It is far below what an image can show.
const NO_RADIUS: f64 = 1e-9;

/// Two estimates of one cylinder hardly differ by more than this number of standard deviations of
/// either.
const NEAR: f64 = 5.0;

/// Limit on the iterations for the eigenvalues of a 5x5 matrix.
const EIGEN_ITERATIONS: usize = 500;

/// The cost of a line as a function of the root mean square `d` of the distances of its two support
/// points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Loss {
    /// `d^2`.
    Quadratic,
    /// `d^2` up to `scale`, `2 scale d - scale^2` beyond it: the influence of a line is bounded.
    Huber {
        /// Scale of the loss, in the unit of the metric.
        scale: f64,
    },
    /// `scale^2 ln(1 + d^2 / scale^2)`: the influence of a line vanishes with its distance.
    Cauchy {
        /// Scale of the loss, in the unit of the metric.
        scale: f64,
    },
}

/// The cost that is minimised.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RefineOptions {
    /// How distances are measured.
    pub metric: Metric,
    /// The loss of the distances.
    pub loss: Loss,
}

/// A refined cylinder and its uncertainty.
#[derive(Clone, Debug, PartialEq)]
pub struct Refinement {
    /// The cylinder.
    pub cylinder: Cylinder,
    /// The point of the axis to which the uncertainty of its position refers. It is in the middle
    /// of the part that the lines see; world frame.
    pub reference: Point3<f64>,
    /// Unit vectors `f1`, `f2` across the axis.
    pub across: [Vector3<f64>; 2],
    /// Covariance of the local parameters
    ///
    /// ```text
    ///   (f1^T dw, f2^T dw, f1^T dA, f2^T dA, dr)
    /// ```
    ///
    /// with the direction `w` (radians), the point `A` of the axis at the reference and the radius
    /// `r`, in world units: `sigma^2 (J^T W J)^-1` with the variance `sigma^2` of a distance
    /// estimated from the residuals. This holds to first order. If the loss is not quadratic, the
    /// weights are held fixed, so the covariance is too small by the share of good lines whose
    /// weight is reduced.
    pub covariance: Matrix5<f64>,
    /// Standard deviations that follow from the covariance.
    pub deviation: Deviation,
    /// Root mean square distance of the support points, in the unit of the metric.
    pub rms: f64,
    /// Estimated standard deviation of the distance of a support point, in the unit of the metric:
    /// the root of the sum of squares over the degrees of freedom. It is larger than `rms`, because
    /// the cylinder adapts to the noise.
    pub noise: f64,
    /// Degrees of freedom of that estimate: twice the number of independent lines, minus five. If
    /// the loss is not quadratic, lines count with their weights.
    pub degrees_of_freedom: f64,
    /// Steps taken.
    pub iterations: usize,
}

impl Refinement {
    /// Whether another cylinder is the same within a few standard deviations.
    pub(crate) fn is_near(&self, other: &Cylinder) -> bool {
        let Deviation { direction, position, radius } = self.deviation;
        let apart = self.cylinder.vector_to_axis(&self.reference) - other.vector_to_axis(&self.reference);
        (self.cylinder.radius - other.radius).abs() <= NEAR * radius
            && apart.norm() <= NEAR * position
            && self.cylinder.direction.cross(&other.direction).norm() <= NEAR * direction
    }
}

/// Standard deviations of a cylinder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviation {
    /// Root mean square angle between estimated and true direction, radians.
    pub direction: f64,
    /// Root mean square distance between estimated and true axis at the reference, world units.
    pub position: f64,
    /// Standard deviation of the radius, world units.
    pub radius: f64,
}

/// Why there is no refined cylinder.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum RefineError {
    /// There are too few lines: each gives two numbers, and a cylinder has five parameters.
    #[error("{lines} silhouette line(s) given, copies counted once; a cylinder needs at least three")]
    TooFewLines {
        /// Number of independent lines.
        lines: usize,
    },
    /// The initial cylinder has a coordinate that is not finite, or a radius that is not positive.
    #[error("the cylinder to refine has a coordinate that is not finite, or a radius that is not positive")]
    NotACylinder,
    /// Distances cannot be measured.
    #[error(transparent)]
    Metric(#[from] MetricError),
    /// The scale of the loss is not a positive number.
    #[error("the scale of the loss must be a positive number (found {scale})")]
    LossScale {
        /// The value.
        scale: f64,
    },
    /// The radius would become zero: the lines are images of the axis, or do not belong to one
    /// cylinder.
    #[error("the lines fit best with a radius of zero: they are not silhouettes of one cylinder")]
    NoRadius,
    /// The initial cylinder, or the cylinder of least cost, contains a camera.
    #[error(
        "the cylinder that fits the lines best contains the camera of views[{view}]: the lines do not fit together"
    )]
    CameraInside {
        /// Index of the view.
        view: usize,
    },
    /// The lines do not determine a combination of the parameters.
    #[error("the lines do not determine the cylinder: their views are too similar; add a view from another place")]
    NotDetermined,
    /// The limit on the steps was reached, or numbers are out of range.
    #[error("the refinement did not converge in {iterations} steps")]
    NotConverged {
        /// Number of steps.
        iterations: usize,
    },
}

impl Loss {
    /// Loss `rho` and weight `rho'` of the squared distance `square`.
    fn value_and_weight(self, square: f64) -> (f64, f64) {
        match self {
            Self::Quadratic => (square, 1.0),
            Self::Huber { scale } if square <= scale * scale => (square, 1.0),
            Self::Huber { scale } => (2.0 * scale * square.sqrt() - scale * scale, scale / square.sqrt()),
            Self::Cauchy { scale } => {
                let ratio = square / (scale * scale);
                (scale * scale * ratio.ln_1p(), 1.0 / (1.0 + ratio))
            }
        }
    }

    fn check(self) -> Result<(), RefineError> {
        match self {
            Self::Huber { scale } | Self::Cauchy { scale } if !(scale > 0.0 && scale.is_finite()) => {
                Err(RefineError::LossScale { scale })
            }
            _ => Ok(()),
        }
    }
}

/// Refines a cylinder on the lines of all views. Copies of a line count as one line
/// ([`IndependentLines`]). The direction of the result has a canonical sign: its entry of largest
/// magnitude is positive.
///
/// # Errors
/// [`RefineError`].
pub fn refine(views: &[View], initial: &Cylinder, options: &RefineOptions) -> Result<Refinement, RefineError> {
    let lines = IndependentLines::of(views);
    if lines.given() >= 3 && is_single_viewpoint(views) {
        return Err(RefineError::NotDetermined);
    }
    refine_lines(&options.metric.measured(&lines)?, initial, options.loss)
}

/// Refines a cylinder on the given lines.
pub(crate) fn refine_lines(lines: &[MeasuredLine], initial: &Cylinder, loss: Loss) -> Result<Refinement, RefineError> {
    let Optimised { cylinder, iterations, converged } = optimise(lines, initial, loss, STEPS)?;
    if !converged {
        return Err(RefineError::NotConverged { iterations });
    }
    // The covariance refers to the direction with its final sign.
    let cylinder = cylinder.with_canonical_sign();
    // The frame is that of the result, because its position refers to the part of its own axis that
    // the lines see.
    let (frame, problem) = SilhouetteCost::of(lines, &cylinder, loss)?;
    let parameters = frame.parameters(&cylinder);
    let Uncertainty { covariance: local, noise, degrees_of_freedom } = problem.uncertainty(&parameters)?;

    // Maps steps in the frame to (dw, dA, dr) across the axis, in world units.
    let across = parameters.axis.across();
    let mut map = Matrix5::zeros();
    for (column, (d_direction, d_point, d_radius)) in parameters.tangents().into_iter().enumerate() {
        for (row, vector) in across.iter().enumerate() {
            map[(row, column)] = vector.dot(&d_direction);
            map[(row + 2, column)] = vector.dot(&d_point) * frame.unit;
        }
        map[(4, column)] = d_radius * frame.unit;
    }
    let covariance = map * local * map.transpose();
    let deviation = |from: usize, to: usize| (from..to).map(|index| covariance[(index, index)]).sum::<f64>().sqrt();
    let square: f64 =
        lines.iter().filter_map(|line| line.distance(&cylinder)).map(|distance| distance.mean_square()).sum();
    Ok(Refinement {
        cylinder,
        reference: frame.world_point(&parameters.axis.nearest()),
        across,
        covariance,
        deviation: Deviation { direction: deviation(0, 2), position: deviation(2, 4), radius: deviation(4, 5) },
        rms: (square / lines.len() as f64).sqrt(),
        noise,
        degrees_of_freedom,
        iterations,
    })
}

/// The state in which Levenberg-Marquardt ended.
pub(crate) struct Optimised {
    pub(crate) cylinder: Cylinder,
    pub(crate) iterations: usize,
    pub(crate) converged: bool,
}

/// The optimum, or the cylinder that is reached after `limit` steps.
pub(crate) fn optimise(
    lines: &[MeasuredLine],
    initial: &Cylinder,
    loss: Loss,
    limit: usize,
) -> Result<Optimised, RefineError> {
    loss.check()?;
    if lines.len() < 3 {
        return Err(RefineError::TooFewLines { lines: lines.len() });
    }
    let Cylinder { axis_point, direction, radius } = initial;
    let finite = axis_point.iter().chain(direction.iter()).chain([radius]).all(|entry| entry.is_finite());
    if !finite || *radius <= 0.0 {
        return Err(RefineError::NotACylinder);
    }
    let (frame, problem) = SilhouetteCost::of(lines, initial, loss)?;
    let optimum = minimise(&problem, frame.parameters(initial), limit)?;
    if optimum.state.radius <= NO_RADIUS {
        return Err(RefineError::NoRadius);
    }
    let cylinder = frame.world_cylinder(&optimum.state.cylinder());
    Ok(Optimised { cylinder, iterations: optimum.iterations, converged: optimum.converged })
}

/// Coordinates `(X - origin) / unit`.
struct Frame {
    origin: Point3<f64>,
    unit: f64,
}

impl Frame {
    fn beside(cylinder: &Cylinder, lines: &[MeasuredLine]) -> Result<Self, RefineError> {
        let w = cylinder.direction.into_inner();
        let (mut heights, mut unit) = (Vec::with_capacity(lines.len()), 0.0);
        for of_view in lines.chunk_by(|a, b| a.view == b.view) {
            let MeasuredLine { view, centre, .. } = of_view[0];
            let silhouettes = of_view[0].silhouettes(cylinder).ok_or(RefineError::CameraInside { view })?;
            for line in of_view {
                let distance = line.distance_from(cylinder, &silhouettes);
                heights.push(w.dot(&(line.contact(&distance) - cylinder.axis_point)));
            }
            unit += cylinder.vector_to_axis(&centre).norm() * of_view.len() as f64 / lines.len() as f64;
        }
        // The median is used because the ray to a line that is not a silhouette may run along the
        // axis.
        heights.sort_by(f64::total_cmp);
        // The mean of the two middle heights does not depend on the sign of the direction.
        let median = (heights[(heights.len() - 1) / 2] + heights[heights.len() / 2]) / 2.0;
        let middle = cylinder.axis_point + w * median;
        let beside = w.cross(&Vector3::ith(w.iamin(), 1.0)).normalize();
        Ok(Self { origin: middle + beside * unit, unit })
    }

    fn parameters(&self, cylinder: &Cylinder) -> Parameters {
        let nearest = cylinder.vector_to_axis(&self.origin) / self.unit;
        Parameters { axis: OrthonormalLine::new(&nearest, &cylinder.direction), radius: cylinder.radius / self.unit }
    }

    fn world_point(&self, point: &Vector3<f64>) -> Point3<f64> {
        self.origin + point * self.unit
    }

    fn world_cylinder(&self, cylinder: &Cylinder) -> Cylinder {
        Cylinder::new(&self.world_point(&cylinder.axis_point.coords), cylinder.direction, cylinder.radius * self.unit)
    }
}

/// A cylinder in the coordinates of a frame.
#[derive(Clone, Copy, Debug)]
struct Parameters {
    axis: OrthonormalLine,
    radius: f64,
}

impl Parameters {
    fn cylinder(&self) -> Cylinder {
        Cylinder {
            axis_point: Point3::from(self.axis.nearest()),
            direction: Unit::new_normalize(self.axis.direction()),
            radius: self.radius,
        }
    }

    /// Derivatives by the five local parameters.
    fn tangents(&self) -> [CylinderTangent; 5] {
        let [first, second, third, fourth] =
            self.axis.tangents().map(|(d_direction, d_point)| (d_direction, d_point, 0.0));
        [first, second, third, fourth, (Vector3::zeros(), Vector3::zeros(), 1.0)]
    }
}

/// The cost of a cylinder.
struct SilhouetteCost {
    lines: Vec<MeasuredLine>,
    loss: Loss,
}

impl LeastSquares<5> for SilhouetteCost {
    type State = Parameters;
    type Error = RefineError;

    fn linearise(&self, parameters: &Parameters) -> Result<Linearised<5>, RefineError> {
        if parameters.radius <= 0.0 {
            return Err(RefineError::NoRadius);
        }
        let (cylinder, tangents) = (parameters.cylinder(), parameters.tangents());
        let mut sum: Linearised<5> =
            Linearised { cost: 0.0, gradient: SVector::zeros(), normal_matrix: SMatrix::zeros() };
        for of_view in self.lines.chunk_by(|a, b| a.view == b.view) {
            let view = of_view[0].view;
            let silhouettes = of_view[0].silhouettes(&cylinder).ok_or(RefineError::CameraInside { view })?;
            for line in of_view {
                let distance = line.distance_from(&cylinder, &silhouettes);
                let derivatives = line.derivatives(&cylinder, &distance, &tangents);
                let (cost, weight) = self.loss.value_and_weight(distance.mean_square());
                sum.cost += cost;
                for (row, derivative) in derivatives.iter().enumerate() {
                    let weighted = derivative * (weight / 2.0);
                    sum.gradient[row] += weighted.dot(&distance.distances);
                    for (column, other) in derivatives.iter().enumerate().take(row + 1) {
                        sum.normal_matrix[(row, column)] += weighted.dot(other);
                    }
                }
            }
        }
        sum.normal_matrix.fill_upper_triangle_with_lower_triangle();
        Ok(sum)
    }

    fn moved(&self, parameters: &Parameters, step: &SVector<f64, 5>) -> Parameters {
        let axis = parameters.axis.moved(&[step[0], step[1], step[2], step[3]]);
        Parameters { axis, radius: parameters.radius + step[4] }
    }
}

/// The uncertainty of the local parameters.
struct Uncertainty {
    covariance: Matrix5<f64>,
    noise: f64,
    degrees_of_freedom: f64,
}

impl SilhouetteCost {
    /// The cost of `lines` in a frame beside a cylinder.
    fn of(lines: &[MeasuredLine], cylinder: &Cylinder, loss: Loss) -> Result<(Frame, Self), RefineError> {
        let frame = Frame::beside(cylinder, lines)?;
        let lines = lines.iter().map(|line| line.in_frame(&frame.origin, frame.unit)).collect();
        Ok((frame, Self { lines, loss }))
    }

    /// Covariance of the local parameters at the optimum, and the noise from which it follows.
    fn uncertainty(&self, parameters: &Parameters) -> Result<Uncertainty, RefineError> {
        // The matrix is J^T W J / 2. Its diagonal is scaled to one, so that the test of the rank
        // does not depend on units.
        let normal_matrix = self.linearise(parameters)?.normal_matrix;
        let scale = normal_matrix.diagonal().map(|entry| 1.0 / entry.sqrt());
        let scaled = Matrix5::from_fn(|row, column| normal_matrix[(row, column)] * scale[row] * scale[column]);
        let eigen = scaled.try_symmetric_eigen(f64::EPSILON, EIGEN_ITERATIONS).ok_or(RefineError::NotDetermined)?;
        let determined = eigen.eigenvalues.iter().all(|&value| value > UNDETERMINED);
        let inverse = scaled.cholesky().filter(|_| determined).ok_or(RefineError::NotDetermined)?.inverse();

        let cylinder = parameters.cylinder();
        let (mut squares, mut count) = (0.0, 0.0);
        for distance in self.lines.iter().filter_map(|line| line.distance(&cylinder)) {
            let (_, weight) = self.loss.value_and_weight(distance.mean_square());
            squares += weight * distance.distances.norm_squared();
            count += 2.0 * weight;
        }
        // The loss may reduce the effective number of lines below the number of parameters.
        if count <= 5.0 {
            return Err(RefineError::NotDetermined);
        }
        let degrees_of_freedom = count - 5.0;
        let variance = squares / degrees_of_freedom;
        let unscaled = Matrix5::from_fn(|row, column| inverse[(row, column)] * scale[row] * scale[column]);
        Ok(Uncertainty { covariance: unscaled * (variance / 2.0), noise: variance.sqrt(), degrees_of_freedom })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::observations::view::{Calibration, Camera};
    use nalgebra::{Matrix3, Matrix3x4, Rotation3};

    /// Three views with skew and unequal focal lengths. Each has two lines a little off the
    /// silhouettes.
    fn example() -> (Vec<View>, Cylinder) {
        let direction = Unit::new_normalize(Vector3::new(0.2, 1.0, -0.3));
        let cylinder = Cylinder::new(&Point3::new(0.3, 0.1, -0.2), direction, 0.8);
        let calibration = Calibration::new(&Matrix3::new(900.0, 3.0, 500.0, 0.0, 950.0, 400.0, 0.0, 0.0, 1.0));
        let calibration = calibration.expect("a calibration");
        let view = |angle: f64| {
            let rotation = Rotation3::from_euler_angles(0.1 * angle, angle, 0.2).into_inner();
            let matrix = Matrix3x4::from_columns(&[
                rotation.column(0).into_owned(),
                rotation.column(1).into_owned(),
                rotation.column(2).into_owned(),
                Vector3::new(0.1, -0.2, 6.0),
            ]);
            let camera = Camera::from_normalised(&matrix).expect("a camera").with_calibration(calibration);
            let lines = cylinder.silhouette(&camera).expect("a silhouette");
            View::from_normalised_lines(camera, &lines.map(|line| line + Vector3::new(0.004, -0.01, 0.007)))
        };
        let views = [0.0, 1.1, 2.5].map(view).into_iter().collect::<Result<_, _>>().expect("views");
        (views, cylinder)
    }

    #[test]
    fn the_jacobian_is_the_derivative() {
        let (views, cylinder) = example();
        for unit in [crate::DistanceUnit::Pixels, crate::DistanceUnit::Radians] {
            let metric = Metric { unit, ..Metric::of(&views) };
            let lines = metric.measured_lines(&views).expect("lines");
            let (frame, problem) = SilhouetteCost::of(&lines, &cylinder, Loss::Quadratic).expect("a frame");
            let parameters = frame.parameters(&cylinder);
            for line in &problem.lines {
                let model = parameters.cylinder();
                let distance = line.distance(&model).expect("a camera outside");
                let derivatives = line.derivatives(&model, &distance, &parameters.tangents());
                for (index, found) in derivatives.into_iter().enumerate() {
                    let step = 1e-5;
                    let at = |sign: f64| {
                        let mut theta = SVector::zeros();
                        theta[index] = sign * step;
                        line.distance(&problem.moved(&parameters, &theta).cylinder()).expect("outside").distances
                    };
                    let expected = (at(1.0) - at(-1.0)) / (2.0 * step);
                    let size = problem.linearise(&parameters).expect("a cost").normal_matrix.amax().sqrt();
                    assert!((found - expected).norm() < 1e-8 * size, "{unit:?}, {index}: {found} {expected}");
                }
            }
        }
    }

    #[test]
    fn weights_are_the_derivatives_of_losses() {
        for loss in [Loss::Quadratic, Loss::Huber { scale: 1.5 }, Loss::Cauchy { scale: 1.5 }] {
            for square in [0.0, 0.1, 2.0, 2.5, 40.0] {
                let (value, weight) = loss.value_and_weight(square);
                let step = 1e-6;
                let ahead = loss.value_and_weight(square + step).0;
                assert!(((ahead - value) / step - weight).abs() < 1e-5, "{loss:?} at {square}");
            }
        }
    }
}
