//! The uncertainty of cylinders that were refined, each by itself or several together.
//!
//! If all lines have end points, the distances of the points are independent with one variance, and
//! the covariance is `sigma^2 (J^T W J)^-1`. Without end points it is not known where a line was
//! seen, nor therefore how the errors of its two support points are related. The covariance then
//! follows from the scatter of the lines, whatever it is (the sandwich estimate with the leverages
//! of each line taken out; MacKinnon & White, "Some heteroskedasticity-consistent covariance matrix
//! estimators", 1985, HC3). Few lines have a common scatter instead:
//!
//! ```text
//!   H^-1 (sum_i g_i g_i^T) H^-1,    g_i = J_i^T W_i (I - J_i H^-1 J_i^T W_i)^-1 e_i
//! ```

use nalgebra::{DMatrix, DVector, Matrix2, Matrix5, SMatrix};

use super::refine_error::RefineError;
use super::silhouette_cost::{PARAMETERS, SilhouetteCost, tangents};
use crate::numerics::levenberg_marquardt::LeastSquares;
use crate::space::cylinder::Cylinder;
use crate::space::silhouette_distance::MeasuredLine;

/// The cylinders are not determined if the smallest eigenvalue of the normal matrix, with its
/// diagonal scaled to one, is at most this: some combination of parameters has less than a
/// millionth of the influence of each alone.
const UNDETERMINED: f64 = 1e-12;

/// Limit on the iterations for the eigenvalues.
const EIGEN_ITERATIONS: usize = 1000;

/// The scatter of fewer lines for each parameter is taken as the same for all.
const ENOUGH_LINES: usize = 4;

/// A cylinder at the optimum, its cost, and the place of each of its local parameters among those
/// of all cylinders; `None` for one that is known.
pub(super) struct Block<'a> {
    pub(super) cost: &'a SilhouetteCost,
    pub(super) cylinder: &'a Cylinder,
    pub(super) places: [Option<usize>; PARAMETERS],
}

/// The uncertainty of the parameters of all cylinders.
pub(super) struct Uncertainty {
    pub(super) covariance: DMatrix<f64>,
    pub(super) noise: f64,
    pub(super) degrees_of_freedom: f64,
}

impl Uncertainty {
    /// Of this number of parameters.
    pub(super) fn of(blocks: &[Block<'_>], parameters: usize) -> Result<Self, RefineError> {
        let mut normal_matrix = DMatrix::zeros(parameters, parameters);
        for block in blocks {
            // The matrix of the cost is J^T W J / 2.
            block.add(&mut normal_matrix, &(block.cost.linearise(block.cylinder)?.normal_matrix * 2.0));
        }
        let inverse = inverse(&normal_matrix)?;
        let (mut squares, mut count) = (0.0, 0.0);
        for block in blocks {
            for distance in block.cost.lines.iter().filter_map(|line| line.distance(block.cylinder)) {
                let (_, weight) = block.cost.loss.value_and_weight(distance.mean_square());
                squares += weight * distance.distances.norm_squared();
                count += 2.0 * weight;
            }
            for (weight, distance, _) in block.cost.distances_of_points(block.cylinder) {
                squares += weight * distance * distance;
            }
            count += block.cost.points.iter().map(|point| point.share).sum::<f64>();
        }
        // The loss may reduce the effective number of lines below the number of parameters.
        let degrees_of_freedom = count - parameters as f64;
        if degrees_of_freedom <= 0.0 {
            return Err(RefineError::NotDetermined);
        }
        let variance = squares / degrees_of_freedom;
        let covariance = match scatter(blocks, &inverse) {
            Some(mut scatter) => {
                blocks.iter().for_each(|block| block.add(&mut scatter, &(block.of_points() * variance)));
                &inverse * scatter * &inverse
            }
            None => inverse * variance,
        };
        Ok(Self { covariance, noise: variance.sqrt(), degrees_of_freedom })
    }
}

/// The inverse of a normal matrix. Its diagonal is scaled to one, so that the test of the rank does
/// not depend on units.
fn inverse(normal_matrix: &DMatrix<f64>) -> Result<DMatrix<f64>, RefineError> {
    let size = normal_matrix.nrows();
    let scale: DVector<f64> = normal_matrix.diagonal().map(|entry| 1.0 / entry.sqrt());
    let scaled = DMatrix::from_fn(size, size, |row, column| normal_matrix[(row, column)] * scale[row] * scale[column]);
    let eigen = scaled.clone().try_symmetric_eigen(f64::EPSILON, EIGEN_ITERATIONS).ok_or(RefineError::NotDetermined)?;
    let determined = eigen.eigenvalues.iter().all(|&value| value > UNDETERMINED);
    let inverse = scaled.cholesky().filter(|_| determined).ok_or(RefineError::NotDetermined)?.inverse();
    Ok(DMatrix::from_fn(size, size, |row, column| inverse[(row, column)] * scale[row] * scale[column]))
}

/// The scatter of the lines of all cylinders; `None` if all have end points, or a line alone
/// determines a combination of parameters.
fn scatter(blocks: &[Block<'_>], inverse: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let lines = || blocks.iter().flat_map(|block| &block.cost.lines);
    if lines().all(|line| line.has_ends) {
        return None;
    }
    let mut sum = DMatrix::zeros(inverse.nrows(), inverse.ncols());
    if lines().count() >= ENOUGH_LINES * inverse.nrows() {
        for block in blocks {
            block.add(&mut sum, &block.scatter(&block.part(inverse))?);
        }
    } else {
        let squares: Matrix2<f64> = blocks.iter().map(Block::squares).sum::<Option<_>>()?;
        let freedom = lines().count() as f64 - inverse.nrows() as f64 / 2.0;
        for block in blocks {
            block.add(&mut sum, &block.common_scatter(&(squares / freedom))?);
        }
    }
    Some(sum)
}

impl Block<'_> {
    /// Adds a matrix of the local parameters at the places of these.
    fn add(&self, sum: &mut DMatrix<f64>, local: &Matrix5<f64>) {
        for (row, row_place) in self.places.iter().enumerate() {
            for (column, column_place) in self.places.iter().enumerate() {
                if let (Some(row_place), Some(column_place)) = (*row_place, *column_place) {
                    sum[(row_place, column_place)] += local[(row, column)];
                }
            }
        }
    }

    /// The part of a matrix of all parameters that concerns the local ones; zero for known ones.
    pub(super) fn part(&self, of_all: &DMatrix<f64>) -> Matrix5<f64> {
        Matrix5::from_fn(|row, column| match (self.places[row], self.places[column]) {
            (Some(row), Some(column)) => of_all[(row, column)],
            _ => 0.0,
        })
    }

    /// The part of the points in the normal matrix.
    fn of_points(&self) -> Matrix5<f64> {
        let of_points = self.cost.distances_of_points(self.cylinder);
        of_points.map(|(weight, _, derivatives)| derivatives * derivatives.transpose() * weight).sum()
    }

    /// Weighted distances and derivatives of each line; the support point that is further along the
    /// axis comes first.
    fn ordered(&self) -> Option<Vec<(SMatrix<f64, 2, 1>, SMatrix<f64, 2, PARAMETERS>)>> {
        let tangents = tangents(self.cylinder);
        let swap = Matrix2::new(0.0, 1.0, 1.0, 0.0);
        let of_line = |line: &MeasuredLine| {
            let distance = line.distance(self.cylinder)?;
            let derivatives = line.derivatives(self.cylinder, &distance, &tangents);
            let weight = self.cost.loss.value_and_weight(distance.mean_square()).1.sqrt();
            let order = if line.is_along(self.cylinder) { Matrix2::identity() } else { swap } * weight;
            Some((order * distance.distances, order * SMatrix::<f64, 2, PARAMETERS>::from_columns(&derivatives)))
        };
        self.cost.lines.iter().map(of_line).collect()
    }

    /// The sum of the products of the two distances of each line.
    fn squares(&self) -> Option<Matrix2<f64>> {
        Some(self.ordered()?.iter().map(|(distances, _)| distances * distances.transpose()).sum())
    }

    /// The sum of `J_i^T S J_i` with the covariance `S` of the two distances of any line.
    fn common_scatter(&self, covariance: &Matrix2<f64>) -> Option<Matrix5<f64>> {
        Some(self.ordered()?.iter().map(|(_, jacobian)| jacobian.transpose() * covariance * jacobian).sum())
    }

    /// The sum of `g_i g_i^T`; `None` if a line alone determines a combination of parameters.
    fn scatter(&self, inverse: &Matrix5<f64>) -> Option<Matrix5<f64>> {
        let mut sum = Matrix5::zeros();
        for (distances, jacobian) in self.ordered()? {
            let leverage = jacobian * inverse * jacobian.transpose();
            let residual = (Matrix2::identity() - leverage).try_inverse()? * distances;
            let gradient = jacobian.tr_mul(&residual);
            sum += gradient * gradient.transpose();
        }
        Some(sum)
    }
}
