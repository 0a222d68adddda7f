//! The sum of squared distances of lines from the silhouettes of a cylinder, as a function of five
//! local parameters, and their uncertainty at the optimum.

use nalgebra::{Matrix2, Matrix5, Point3, SMatrix, SVector, Unit, Vector3};

use super::loss::Loss;
use super::plucker::OrthonormalLine;
use super::refine_error::RefineError;
use crate::numerics::levenberg_marquardt::{LeastSquares, Linearised};
use crate::space::cylinder::Cylinder;
use crate::space::silhouette_distance::{CylinderTangent, MeasuredLine};

/// The cylinder is not determined if the smallest eigenvalue of the normal matrix, with its
/// diagonal scaled to one, is at most this: some combination of parameters has less than a
/// millionth of the influence of each alone.
const UNDETERMINED: f64 = 1e-12;

/// Limit on the iterations for the eigenvalues of a 5x5 matrix.
const EIGEN_ITERATIONS: usize = 500;

/// The scatter of fewer lines is taken as the same for all.
const ENOUGH_LINES: usize = 20;

/// Coordinates `(X - origin) / unit`.
pub(super) struct Frame {
    origin: Point3<f64>,
    pub(super) unit: f64,
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

    pub(super) fn parameters(&self, cylinder: &Cylinder) -> Parameters {
        let nearest = cylinder.vector_to_axis(&self.origin) / self.unit;
        Parameters { axis: OrthonormalLine::new(&nearest, &cylinder.direction), radius: cylinder.radius / self.unit }
    }

    pub(super) fn world_point(&self, point: &Vector3<f64>) -> Point3<f64> {
        self.origin + point * self.unit
    }

    pub(super) fn world_cylinder(&self, cylinder: &Cylinder) -> Cylinder {
        Cylinder::new(&self.world_point(&cylinder.axis_point.coords), cylinder.direction, cylinder.radius * self.unit)
    }
}

/// A cylinder in the coordinates of a frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct Parameters {
    pub(super) axis: OrthonormalLine,
    pub(super) radius: f64,
}

impl Parameters {
    pub(super) fn cylinder(&self) -> Cylinder {
        Cylinder {
            axis_point: Point3::from(self.axis.nearest()),
            direction: Unit::new_normalize(self.axis.direction()),
            radius: self.radius,
        }
    }

    /// Derivatives by the five local parameters.
    pub(super) fn tangents(&self) -> [CylinderTangent; 5] {
        let [first, second, third, fourth] =
            self.axis.tangents().map(|(d_direction, d_point)| (d_direction, d_point, 0.0));
        [first, second, third, fourth, (Vector3::zeros(), Vector3::zeros(), 1.0)]
    }
}

/// The cost of a cylinder.
pub(super) struct SilhouetteCost {
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
pub(super) struct Uncertainty {
    pub(super) covariance: Matrix5<f64>,
    pub(super) noise: f64,
    pub(super) degrees_of_freedom: f64,
}

impl SilhouetteCost {
    /// The cost of `lines` in a frame beside a cylinder.
    pub(super) fn of(lines: &[MeasuredLine], cylinder: &Cylinder, loss: Loss) -> Result<(Frame, Self), RefineError> {
        let frame = Frame::beside(cylinder, lines)?;
        let lines = lines.iter().map(|line| line.in_frame(&frame.origin, frame.unit)).collect();
        Ok((frame, Self { lines, loss }))
    }

    /// Covariance of the local parameters at the optimum, and the noise.
    ///
    /// If all lines have end points, the distances of the points are independent with one variance,
    /// and the covariance is `sigma^2 (J^T W J)^-1`. Without end points it is not known where a
    /// line was seen, nor therefore how the errors of its two support points are related. The
    /// covariance then follows from the scatter of the lines, whatever it is (the sandwich estimate
    /// with the leverages of each line taken out; MacKinnon & White, "Some
    /// heteroskedasticity-consistent covariance matrix estimators", 1985, HC3). Few lines have a
    /// common scatter instead:
    ///
    /// ```text
    ///   H^-1 (sum_i g_i g_i^T) H^-1,    g_i = J_i^T W_i (I - J_i H^-1 J_i^T W_i)^-1 e_i
    /// ```
    pub(super) fn uncertainty(&self, parameters: &Parameters) -> Result<Uncertainty, RefineError> {
        // The matrix is J^T W J / 2. Its diagonal is scaled to one, so that the test of the rank
        // does not depend on units.
        let normal_matrix = self.linearise(parameters)?.normal_matrix;
        let scale = normal_matrix.diagonal().map(|entry| 1.0 / entry.sqrt());
        let scaled = Matrix5::from_fn(|row, column| normal_matrix[(row, column)] * scale[row] * scale[column]);
        let eigen = scaled.try_symmetric_eigen(f64::EPSILON, EIGEN_ITERATIONS).ok_or(RefineError::NotDetermined)?;
        let determined = eigen.eigenvalues.iter().all(|&value| value > UNDETERMINED);
        let inverse = scaled.cholesky().filter(|_| determined).ok_or(RefineError::NotDetermined)?.inverse();
        // (J^T W J)^-1
        let inverse = Matrix5::from_fn(|row, column| inverse[(row, column)] * scale[row] * scale[column] / 2.0);

        let cylinder = parameters.cylinder();
        let (mut squares, mut count) = (0.0, 0.0);
        for distance in self.lines.iter().filter_map(|line| line.distance(&cylinder)) {
            let (_, weight) = self.loss.value_and_weight(distance.mean_square());
            squares += weight * distance.distances.norm_squared();
            count += 2.0 * weight;
        }
        // The loss may reduce the effective number of lines below the number of parameters.
        let degrees_of_freedom = count - 5.0;
        if degrees_of_freedom <= 0.0 {
            return Err(RefineError::NotDetermined);
        }
        let variance = squares / degrees_of_freedom;
        let scatter = match self.lines.iter().all(|line| line.has_ends) {
            true => None,
            false if self.lines.len() >= ENOUGH_LINES => self.scatter(parameters, &inverse),
            false => self.common_scatter(parameters),
        };
        let covariance = scatter.map_or(inverse * variance, |scatter| inverse * scatter * inverse);
        Ok(Uncertainty { covariance, noise: variance.sqrt(), degrees_of_freedom })
    }

    /// The sum of `J_i^T S J_i` with the covariance `S` of the two distances of a line, taken as
    /// the same for all lines. The first support point is the one further along the axis.
    fn common_scatter(&self, parameters: &Parameters) -> Option<Matrix5<f64>> {
        let (cylinder, tangents) = (parameters.cylinder(), parameters.tangents());
        let swap = Matrix2::new(0.0, 1.0, 1.0, 0.0);
        let (mut covariance, mut jacobians) = (Matrix2::zeros(), Vec::with_capacity(self.lines.len()));
        for line in &self.lines {
            let distance = line.distance(&cylinder)?;
            let derivatives = line.derivatives(&cylinder, &distance, &tangents);
            let weight = self.loss.value_and_weight(distance.mean_square()).1.sqrt();
            let order = if line.is_along(&cylinder) { Matrix2::identity() } else { swap };
            let residual = order * distance.distances * weight;
            covariance += residual * residual.transpose();
            jacobians.push(order * SMatrix::<f64, 2, 5>::from_columns(&derivatives) * weight);
        }
        let freedom = self.lines.len() as f64 - 2.5;
        let covariance = covariance / freedom;
        Some(jacobians.iter().map(|jacobian| jacobian.transpose() * covariance * jacobian).sum())
    }

    /// The sum of `g_i g_i^T`; `None` if a line alone determines a combination of parameters.
    fn scatter(&self, parameters: &Parameters, inverse: &Matrix5<f64>) -> Option<Matrix5<f64>> {
        let (cylinder, tangents) = (parameters.cylinder(), parameters.tangents());
        let mut sum = Matrix5::zeros();
        for line in &self.lines {
            let distance = line.distance(&cylinder)?;
            let derivatives = line.derivatives(&cylinder, &distance, &tangents);
            let (_, weight) = self.loss.value_and_weight(distance.mean_square());
            let jacobian = SMatrix::<f64, 2, 5>::from_columns(&derivatives);
            let leverage = jacobian * inverse * jacobian.transpose() * weight;
            let residual = (Matrix2::identity() - leverage).try_inverse()? * distance.distances;
            let gradient = jacobian.tr_mul(&residual) * weight;
            sum += gradient * gradient.transpose();
        }
        Some(sum)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::observations::view::{Calibration, Camera, View};
    use crate::space::silhouette_distance::Metric;
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
}
