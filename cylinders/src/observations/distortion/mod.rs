//! Lens distortion bends straight lines. It is removed before lines are fitted.
//!
//! An ideal point `(u, v)` in normalised image coordinates is seen at another one. The models are
//! those of COLMAP (<https://colmap.github.io/cameras.html>); with `r^2 = u^2 + v^2`:
//!
//! ```text
//!   projection (u, v) ->
//!     Perspective      (u, v)
//!     Equidistant      (u, v) atan(r) / r: the angle to the optical axis in place of its tangent
//!     FieldOfView      (u, v) atan(2 r tan(omega / 2)) / (omega r)
//!     Division         the (a, b) for which (u, v) = (a, b) / (1 + k (a^2 + b^2))
//!     Unified          (u, v) / (alpha sqrt(beta r^2 + 1) + 1 - alpha)
//!   then the polynomial of `polynomial.rs`
//! ```

/// Polynomials of the plane and their inverse.
mod polynomial;
/// Whether a polynomial is positive on an interval.
mod positive;

use std::f64::consts::{FRAC_PI_2, PI};

use nalgebra::Point2;

use polynomial::Polynomial;

/// Below this angle, radians, the model `FOV` is a lens without distortion.
const SMALLEST_OMEGA: f64 = 1e-4;

/// How a lens bends lines: a projection, and a polynomial of its image. Points at 90 degrees or
/// more from the optical axis have no ideal point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Distortion {
    /// From ideal points to the plane in which the polynomial acts.
    pub projection: Projection,
    /// Radial coefficients `k1` .. `k6` of the numerator.
    pub radial: [f64; 6],
    /// Radial coefficients of the denominator: `k4` .. `k6` of OpenCV.
    pub denominator: [f64; 3],
    /// Tangential coefficients `p1`, `p2`.
    pub tangential: [f64; 2],
    /// Thin prism coefficients: of `s` and `s^2` in the first coordinate, then in the second.
    pub prism: [f64; 4],
    /// Whether tangential and thin prism distortion act on points that are radially distorted
    /// before, as in `RAD_TAN_THIN_PRISM_FISHEYE`; otherwise all parts act on the same point.
    pub radial_first: bool,
}

/// Where a lens without polynomial distortion shows an ideal point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Projection {
    /// At itself.
    #[default]
    Perspective,
    /// At a distance from the centre that is the angle to the optical axis: the models with
    /// `FISHEYE` in their name.
    Equidistant,
    /// Devernay and Faugeras, "Straight lines have to be straight" (2001): `FOV`, with the angle
    /// omega, radians.
    FieldOfView(f64),
    /// Fitzgibbon, "Simultaneous linear estimation of multiple view geometry and lens distortion"
    /// (2001): `DIVISION`, with its coefficient.
    Division(f64),
    /// Khomutenko, Garcia and Martinet, "An enhanced unified camera model" (2016): `EUCM`, with
    /// alpha and beta.
    Unified(f64, f64),
}

impl Projection {
    fn project(self, ideal: &Point2<f64>) -> Point2<f64> {
        let r = ideal.coords.norm();
        match self {
            Self::FieldOfView(omega) if omega.abs() >= SMALLEST_OMEGA => {
                ideal * ratio((2.0 * r * (omega / 2.0).tan()).atan() / omega, r)
            }
            Self::Perspective | Self::FieldOfView(_) => *ideal,
            Self::Equidistant => ideal * ratio(r.atan(), r),
            // The smaller root of k r R^2 - R + r = 0, written so that nothing cancels.
            Self::Division(k) => ideal * (2.0 / (1.0 + (1.0 - 4.0 * k * r * r).sqrt())),
            Self::Unified(alpha, beta) => ideal / (alpha * (beta * r * r + 1.0).sqrt() + 1.0 - alpha),
        }
    }

    fn unproject(self, seen: &Point2<f64>) -> Option<Point2<f64>> {
        let r = seen.coords.norm();
        match self {
            Self::FieldOfView(omega) if omega.abs() >= SMALLEST_OMEGA => {
                let scale = 2.0 * (omega / 2.0).tan();
                (r * omega.abs() < FRAC_PI_2).then(|| seen * ratio((r * omega).tan() / scale, r))
            }
            Self::Perspective | Self::FieldOfView(_) => Some(*seen),
            Self::Equidistant => (r < FRAC_PI_2).then(|| seen * ratio(r.tan(), r)),
            Self::Division(k) => {
                let bend = k * r * r;
                (bend < 1.0 && 1.0 + bend > 0.0).then(|| seen / (1.0 + bend))
            }
            // The point (a, b) of the image is the ray (a, b, z) with
            // z = (1 - alpha^2 beta R^2) / (alpha sqrt(1 - (2 alpha - 1) beta R^2) + 1 - alpha).
            Self::Unified(alpha, beta) => {
                let square = beta * r * r;
                let root = 1.0 - (2.0 * alpha - 1.0) * square;
                let z = (1.0 - alpha * alpha * square) / (alpha * root.max(0.0).sqrt() + 1.0 - alpha);
                (root >= 0.0 && z > 0.0).then(|| seen / z)
            }
        }
    }

    fn is_defined(self) -> bool {
        match self {
            Self::Perspective | Self::Equidistant => true,
            Self::FieldOfView(omega) => omega.abs() < PI,
            Self::Division(k) => k.is_finite(),
            Self::Unified(alpha, beta) => (0.0..=1.0).contains(&alpha) && beta > 0.0 && beta.is_finite(),
        }
    }
}

impl Distortion {
    /// Radial coefficients `k1`, `k2` and tangential ones `p1`, `p2`: the model `OPENCV`.
    pub fn polynomial([k1, k2]: [f64; 2], tangential: [f64; 2]) -> Self {
        Self { radial: [k1, k2, 0.0, 0.0, 0.0, 0.0], tangential, ..Self::default() }
    }

    /// Whether the distortion moves no point.
    pub fn is_none(&self) -> bool {
        *self == Self { radial_first: self.radial_first, ..Self::default() }
    }

    /// Whether all coefficients are finite and in the range in which the model is defined.
    pub fn is_defined(&self) -> bool {
        let [radial, denominator, tangential, prism]: [&[f64]; 4] =
            [&self.radial, &self.denominator, &self.tangential, &self.prism];
        let mut coefficients = [radial, denominator, tangential, prism].into_iter().flatten();
        coefficients.all(|coefficient| coefficient.is_finite()) && self.projection.is_defined()
    }

    /// The point at which an ideal point is seen; normalised image coordinates. NaN if the lens
    /// shows the ideal point nowhere.
    pub fn distort(&self, ideal: &Point2<f64>) -> Point2<f64> {
        self.plane().value(&self.projection.project(ideal))
    }

    /// The ideal point that is seen at `seen`; normalised image coordinates. `None` if there is no
    /// such point: many models fold the plane back at some distance from the centre, and no point
    /// is seen beyond the fold. Nor is there one for lines of sight that do not point forward.
    pub fn undistort(&self, seen: &Point2<f64>) -> Option<Point2<f64>> {
        let ideal = self.projection.unproject(&self.plane().inverse(seen)?)?;
        ideal.coords.iter().all(|coordinate| coordinate.is_finite()).then_some(ideal)
    }

    fn plane(&self) -> Polynomial {
        let Self { radial, denominator, tangential, prism, radial_first, .. } = *self;
        Polynomial { radial, denominator, tangential, prism, radial_first }
    }
}

/// `value / r`; one at the centre.
fn ratio(value: f64, r: f64) -> f64 {
    if r > 0.0 { value / r } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_seen_beyond_the_fold() {
        // r - r^3 / 3 has its maximum 2 / 3 at r = 1 and decreases to zero at r = sqrt(3).
        let barrel = Distortion::polynomial([-1.0 / 3.0, 0.0], [0.0; 2]);
        let before = barrel.undistort(&Point2::new(0.6, 0.0)).expect("before the fold");
        assert!(before.x < 1.0 && (barrel.distort(&before).x - 0.6).abs() < 1e-14);
        for seen in [0.67, 1.0, 3.0, f64::NAN, f64::INFINITY] {
            assert_eq!(barrel.undistort(&Point2::new(seen, 0.0)), None, "{seen}");
        }
    }

    #[test]
    fn a_fisheye_sees_90_degrees_nowhere() {
        let lens = Distortion { projection: Projection::Equidistant, ..Distortion::default() };
        assert!(lens.undistort(&Point2::new(1.57, 0.0)).is_some_and(|ideal| ideal.x > 1000.0));
        assert_eq!(lens.undistort(&Point2::new(FRAC_PI_2, 0.0)), None);
    }
}
