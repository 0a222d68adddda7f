//! Radial, tangential and thin prism distortion of a plane, `s = u^2 + v^2`:
//!
//! ```text
//!   radial   R(u, v) = (u, v) (1 + k1 s + .. + k6 s^6) / (1 + d1 s + d2 s^2 + d3 s^3)
//!   bent     B(u, v) = ( 2 p1 u v + p2 (s + 2 u^2) + x1 s + x2 s^2,
//!                        2 p2 u v + p1 (s + 2 v^2) + y1 s + y2 s^2 )
//! ```
//!
//! The point is seen at `R(u, v) + B(u, v)`, or with `radial_first` at `R + B(R)`.

use nalgebra::{Matrix2, Point2, RowVector2, Vector2};

use super::positive::is_positive;

/// Newton steps; four or five suffice inside any image.
const MAX_STEPS: usize = 50;

/// A step is the last one if it is at most this, relative to the larger of one and the point.
const LAST_STEP: f64 = 1e-15;

/// After a step of at most this relative size, rounding ends the iteration if the next one is not
/// smaller.
const SMALL_STEP: f64 = 1e-9;

/// Largest distance from the seen point at the end, relative to the larger of one and the point.
const RESIDUAL: f64 = 1e-9;

/// Steps from the centre to a point at which Newton's method does not converge from the point
/// itself.
const STAGES: usize = 32;

/// Coefficients of the numerator of the radial factor, the constant included.
const NUMERATOR: usize = 7;
/// Coefficients of its denominator, the constant included.
const DENOMINATOR: usize = 4;

/// Coefficients of the distortion of a plane; all zero means none.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Polynomial {
    /// `k1` .. `k6`
    pub(super) radial: [f64; 6],
    /// `d1` .. `d3`
    pub(super) denominator: [f64; 3],
    /// `p1`, `p2`
    pub(super) tangential: [f64; 2],
    /// `x1`, `x2`, `y1`, `y2`
    pub(super) prism: [f64; 4],
    /// Whether the bent part is evaluated at the radially distorted point.
    pub(super) radial_first: bool,
}

/// A value and its derivative.
type Mapped = (Point2<f64>, Matrix2<f64>);

impl Polynomial {
    fn is_identity(&self) -> bool {
        *self == Self { radial_first: self.radial_first, ..Self::default() }
    }

    /// Where a point is seen.
    pub(super) fn value(&self, ideal: &Point2<f64>) -> Point2<f64> {
        self.map(ideal).0
    }

    /// The point that is seen at `seen`: the one that a path from the centre reaches before the
    /// first fold. Newton's method starts at `seen`; where that leads to no point before the fold,
    /// it follows the segment from the centre to `seen`.
    pub(super) fn inverse(&self, seen: &Point2<f64>) -> Option<Point2<f64>> {
        if self.is_identity() {
            return Some(*seen);
        }
        let direct = self.newton(*seen, seen).filter(|ideal| self.is_before_fold(ideal));
        direct.or_else(|| {
            let mut ideal = Point2::origin();
            for stage in 1..=STAGES {
                ideal = self.newton(ideal, &(seen * (stage as f64 / STAGES as f64)))?;
            }
            self.is_before_fold(&ideal).then_some(ideal)
        })
    }

    fn newton(&self, start: Point2<f64>, seen: &Point2<f64>) -> Option<Point2<f64>> {
        let (mut ideal, mut last) = (start, f64::INFINITY);
        for _ in 0..MAX_STEPS {
            let (value, jacobian) = self.map(&ideal);
            let step = jacobian.try_inverse()? * (value - seen);
            ideal -= step;
            let size = step.norm() / ideal.coords.norm().max(1.0);
            if size <= LAST_STEP || (size <= SMALL_STEP && size >= last) {
                // Far away, where the derivative is huge, a step is small without being near.
                let residual = (self.map(&ideal).0 - seen).norm();
                return (residual <= RESIDUAL * seen.coords.norm().max(1.0)).then_some(ideal);
            }
            last = size;
        }
        None
    }

    fn map(&self, ideal: &Point2<f64>) -> Mapped {
        let (radial, radial_derivative) = self.radial_map(ideal);
        let (at, inner) = match self.radial_first {
            false => (*ideal, Matrix2::identity()),
            true => (radial, radial_derivative),
        };
        let (bent, bent_derivative) = self.bent_map(&at);
        (radial + bent, radial_derivative + bent_derivative * inner)
    }

    fn radial_map(&self, point: &Point2<f64>) -> Mapped {
        let s = point.coords.norm_squared();
        let (numerator, denominator) = (evaluate(&self.numerator(), s), evaluate(&self.denominator(), s));
        let factor = numerator[0] / denominator[0];
        let growth = (numerator[1] - factor * denominator[1]) / denominator[0];
        let outer = point.coords * point.coords.transpose();
        (point * factor, Matrix2::from_diagonal_element(factor) + outer * (2.0 * growth))
    }

    fn bent_map(&self, point: &Point2<f64>) -> (Vector2<f64>, Matrix2<f64>) {
        let ([p1, p2], [x1, x2, y1, y2]) = (self.tangential, self.prism);
        let (u, v) = (point.x, point.y);
        let s = u * u + v * v;
        let value = Vector2::new(
            2.0 * p1 * u * v + p2 * (s + 2.0 * u * u) + s * (x1 + s * x2),
            2.0 * p2 * u * v + p1 * (s + 2.0 * v * v) + s * (y1 + s * y2),
        );
        let mixed = 2.0 * (p1 * u + p2 * v);
        let tangential = Matrix2::new(2.0 * p1 * v + 6.0 * p2 * u, mixed, mixed, 2.0 * p2 * u + 6.0 * p1 * v);
        let prism = Vector2::new(x1 + 2.0 * s * x2, y1 + 2.0 * s * y2) * RowVector2::new(2.0 * u, 2.0 * v);
        (value, tangential + prism)
    }

    fn numerator(&self) -> [f64; NUMERATOR] {
        std::array::from_fn(|index| if index == 0 { 1.0 } else { self.radial[index - 1] })
    }

    fn denominator(&self) -> [f64; DENOMINATOR] {
        std::array::from_fn(|index| if index == 0 { 1.0 } else { self.denominator[index - 1] })
    }

    /// Whether the point lies before the fold. The distance `r N(s) / D(s)` from the centre must
    /// grow all the way to the point, so both `D` and `(N + 2 s N') D - 2 s N D'` must be positive
    /// up to it, and the orientation of the plane must be kept at the point.
    fn is_before_fold(&self, ideal: &Point2<f64>) -> bool {
        let s = ideal.coords.norm_squared();
        let (numerator, denominator) = (self.numerator(), self.denominator());
        let mut growth = [0.0; NUMERATOR + DENOMINATOR - 1];
        for (i, n) in numerator.iter().enumerate() {
            for (j, d) in denominator.iter().enumerate() {
                growth[i + j] += (1.0 + 2.0 * i as f64 - 2.0 * j as f64) * n * d;
            }
        }
        is_positive(&denominator, s) && is_positive(&growth, s) && self.map(ideal).1.determinant() > 0.0
    }
}

/// Value and derivative of a polynomial, by Horner's rule.
fn evaluate(coefficients: &[f64], s: f64) -> [f64; 2] {
    let next = |[value, slope]: [f64; 2], coefficient: &f64| [value * s + coefficient, slope * s + value];
    coefficients.iter().rev().fold([0.0; 2], next)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_jacobian_is_the_derivative() {
        let (at, step) = (Point2::new(0.4, -0.7), 1e-6);
        for radial_first in [false, true] {
            let lens = Polynomial {
                radial: [-0.21, 0.07, 0.01, -0.003, 0.002, 0.001],
                denominator: [0.02, -0.01, 0.004],
                tangential: [0.003, -0.002],
                prism: [0.002, -0.001, 0.0015, 0.0007],
                radial_first,
            };
            let jacobian = lens.map(&at).1;
            for (axis, column) in [Vector2::x(), Vector2::y()].iter().zip(jacobian.column_iter()) {
                let difference = lens.value(&(at + axis * step)) - lens.value(&(at - axis * step));
                assert!((difference / (2.0 * step) - column).norm() < 1e-9);
            }
        }
    }

    #[test]
    fn solutions_beyond_two_folds_do_not_count() {
        // With a positive second coefficient the distance grows again.
        let wave = Polynomial { radial: [-0.9, 0.2, 0.0, 0.0, 0.0, 0.0], ..Polynomial::default() };
        let beyond = Point2::new(2.0, 0.0);
        assert!(wave.map(&beyond).1.determinant() > 0.0);
        assert!(!wave.is_before_fold(&beyond));
    }
}
