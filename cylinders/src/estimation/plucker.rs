//! A line in space in the orthonormal form of its Plücker coordinates: four parameters without
//! constraints (Bartoli & Sturm, "Structure-from-motion using lines: representation, triangulation,
//! and bundle adjustment", 2005, section 4).
//!
//! A line with direction `w` through `A` has the Plücker coordinates `(m, w)`, `m = A x w`. For the
//! unit direction and the point `A` nearest to the origin
//!
//! ```text
//!   U = [ m/|m|  w  m/|m| x w ] in SO(3),    tan(phi) = |m|,    w = u2,    A = -tan(phi) u3
//! ```
//!
//! and a step is `U <- U exp([theta]_x)`, `phi <- phi + theta_4`. A line through the origin has no
//! moment, hence no `U`. The caller chooses the origin beside the line, best at a distance of one.

use nalgebra::{Matrix3, Rotation3, Unit, Vector3};

/// `(U, phi)`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OrthonormalLine {
    frame: Matrix3<f64>,
    angle: f64,
}

impl OrthonormalLine {
    /// The line along `direction` whose point nearest to the origin is `nearest`, which must not be
    /// the origin itself.
    pub(crate) fn new(nearest: &Vector3<f64>, direction: &Unit<Vector3<f64>>) -> Self {
        let w = direction.into_inner();
        let third = -nearest.normalize();
        Self { frame: Matrix3::from_columns(&[w.cross(&third), w, third]), angle: nearest.norm().atan() }
    }

    /// Unit direction `w`.
    pub(crate) fn direction(&self) -> Vector3<f64> {
        self.frame.column(1).into_owned()
    }

    /// The point `A` nearest to the origin.
    pub(crate) fn nearest(&self) -> Vector3<f64> {
        self.frame.column(2) * -self.angle.tan()
    }

    /// The frame `(u1, u3)` across the line.
    pub(crate) fn across(&self) -> [Vector3<f64>; 2] {
        [self.frame.column(0).into_owned(), self.frame.column(2).into_owned()]
    }

    /// Derivatives `(dw, dA)` by `theta_1` to `theta_4` at `theta = 0`.
    pub(crate) fn tangents(&self) -> [(Vector3<f64>, Vector3<f64>); 4] {
        let [u1, u2, u3] = [0, 1, 2].map(|column| self.frame.column(column).into_owned());
        let (sine, cosine) = self.angle.sin_cos();
        let distance = sine / cosine;
        [
            (u3, u2 * distance),
            (Vector3::zeros(), u1 * -distance),
            (-u1, Vector3::zeros()),
            (Vector3::zeros(), u3 / -(cosine * cosine)),
        ]
    }

    /// A step `theta`.
    pub(crate) fn moved(&self, step: &[f64; 4]) -> Self {
        let turn = Rotation3::new(Vector3::new(step[0], step[1], step[2]));
        let mut frame = self.frame * turn.matrix();
        // The frame is made orthonormal again, so that rounding does not add up over many steps.
        let w = frame.column(1).normalize();
        let third = frame.column(2) - w * w.dot(&frame.column(2));
        let third = third.normalize();
        frame.set_column(0, &w.cross(&third));
        frame.set_column(1, &w);
        frame.set_column(2, &third);
        Self { frame, angle: self.angle + step[3] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn example() -> OrthonormalLine {
        let direction = Unit::new_normalize(Vector3::new(0.3, -0.8, 0.5));
        let point = Vector3::new(1.0, 0.4, -0.7);
        OrthonormalLine::new(&(point - direction.into_inner() * direction.dot(&point)), &direction)
    }

    #[test]
    fn direction_and_nearest_point_come_back() {
        let direction = Unit::new_normalize(Vector3::new(0.3, -0.8, 0.5));
        let line = example();
        assert!((line.direction() - direction.into_inner()).norm() < 1e-15);
        assert!(line.nearest().dot(&direction).abs() < 1e-15);
        assert!((Vector3::new(1.0, 0.4, -0.7) - line.nearest()).cross(&direction).norm() < 1e-15);
        assert!((line.frame.determinant() - 1.0).abs() < 1e-15);
    }

    #[test]
    fn tangents_are_the_derivatives() {
        let (line, step) = (example(), 1e-6);
        for (index, (direction, nearest)) in line.tangents().into_iter().enumerate() {
            let moved = |sign: f64| {
                let mut theta = [0.0; 4];
                theta[index] = sign * step;
                line.moved(&theta)
            };
            let (ahead, behind) = (moved(1.0), moved(-1.0));
            assert!(((ahead.direction() - behind.direction()) / (2.0 * step) - direction).norm() < 1e-9, "{index}");
            assert!(((ahead.nearest() - behind.nearest()) / (2.0 * step) - nearest).norm() < 1e-9, "{index}");
        }
    }
}
