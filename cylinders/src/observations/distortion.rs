//! Lens distortion bends straight lines. It is removed before lines are fitted.
//!
//! The polynomial model of COLMAP's `OPENCV` camera, of which `SIMPLE_RADIAL` and `RADIAL` are
//! special cases. An ideal point `(u, v)` in normalised image coordinates, `s = u^2 + v^2`, is seen
//! at
//!
//! ```text
//!   u (1 + k1 s + k2 s^2) + 2 p1 u v + p2 (s + 2 u^2)
//!   v (1 + k1 s + k2 s^2) + 2 p2 u v + p1 (s + 2 v^2)
//! ```

use nalgebra::{Matrix2, Point2, Vector2};

/// Newton steps; four or five suffice inside any image.
const MAX_STEPS: usize = 50;

/// A step is the last one if it is at most this, relative to the larger of one and the point.
const LAST_STEP: f64 = 1e-15;

/// Radial and tangential polynomial distortion.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Distortion {
    /// Radial coefficients `k1`, `k2`.
    pub radial: [f64; 2],
    /// Tangential coefficients `p1`, `p2`.
    pub tangential: [f64; 2],
}

impl Distortion {
    /// Whether the distortion moves no point.
    pub fn is_none(&self) -> bool {
        *self == Self::default()
    }

    /// The point at which an ideal point is seen; normalised image coordinates.
    pub fn distort(&self, ideal: &Point2<f64>) -> Point2<f64> {
        let ([k1, k2], [p1, p2]) = (self.radial, self.tangential);
        let (u, v) = (ideal.x, ideal.y);
        let s = u * u + v * v;
        let radial = 1.0 + s * (k1 + s * k2);
        Point2::new(
            u * radial + 2.0 * p1 * u * v + p2 * (s + 2.0 * u * u),
            v * radial + 2.0 * p2 * u * v + p1 * (s + 2.0 * v * v),
        )
    }

    /// The ideal point that is seen at `seen`; normalised image coordinates. `None` if there is no
    /// such point: a polynomial with a negative coefficient folds the plane back at some distance
    /// from the centre, and no point is seen beyond the fold.
    pub fn undistort(&self, seen: &Point2<f64>) -> Option<Point2<f64>> {
        let mut ideal = *seen;
        for _ in 0..MAX_STEPS {
            let step = self.jacobian(&ideal).try_inverse()? * (self.distort(&ideal) - seen);
            ideal -= step;
            if step.norm() <= LAST_STEP * ideal.coords.norm().max(1.0) {
                return self.is_before_fold(&ideal).then_some(ideal);
            }
        }
        None
    }

    /// Derivative of [`Distortion::distort`].
    fn jacobian(&self, ideal: &Point2<f64>) -> Matrix2<f64> {
        let ([k1, k2], [p1, p2]) = (self.radial, self.tangential);
        let (u, v) = (ideal.x, ideal.y);
        let s = u * u + v * v;
        let radial = 1.0 + s * (k1 + s * k2);
        // Twice the derivative of `radial` with respect to `s`.
        let growth = 2.0 * (k1 + 2.0 * s * k2);
        let mixed = growth * u * v + 2.0 * (p1 * u + p2 * v);
        Matrix2::new(
            radial + growth * u * u + 2.0 * p1 * v + 6.0 * p2 * u,
            mixed,
            mixed,
            radial + growth * v * v + 2.0 * p2 * u + 6.0 * p1 * v,
        )
    }

    /// Whether the point lies before the fold. The distance from the centre must grow all the way
    /// to the point, so `1 + 3 k1 s + 5 k2 s^2 > 0` at both ends and at its minimum between them,
    /// and the orientation of the plane must be kept at the point.
    fn is_before_fold(&self, ideal: &Point2<f64>) -> bool {
        let [k1, k2] = self.radial;
        let s = ideal.coords.norm_squared();
        let growth = |s: f64| 1.0 + s * (3.0 * k1 + s * 5.0 * k2);
        let lowest = Vector2::new(-0.3 * k1 / k2, s);
        let between = lowest.x > 0.0 && lowest.x < s && k2 > 0.0;
        growth(s) > 0.0 && (!between || growth(lowest.x) > 0.0) && self.jacobian(ideal).determinant() > 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LENS: Distortion = Distortion { radial: [-0.21, 0.07], tangential: [0.003, -0.002] };

    #[test]
    fn undistorted_points_are_seen_where_they_were() {
        for row in -10..=10 {
            for column in -10..=10 {
                let ideal = Point2::new(f64::from(column), f64::from(row)) / 10.0;
                let found = LENS.undistort(&LENS.distort(&ideal)).expect("inside the image");
                assert!((found - ideal).norm() < 1e-13, "{ideal} {found}");
            }
        }
    }

    #[test]
    fn the_jacobian_is_the_derivative() {
        let (at, step) = (Point2::new(0.4, -0.7), 1e-6);
        for (axis, column) in [Vector2::x(), Vector2::y()].iter().zip(LENS.jacobian(&at).column_iter()) {
            let difference = LENS.distort(&(at + axis * step)) - LENS.distort(&(at - axis * step));
            assert!((difference / (2.0 * step) - column).norm() < 1e-9);
        }
    }

    #[test]
    fn nothing_is_seen_beyond_the_fold() {
        // r - r^3 / 3 has its maximum 2 / 3 at r = 1 and decreases to zero at r = sqrt(3).
        let barrel = Distortion { radial: [-1.0 / 3.0, 0.0], ..Distortion::default() };
        let before = barrel.undistort(&Point2::new(0.6, 0.0)).expect("before the fold");
        assert!(before.x < 1.0 && (barrel.distort(&before).x - 0.6).abs() < 1e-14);
        for seen in [0.67, 1.0, 3.0, f64::NAN, f64::INFINITY] {
            assert_eq!(barrel.undistort(&Point2::new(seen, 0.0)), None, "{seen}");
        }
        // With a positive second coefficient it grows again. Solutions beyond both folds do not
        // count.
        let wave = Distortion { radial: [-0.9, 0.2], ..Distortion::default() };
        let beyond = Point2::new(2.0, 0.0);
        assert!(wave.jacobian(&beyond).determinant() > 0.0);
        assert!(!wave.is_before_fold(&beyond));
    }
}
