//! The dual conic by linear least squares, without the constraints of a circle: the first baseline
//! of Gummeson & Oskarsson, "Robust and Accurate Cylinder Triangulation".
//!
//! `l^T C* l` is linear in the six entries of `C*`. Among all conics of unit norm, its weighted sum
//! of squares over the lines is least for the right singular vector of the smallest singular value
//! of the matrix with the rows
//!
//! ```text
//!   sqrt(w) (a^2, sqrt2 a b, sqrt2 a c, b^2, sqrt2 b c, c^2)
//!   unknowns (d1, sqrt2 d2, sqrt2 d3, d4, sqrt2 d5, d6)
//! ```
//!
//! The implementation departs from the paper in two points, so that the result does not depend on
//! the choice of coordinates. The plane is first shifted and scaled (the point nearest to all
//! lines, their mean square distance), and the norm is the Frobenius norm of the matrix `C*`, hence
//! the square roots. Noise can make the conic an ellipse of any shape, a hyperbola, or a conic
//! without real points; its [`crate::SectionShape`] says which.

use nalgebra::{DMatrix, Matrix2, Matrix3};

use super::normalise::Normalisation;
use super::section::{
    Section, SectionError, SectionLine, SectionShape, SectionSolver, check_lines, weighted_mean_square,
};

/// More than one conic fits exactly if the second smallest singular value, relative to the largest,
/// is at most this.
const NOT_UNIQUE: f64 = 1e-13;

/// The centre of a conic of unit norm counts as infinite if its entry `d6` is at most this.
const INFINITE: f64 = 1e-12;

/// Limit on the iterations of the singular value decomposition. Six columns need about twenty.
const SVD_ITERATIONS: usize = 500;

/// The method `linear`: one conic of any shape.
#[derive(Clone, Copy, Debug, Default)]
pub struct LinearConic;

impl SectionSolver for LinearConic {
    fn name(&self) -> &'static str {
        "linear"
    }

    fn least_lines(&self) -> usize {
        5
    }

    fn solve(&self, lines: &[SectionLine]) -> Result<Vec<Section>, SectionError> {
        check_lines(lines, self.least_lines())?;
        let normalisation = Normalisation::of(lines)?;
        let normalised = dual_conic(&normalisation.lines(lines))?;
        let dual_conic = normalisation.dual_conic(&normalised);
        // The shape is judged in normalised coordinates, because the semi-axes carry the unit of
        // length.
        let shape = match central_shape(&normalised) {
            SectionShape::Ellipse { semi_axes } => {
                SectionShape::Ellipse { semi_axes: semi_axes.map(|axis| axis * normalisation.scale) }
            }
            shape => shape,
        };
        let residual = |line: &super::rectify::TangentLine| {
            let line = normalisation.line(line);
            let line = line.normal.push(line.offset);
            line.dot(&(normalised * line)) * normalisation.scale * normalisation.scale
        };
        Ok(vec![Section { dual_conic, shape, cost: weighted_mean_square(lines, residual) }])
    }
}

/// The dual conic of least squares, scaled so that `d6 = -1`.
fn dual_conic(lines: &[SectionLine]) -> Result<Matrix3<f64>, SectionError> {
    // The matrix has at least six rows, so that there is a singular vector for the null space of
    // five lines.
    let mut matrix = DMatrix::zeros(lines.len().max(6), 6);
    for (row, SectionLine { line, weight, .. }) in lines.iter().enumerate() {
        let (a, b, c) = (line.normal.x, line.normal.y, line.offset);
        let cross = std::f64::consts::SQRT_2;
        let entries = [a * a, cross * a * b, cross * a * c, b * b, cross * b * c, c * c];
        for (column, entry) in entries.into_iter().enumerate() {
            matrix[(row, column)] = weight.sqrt() * entry;
        }
    }
    let svd = matrix.try_svd(false, true, f64::EPSILON, SVD_ITERATIONS).ok_or(SectionError::NoDecomposition)?;
    let (Some(right), [first, .., fifth, _]) = (&svd.v_t, svd.singular_values.as_slice()) else {
        return Err(SectionError::NoDecomposition);
    };
    if *fifth <= NOT_UNIQUE * first {
        return Err(SectionError::NotUnique);
    }
    let d: [f64; 6] = std::array::from_fn(|column| right[(5, column)]);
    if d[5].abs() <= INFINITE {
        return Err(SectionError::CentreAtInfinity);
    }
    let cross = std::f64::consts::FRAC_1_SQRT_2 / -d[5];
    let [d1, d4] = [d[0] / -d[5], d[3] / -d[5]];
    let [d2, d3, d5] = [d[1] * cross, d[2] * cross, d[4] * cross];
    Ok(Matrix3::new(d1, d2, d3, d2, d4, d5, d3, d5, -1.0))
}

/// Kind of the conic by the eigenvalues of the matrix `M` of the module `section`; never
/// [`SectionShape::Circle`].
fn central_shape(dual_conic: &Matrix3<f64>) -> SectionShape {
    let centre = dual_conic.fixed_view::<2, 1>(0, 2);
    let matrix: Matrix2<f64> = dual_conic.fixed_view::<2, 2>(0, 0) + centre * centre.transpose();
    let half_sum = matrix.trace() / 2.0;
    let large = half_sum + ((matrix[(0, 0)] - matrix[(1, 1)]) / 2.0).hypot(matrix[(0, 1)]).copysign(half_sum);
    // If the semi-axes differ much, this is a difference of products, which rounding limits.
    let small = matrix.determinant() / large;
    if small.is_nan() || small.abs() <= f64::EPSILON * large.abs() {
        SectionShape::Degenerate
    } else if small * large < 0.0 {
        SectionShape::Hyperbola
    } else if large < 0.0 {
        SectionShape::Imaginary
    } else {
        SectionShape::Ellipse { semi_axes: [large.sqrt(), small.sqrt()] }
    }
}
