//! The arithmetic of second attempts, at twice the precision of `f64`.

use qd::Quad;

use crate::expression::arithmetic::Arithmetic;
use crate::expression::rational::Rational;

/// Sums of two `f64`: about 31 digits.
#[derive(Clone, Copy, Debug)]
pub(super) struct Twice;

/// Sizes are those of the first part.
impl Arithmetic for Twice {
    type Value = Quad;

    fn constant(self, value: Rational) -> Option<Quad> {
        Some(exact(value.numerator()) / exact(value.denominator()))
    }
    fn add(self, a: Quad, b: Quad) -> Quad {
        a + b
    }
    fn sub(self, a: Quad, b: Quad) -> Quad {
        a - b
    }
    fn mul(self, a: Quad, b: Quad) -> Quad {
        a * b
    }
    fn div(self, a: Quad, b: Quad) -> Option<Quad> {
        (b.0 != 0.0).then(|| a / b)
    }
    fn pivot_size(self, a: Quad) -> f64 {
        a.0.abs()
    }
    fn rounding(self) -> f64 {
        f64::EPSILON * f64::EPSILON
    }
    fn zero(self) -> Quad {
        Quad::ZERO
    }
    fn one(self) -> Quad {
        Quad::ONE
    }
}

fn exact(integer: i64) -> Quad {
    let high = integer as f64;
    Quad(high, (i128::from(integer) - high as i128) as f64)
}

/// To `f64`.
pub(super) fn rounded(x: Quad) -> f64 {
    x.0 + x.1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn constants_have_all_their_digits() {
        let third = Twice.constant(Rational::new(1, 3).unwrap()).unwrap();
        assert!((third + third + third - Quad::ONE).0.abs() < 1e-31);
        let large = Twice.constant(Rational::new(i64::MAX, 1).unwrap()).unwrap();
        assert_eq!(large + Quad::ONE, Quad(9_223_372_036_854_775_808.0, 0.0));
    }
}
